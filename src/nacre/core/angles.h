#pragma once

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"

// Angles are in radians unless a name says otherwise (docs/conventions.md).

namespace nacre {

inline constexpr float kPiF = std::numbers::pi_v<float>;   ///< for single precision
inline constexpr double kDegree = std::numbers::pi / 180;  ///< in radians
inline constexpr double kHorizon = std::numbers::pi / 2;   ///< polar angle of the horizon

/// Of directions above a surface, from its outward normal.
inline constexpr Range kPolarAngleRange{0, 90, "deg", false, true};

/// The same direction in [0, 360).
inline double wrapped_deg(double degrees) {
    const double rest = std::fmod(degrees, 360);
    // A tiny negative angle would round to 360.
    return rest < 0 ? std::fmod(rest + 360, 360) : rest;
}

}  // namespace nacre
