#pragma once

#include <cmath>

// Only for tests.

namespace nacre::test {

/// The larger of two deviations, NaN if one of them is. Of a NaN std::max() would keep the other, and a
/// bound for the worst deviation would hold.
template <class T>
T worse(T worst, T value) {
    return std::isnan(worst) || value <= worst ? worst : value;
}

}  // namespace nacre::test
