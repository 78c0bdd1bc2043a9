#pragma once

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <type_traits>

#include "nacre/core/lanes.h"

// Elementary functions over lanes, branch-free.

namespace nacre {

/// e^x = 2^n e^r, |r| <= ln 2 / 2, with the Taylor polynomial of degree 6 for e^r; relative error
/// below kExpLanesError for x in [-87, 88], clamped outside (so e^-100 gives 1.6e-38, not 0).
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

/// Natural logarithm of x in [1e-37, 1e38], error below kLogLanesError (1 + |ln x|): by the
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

// Complex arithmetic on lanes of wavelengths, for the averages over flakes. Scalars use
// std::complex; the two are tested against each other.

struct ComplexLanes {
    DoubleLanes re, im;

    friend ComplexLanes operator+(const ComplexLanes& a, const ComplexLanes& b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend ComplexLanes operator-(const ComplexLanes& a, const ComplexLanes& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend ComplexLanes operator*(const ComplexLanes& a, const ComplexLanes& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend ComplexLanes operator*(const DoubleLanes& a, const ComplexLanes& b) {
        return {a * b.re, a * b.im};
    }
    friend ComplexLanes operator-(const ComplexLanes& a) { return {-a.re, -a.im}; }
};

inline ComplexLanes conj(const ComplexLanes& a) { return {a.re, -a.im}; }
/// |a|^2
inline DoubleLanes norm(const ComplexLanes& a) { return a.re * a.re + a.im * a.im; }
inline ComplexLanes operator/(const ComplexLanes& a, const ComplexLanes& b) {
    return (1.0 / norm(b)) * (a * conj(b));
}
inline ComplexLanes splat_complex(std::complex<double> a) {
    return {nacre::splat(a.real()), nacre::splat(a.imag())};
}

/// Bounds of the errors below against long double.
inline constexpr double kExpLanesRelativeError = 1e-15;
inline constexpr double kSinCosLanesError = 4e-16;  ///< absolute, for |x| <= 1e5

namespace detail {
using IntegerLanes = std::int64_t __attribute__((vector_size(kLanes * sizeof(std::int64_t))));

// Adding 1.5 * 2^52 pushes the fraction out of a double and leaves the integer, in two's
// complement, in its low bits.
inline constexpr double kRoundingShift = 0x1.8p52;

/// sum_i coefficients[i] x^i, by Horner's rule.
template <std::size_t n>
inline DoubleLanes horner(const DoubleLanes& x, const double (&coefficients)[n]) {
    DoubleLanes sum = nacre::splat(coefficients[n - 1]);
    for (std::size_t i = n - 1; i-- > 0;) sum = sum * x + coefficients[i];
    return sum;
}
}  // namespace detail

/// e^x for x <= 0, the decay of a wave; 0 below -708.
inline DoubleLanes exp_lanes(DoubleLanes x) {
    // x = k ln 2 + r, |r| <= ln 2 / 2; the Taylor remainder after r^13 is below 1e-17.
    constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
    static constexpr double c[] = {1.0,
                                   1.0,
                                   1.0 / 2,
                                   1.0 / 6,
                                   1.0 / 24,
                                   1.0 / 120,
                                   1.0 / 720,
                                   1.0 / 5040,
                                   1.0 / 40320,
                                   1.0 / 362880,
                                   1.0 / 3628800,
                                   1.0 / 39916800,
                                   1.0 / 479001600,
                                   1.0 / 6227020800};
    const auto vanishes = x < -708.0;
    x = vanishes ? DoubleLanes{} : x;
    const DoubleLanes shifted = x * std::numbers::log2e + detail::kRoundingShift;
    const DoubleLanes k = shifted - detail::kRoundingShift;
    const DoubleLanes r = (x - k * ln2_high) - k * ln2_low;
    const auto exponent = (__builtin_convertvector(k, detail::IntegerLanes) + 1023) << 52;
    const DoubleLanes power = std::bit_cast<DoubleLanes>(exponent);
    const DoubleLanes result = power * detail::horner(r, c);
    return vanishes ? DoubleLanes{} : result;
}

/// cos x + i sin x.
inline ComplexLanes cis_lanes(const DoubleLanes& x) {
    // x = k pi/2 + r, |r| <= pi/4, with pi/2 in three parts so that r keeps its digits; the Taylor
    // remainders after r^17 and r^16 are below 1e-17.
    constexpr double half_pi_1 = 0x1.921fb544p+0, half_pi_2 = 0x1.0b4611a6p-34,
                     half_pi_3 = 0x1.3198a2e037073p-69;
    static constexpr double sine[] = {1.0,
                                      -1.0 / 6,
                                      1.0 / 120,
                                      -1.0 / 5040,
                                      1.0 / 362880,
                                      -1.0 / 39916800,
                                      1.0 / 6227020800,
                                      -1.0 / 1307674368000,
                                      1.0 / 355687428096000};
    static constexpr double cosine[] = {1.0,
                                        -1.0 / 2,
                                        1.0 / 24,
                                        -1.0 / 720,
                                        1.0 / 40320,
                                        -1.0 / 3628800,
                                        1.0 / 479001600,
                                        -1.0 / 87178291200,
                                        1.0 / 20922789888000};
    const DoubleLanes shifted = x * (2 * std::numbers::inv_pi) + detail::kRoundingShift;
    const DoubleLanes k = shifted - detail::kRoundingShift;
    const DoubleLanes r = ((x - k * half_pi_1) - k * half_pi_2) - k * half_pi_3;
    const DoubleLanes r2 = r * r;
    const DoubleLanes s = r * detail::horner(r2, sine), c = detail::horner(r2, cosine);
    const auto quadrant = __builtin_convertvector(k, detail::IntegerLanes);
    const auto swapped = (quadrant & 1) != 0;
    const auto s_negative = (quadrant & 2) != 0, c_negative = ((quadrant + 1) & 2) != 0;
    const DoubleLanes sin_x = swapped ? c : s, cos_x = swapped ? s : c;
    return {c_negative ? -cos_x : cos_x, s_negative ? -sin_x : sin_x};
}

/// e^(i z) for Im z >= 0.
inline ComplexLanes exp_i(const ComplexLanes& z) { return exp_lanes(-z.im) * cis_lanes(z.re); }

// For the Airy reflectance: cosine, sine and exponential decay over lanes of either precision.

/// Error bounds in the lanes' own precision: absolute for cos_sin_turns(), relative for decay().
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

}  // namespace nacre
