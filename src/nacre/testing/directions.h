#pragma once

#include <array>
#include <cmath>

#include "nacre/core/angles.h"
#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"

// Only for tests: what surfaces are asked about.

namespace nacre::test {

/// On the grid of default_wavelengths_nm(), so that nothing is interpolated.
inline constexpr std::array<double, kLanes> kOnGrid{420, 460, 500, 540, 580, 620, 660, 690};

/// @param theta_deg  from the normal, z
/// @param phi_deg    about it, from x
inline Vec3f direction(double theta_deg, double phi_deg = 0) {
    const double s = std::sin(theta_deg * kDegree);
    return {static_cast<float>(s * std::cos(phi_deg * kDegree)),
            static_cast<float>(s * std::sin(phi_deg * kDegree)),
            static_cast<float>(std::cos(theta_deg * kDegree))};
}

}  // namespace nacre::test
