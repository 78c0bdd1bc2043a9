#pragma once

#include <type_traits>

#include "nacre/core/lane_math.h"

// What the Airy reflectance needs of vector arithmetic: waves and decaying waves over lanes.

namespace nacre::optics {

/// Errors of the functions below, in the lanes' own precision: of the value for waves, relative for
/// decay.
template <class V>
inline constexpr double kAiryLanesError = std::is_same_v<V, FloatLanes> ? 4e-7 : 1e-15;

/// A lane's number type.
template <class V>
using LaneScalar = std::remove_cvref_t<decltype(V{}[0])>;

template <class V>
struct CosineSine {
    V cosine, sine;
};

/// Of magnitudes up to 2^22 in float, 2^51 in double.
template <class V>
inline V nearest_integer(V x) {
    // Adding 1.5 2^(mantissa bits - 1) rounds to an integer.
    constexpr LaneScalar<V> shift = std::is_same_v<V, FloatLanes> ? 0x1.8p23f : 0x1.8p52;
    return (x + shift) - shift;
}
/// cos and sin of 2 pi times `turns`, by rounding to the nearest half turn and Taylor's series on
/// [-pi/2, pi/2]; the sine keeps its relative accuracy near 0. Branch-free.
/// @param turns  magnitude below 2^21 for float, 2^50 for double; beyond, the phase is lost anyway
template <class V>
inline CosineSine<V> cos_sin_turns(V turns) {
    using Real = LaneScalar<V>;
    constexpr int terms = std::is_same_v<V, FloatLanes> ? 6 : 11;
    const V half_turns = nearest_integer(turns * Real(2));
    const V x = (turns - half_turns * Real(0.5)) * Real(6.283185307179586476925);
    const V x2 = x * x;
    V cosine = V{} + Real(1), sine = V{} + Real(1);
    for (int k = terms; k >= 1; --k) {
        cosine = Real(1) - cosine * x2 * Real(1.0 / ((2 * k) * (2 * k - 1)));
        sine = Real(1) - sine * x2 * Real(1.0 / ((2 * k) * (2 * k + 1)));
    }
    sine *= x;
    // An odd number of half turns reverses both.
    const V odd = half_turns - nearest_integer(half_turns * Real(0.5)) * Real(2);
    const V sign = Real(1) - Real(2) * odd * odd;
    return {sign * cosine, sign * sine};
}

/// e^-x and (1 - e^-x) / x for x >= 0, the latter without loss of digits near 0.
template <class V>
struct Decay {
    V left, mean;
};
template <class V>
inline Decay<V> decay(V x) {
    using Real = LaneScalar<V>;
    if constexpr (std::is_same_v<V, FloatLanes>) {
        const V left = exp_lanes(-x);
        V series = V{} + Real(1);
        for (int k = 7; k >= 2; --k) series = Real(1) - series * x * Real(1.0 / k);
        return {left, x < Real(0.5) ? series : (Real(1) - left) / max_lanes(x, V{} + Real(0.5))};
    } else {
        Decay<V> d;
        for (int i = 0; i < kLanes; ++i) {
            d.left[i] = std::exp(-x[i]);
            d.mean[i] = x[i] > 0 ? -std::expm1(-x[i]) / x[i] : 1;
        }
        return d;
    }
}

}  // namespace nacre::optics
