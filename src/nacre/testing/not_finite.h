#pragma once

#include <limits>

// Only for tests: what no quantity is, and every reader must refuse.

namespace nacre::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInf = std::numeric_limits<double>::infinity();

}  // namespace nacre::test
