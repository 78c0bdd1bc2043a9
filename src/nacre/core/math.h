#pragma once

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/vec.h"

// Angles are in radians unless a name says otherwise (docs/conventions.md).

namespace nacre {

constexpr double square(double x) { return x * x; }

inline constexpr float kPiF = std::numbers::pi_v<float>;   ///< for single precision
inline constexpr double kDegree = std::numbers::pi / 180;  ///< in radians
inline constexpr double kHorizon = std::numbers::pi / 2;   ///< polar angle of the horizon

/// Of directions above a surface, from its outward normal.
inline constexpr Range kPolarAngleRange{0, 90, "deg", false, true};

/// The same direction in [0, 360).
inline double wrapped_deg(double degrees) {
    const double remainder = std::fmod(degrees, 360);
    // A tiny negative angle would round to 360.
    return remainder < 0 ? std::fmod(remainder + 360, 360) : remainder;
}

/// The unit vector of a polar angle from z and an azimuth about it from x.
inline Vec3d polar_direction(double theta_deg, double phi_deg) {
    const double sine = std::sin(theta_deg * kDegree);
    return {sine * std::cos(phi_deg * kDegree), sine * std::sin(phi_deg * kDegree),
            std::cos(theta_deg * kDegree)};
}

}  // namespace nacre
