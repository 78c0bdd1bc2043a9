#pragma once

#include <numbers>

// Angles are in radians unless a name says otherwise (docs/conventions.md).

namespace nacre {

inline constexpr float kPiF = std::numbers::pi_v<float>;   ///< for single precision
inline constexpr double kDegree = std::numbers::pi / 180;  ///< in radians
inline constexpr double kHorizon = std::numbers::pi / 2;   ///< polar angle of the horizon

}  // namespace nacre
