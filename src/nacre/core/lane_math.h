#pragma once

#include <bit>
#include <numbers>

#include "nacre/core/lanes.h"

// Elementary functions over lanes, branch-free.

namespace nacre {

/// e^x by 2^(n + f) with a degree-6 polynomial for 2^f on [-1/2, 1/2]; relative error below
/// kExpLanesError for x in [-87, 88], clamped outside (so e^-100 gives 1.6e-38, not 0).
inline FloatLanes exp_lanes(FloatLanes x) {
    using IntLanes = int __attribute__((vector_size(kLanes * sizeof(int))));
    x = min_lanes(max_lanes(x, splat(-87.0f)), splat(88.0f));
    const FloatLanes t = x * 1.44269504f;
    // Adding 1.5 2^23 rounds to an integer in the low bits of the mantissa.
    const FloatLanes shifted = t + 12582912.0f;
    const FloatLanes n = shifted - 12582912.0f;
    // ln 2 in two parts keeps the reduced argument exact.
    const FloatLanes r = (x - n * 0.693359375f) + n * 2.12194440e-4f;
    FloatLanes p = splat(1.0f / 720);
    p = p * r + 1.0f / 120;
    p = p * r + 1.0f / 24;
    p = p * r + 1.0f / 6;
    p = p * r + 0.5f;
    p = p * r + 1.0f;
    p = p * r + 1.0f;
    IntLanes bits;
    std::memcpy(&bits, &shifted, sizeof bits);
    IntLanes value;
    std::memcpy(&value, &p, sizeof value);
    value += bits << 23;
    FloatLanes result;
    std::memcpy(&result, &value, sizeof result);
    return result;
}

inline constexpr double kExpLanesError = 3e-7;

inline constexpr double kOneMinusExpLanesError = 1e-5;

/// 1 - e^-x for x >= 0, relative error below kOneMinusExpLanesError: by series where e^-x is
/// near 1.
inline FloatLanes one_minus_exp_lanes(FloatLanes x) {
    const FloatLanes series = x * (1.0f - x * (0.5f - x * (1.0f / 6 - x * (1.0f / 24))));
    const FloatLanes direct = 1.0f - exp_lanes(-x);
    return x < 0.05f ? series : direct;
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

}  // namespace nacre
