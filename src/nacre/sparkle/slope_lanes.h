#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

#include "nacre/core/lane_math.h"
#include "nacre/optics/airy_lanes.h"

// Random bits of eight facets at a time, and the slopes that they stand for.

namespace nacre::sparkle {

using BitLanes = std::uint64_t __attribute__((vector_size(kLanes * sizeof(std::uint64_t))));

/// mix_bits() of each lane (core/rng.h).
inline BitLanes mix_lanes(BitLanes x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

inline constexpr double kLogLanesError = 2e-7;

/// Natural logarithm of x in [1e-37, 1e38], to kLogLanesError of the value and of 1: by the
/// exponent and the series of artanh((m - 1) / (m + 1)) for a mantissa m in [1/sqrt 2, sqrt 2).
/// [abramowitz-stegun-1964, eq. 4.1.27]
inline FloatLanes log_lanes(FloatLanes x) {
    using IntLanes = int __attribute__((vector_size(kLanes * sizeof(int))));
    constexpr int kRootHalf = 0x3f3504f3, kMantissa = 0x007fffff;
    const IntLanes bits = std::bit_cast<IntLanes>(x) - kRootHalf;
    const FloatLanes exponent = __builtin_convertvector(bits >> 23, FloatLanes);
    const FloatLanes m = std::bit_cast<FloatLanes>((bits & kMantissa) + kRootHalf);
    const FloatLanes s = (m - 1.0f) / (m + 1.0f), s2 = s * s;
    const FloatLanes series =
        2.0f + s2 * (2.0f / 3 + s2 * (2.0f / 5 + s2 * (2.0f / 7 + s2 * (2.0f / 9))));
    return exponent * std::numbers::ln2_v<float> + s * series;
}

struct SlopeLanes {
    FloatLanes x, y;
};

/// Two slopes of density exp(-x^2 - y^2) / pi, by Box and Muller's transform of the upper and the
/// lower half of each lane's bits; r^2 = -ln of the upper half as a share of 2^32, so that slopes
/// end at 4.74.                                                        [walter-2007, eq. 28-29]
inline SlopeLanes gaussian_slopes(BitLanes bits) {
    const FloatLanes share = (__builtin_convertvector(bits >> 32, FloatLanes) + 0.5f) * 0x1p-32f;
    const FloatLanes turns = __builtin_convertvector(bits & 0xffffffffu, FloatLanes) * 0x1p-32f;
    const FloatLanes r = sqrt_lanes(max_lanes(-log_lanes(share), FloatLanes{}));
    const auto wave = optics::cos_sin_turns(turns);
    return {r * wave.cosine, r * wave.sine};
}

}  // namespace nacre::sparkle
