#pragma once

#include <cmath>
#include <numbers>

#include "nacre/core/vec.h"

// Maps from the unit square to other domains that keep areas, and so the evenness of a sampling
// pattern.

namespace nacre::bsdf {

/// From [0, 1)^2 to the unit disk, with constant density 1 / pi.       [shirley-1997-map, section
/// 3]
inline Vec2f concentric_disk(Vec2f u) {
    const float a = 2 * u.x - 1;
    const float b = 2 * u.y - 1;
    if (a == 0 && b == 0) return {0, 0};
    constexpr float kQuarterPi = std::numbers::pi_v<float> / 4;
    const bool wide = std::abs(a) > std::abs(b);
    const float r = wide ? a : b;
    const float angle = wide ? kQuarterPi * (b / a) : 2 * kQuarterPi - kQuarterPi * (a / b);
    return {r * std::cos(angle), r * std::sin(angle)};
}

/// From [0, 1)^2 to the upper hemisphere, with density cos(theta) / pi per solid angle.
inline Vec3f cosine_hemisphere(Vec2f u) {
    const Vec2f d = concentric_disk(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

}  // namespace nacre::bsdf
