#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "nacre/core/lanes.h"
#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/core/vec.h"

// Only for tests: what surfaces are asked about.

namespace nacre::test {

/// On the grid of default_wavelengths_nm(), so that nothing is interpolated.
inline constexpr std::array<double, kLanes> kOnGrid{420, 460, 500, 540, 580, 620, 660, 690};

/// @param theta_deg  from the normal, z
/// @param phi_deg    about it, from x
inline Vec3f direction(double theta_deg, double phi_deg = 0) {
    return to_float(polar_direction(theta_deg, phi_deg));
}

/// Evenly over the sphere.
inline Vec3f random_direction(Rng& rng) {
    const double z = 2 * rng.uniform_double() - 1,
                 phi = 2 * std::numbers::pi * rng.uniform_double();
    const double s = std::sqrt(1 - z * z);
    return to_float(Vec3d{s * std::cos(phi), s * std::sin(phi), z});
}

}  // namespace nacre::test
