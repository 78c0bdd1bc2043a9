#pragma once

#include <numbers>

// Angles are in radians unless a name says otherwise (docs/conventions.md).

namespace nacre {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180;  ///< in radians

}  // namespace nacre
