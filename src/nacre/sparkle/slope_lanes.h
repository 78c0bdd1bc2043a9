#pragma once

#include <cstdint>

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

struct SlopeLanes {
    FloatLanes x, y;
};

/// Two slopes of density exp(-x^2 - y^2) / pi, by Box and Muller's transform of two numbers even in
/// (0, 1): r^2 = -ln share.                                           [walter-2007, eq. 28-29]
inline SlopeLanes gaussian_slopes(FloatLanes share, FloatLanes turns) {
    const FloatLanes r = sqrt_lanes(max_lanes(-log_lanes(share), FloatLanes{}));
    const auto wave = optics::cos_sin_turns(turns);
    return {r * wave.cosine, r * wave.sine};
}

/// The same from the upper and the lower half of each lane's bits; slopes end at 4.74.
inline SlopeLanes gaussian_slopes(BitLanes bits) {
    return gaussian_slopes((__builtin_convertvector(bits >> 32, FloatLanes) + 0.5f) * 0x1p-32f,
                           __builtin_convertvector(bits & 0xffffffffu, FloatLanes) * 0x1p-32f);
}

}  // namespace nacre::sparkle
