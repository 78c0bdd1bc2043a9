#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>

#include "nacre/core/lanes.h"

// Elementary functions over lanes, branch-free. Each is one algorithm for both precisions: the
// argument is reduced to an interval about 0, where Taylor's series is summed to as many terms as
// the precision needs. Stated errors are against long double.

namespace nacre {

/// A lane's number type.
template <class V>
using LaneScalar = std::remove_cvref_t<decltype(V{}[0])>;

namespace detail {

/// What the precision decides.
template <class Real>
struct LaneSeries;
template <>
struct LaneSeries<float> {
    static constexpr int kExpTerms = 7, kCosSinTerms = 5, kDecayTerms = 7;
    static constexpr float kLn2High = 0.693359375f, kLn2Low = -2.12194440e-4f;
};
template <>
struct LaneSeries<double> {
    static constexpr int kExpTerms = 14, kCosSinTerms = 9, kDecayTerms = 15;
    static constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;
};

/// Integers as wide as the lanes of V: what a comparison of them gives.
template <class V>
using IntegerLanes = decltype(V{} < V{});

template <class V>
inline constexpr int kMantissaBits = std::numeric_limits<LaneScalar<V>>::digits - 1;

/// The integer nearest to a number of magnitude up to 2^(kMantissaBits - 1).
template <class V>
struct NearestInteger {
    V value;
    IntegerLanes<V> bits;  ///< its two's complement, in the low kMantissaBits - 1 bits
};
template <class V>
inline NearestInteger<V> nearest_integer(const V& x) {
    // Adding 1.5 * 2^kMantissaBits pushes the fraction out of the mantissa.
    constexpr auto shift = LaneScalar<V>(std::int64_t{3} << (kMantissaBits<V> - 1));
    const V shifted = x + shift;
    return {shifted - shift, std::bit_cast<IntegerLanes<V>>(shifted)};
}

/// sign^k / (first + step k)!: the Taylor coefficients of e^x, of cos x and of sin x.
template <class Real, int n>
constexpr std::array<Real, n> taylor_coefficients(int sign, int first, int step) {
    std::array<Real, n> coefficients{};
    double factorial = 1, power = 1;  // exact up to 22!
    for (int k = 0, next = 1; k < n; ++k, power *= sign) {
        for (; next <= first + step * k; ++next) factorial *= next;
        coefficients[k] = static_cast<Real>(power / factorial);
    }
    return coefficients;
}

/// sum_k coefficients[k] x^k, by Horner's rule.
template <class V, std::size_t n>
inline V horner(const V& x, const std::array<LaneScalar<V>, n>& coefficients) {
    V sum = V{} + coefficients[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) sum = sum * x + coefficients[k];
    return sum;
}

/// e^x where that is a normal number: 2^k e^r with x = k ln 2 + r, |r| <= ln 2 / 2.
template <class V>
inline V exp_of_normal(const V& x) {
    using Real = LaneScalar<V>;
    using Series = LaneSeries<Real>;
    static constexpr auto coefficients = taylor_coefficients<Real, Series::kExpTerms>(1, 0, 1);
    const auto k = nearest_integer<V>(x * std::numbers::log2e_v<Real>);
    // In two parts, the first so short that its product with k is exact.
    const V r = (x - k.value * Series::kLn2High) - k.value * Series::kLn2Low;
    return std::bit_cast<V>(std::bit_cast<IntegerLanes<V>>(horner(r, coefficients)) +
                            (k.bits << kMantissaBits<V>));
}

}  // namespace detail

/// Relative error of exp_lanes().
template <class V>
inline constexpr double kExpLanesError = std::is_same_v<V, FloatLanes> ? 3e-7 : 1e-15;

/// e^x for x in [-87, 88], clamped outside (so e^-100 gives 1.6e-38, not 0).
inline FloatLanes exp_lanes(const FloatLanes& x) {
    return detail::exp_of_normal(min_lanes(max_lanes(x, splat(-87.0f)), splat(88.0f)));
}
/// e^x for x <= 709; 0 below -708.
inline DoubleLanes exp_lanes(const DoubleLanes& x) {
    const DoubleLanes result = detail::exp_of_normal(max_lanes(splat(-708.0), x));
    return by_registers([](auto y, auto e) { return y < -708.0 ? decltype(y){} : e; }, x, result);
}

inline constexpr double kOneMinusExpLanesError = 1e-5;

/// 1 - e^-x for x >= 0, relative error below kOneMinusExpLanesError: by series where e^-x is
/// near 1.
inline FloatLanes one_minus_exp_lanes(FloatLanes x) {
    const FloatLanes series = x * (1.0f - x * (0.5f - x * (1.0f / 6 - x * (1.0f / 24))));
    const FloatLanes direct = 1.0f - exp_lanes(-x);
    return x < 0.05f ? series : direct;
}

/// The mean of e^-t over t from 0 to x >= 0, (1 - e^-x) / x: what a layer of that optical depth leaves of
/// light that ends evenly within it. Relative error of one number below 1e-12, of lanes below
/// kOneMinusExpLanesError.
inline double mean_attenuation(double x) { return x > 1e-12 ? -std::expm1(-x) / x : 1.0; }
inline FloatLanes mean_attenuation(const FloatLanes& x) {
    const FloatLanes safe = max_lanes(x, splat(1e-20f));
    return one_minus_exp_lanes(safe) / safe;
}

inline constexpr double kLogLanesError = 2e-7;

/// Natural logarithm of x in [1e-37, 1e38], error below kLogLanesError (1 + |ln x|): by the
/// exponent and the series of artanh((m - 1) / (m + 1)) for a mantissa m in [1/sqrt 2, sqrt 2).
/// [abramowitz-stegun-1964, eq. 4.1.27]
inline FloatLanes log_lanes(FloatLanes x) {
    using IntLanes = detail::IntegerLanes<FloatLanes>;
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
/// The root with Re, Im >= 0 of z with Im z >= 0; its relative error is at most 1e-15
/// for |z| in [1e-150, 1e150].
inline ComplexLanes sqrt_upper(const ComplexLanes& z) {
    // The larger part from a sum without cancellation, the other from z.im = 2 Re Im.
    const DoubleLanes size = max_lanes(z.re, -z.re);
    const DoubleLanes larger = sqrt_lanes(0.5 * (sqrt_lanes(norm(z)) + size));
    const DoubleLanes smaller = where_positive(larger, 0.5 * z.im / larger, DoubleLanes{});
    return {where_positive(-z.re, smaller, larger), where_positive(-z.re, larger, smaller)};
}
inline ComplexLanes splat_complex(std::complex<double> a) {
    return {nacre::splat(a.real()), nacre::splat(a.imag())};
}

template <class V>
struct CosineSine {
    V cosine, sine;
};

/// Error of the cosines and sines below: absolute, and relative of the sine near 0.
template <class V>
inline constexpr double kCosSinLanesError = std::is_same_v<V, FloatLanes> ? 2e-7 : 4e-16;

namespace detail {
/// cos and sin of r + `quadrants` pi/2, |r| <= pi/4.
template <class V>
inline CosineSine<V> cos_sin_of_quadrant(const V& r, const IntegerLanes<V>& quadrants) {
    using Real = LaneScalar<V>;
    constexpr int n = LaneSeries<Real>::kCosSinTerms;
    static constexpr auto cosine = taylor_coefficients<Real, n>(-1, 0, 2);
    static constexpr auto sine = taylor_coefficients<Real, n>(-1, 1, 2);
    const V r2 = r * r;
    const V s = r * horner(r2, sine), c = horner(r2, cosine);
    const auto of_quadrant = [](auto even, auto odd, auto quadrant) {
        const auto x = (quadrant & 1) != 0 ? odd : even;
        return (quadrant & 2) != 0 ? -x : x;
    };
    // cos x = sin(x + pi/2)
    return {by_registers(of_quadrant, s, c, quadrants + 1),
            by_registers(of_quadrant, s, c, quadrants)};
}
}  // namespace detail

// Turns and radians reach that interval in different ways: multiples of a quarter of a turn are
// exact numbers, and so is what is left over them; multiples of pi/2 are not, and are subtracted in
// parts, which bounds the argument.

/// cos and sin of 2 pi times `turns`.
/// @param turns  magnitude below 2^20 for float, 2^49 for double; beyond, the phase is lost anyway
template <class V>
inline CosineSine<V> cos_sin_turns(const V& turns) {
    using Real = LaneScalar<V>;
    const auto quarters = detail::nearest_integer<V>(turns * Real(4));
    const V left = turns - quarters.value * Real(0.25);
    return detail::cos_sin_of_quadrant<V>(left * (2 * std::numbers::pi_v<Real>), quarters.bits);
}

/// cos x + i sin x for |x| <= 1e5.
inline ComplexLanes cis_lanes(const DoubleLanes& x) {
    // In three parts, the first two so short that their products with the quadrants are exact.
    constexpr double half_pi_1 = 0x1.921fb544p+0, half_pi_2 = 0x1.0b4611a6p-34,
                     half_pi_3 = 0x1.3198a2e037073p-69;
    const auto k = detail::nearest_integer<DoubleLanes>(x * (2 * std::numbers::inv_pi));
    const DoubleLanes r = ((x - k.value * half_pi_1) - k.value * half_pi_2) - k.value * half_pi_3;
    const auto wave = detail::cos_sin_of_quadrant(r, k.bits);
    return {wave.cosine, wave.sine};
}

/// e^(i z) for Im z >= 0.
inline ComplexLanes exp_i(const ComplexLanes& z) { return exp_lanes(-z.im) * cis_lanes(z.re); }

/// Relative error of decay().
template <class V>
inline constexpr double kDecayLanesError = std::is_same_v<V, FloatLanes> ? 4e-7 : 1e-15;

/// e^-x and (1 - e^-x) / x for x >= 0, the latter without loss of digits near 0.
template <class V>
struct Decay {
    V left, mean;
};
template <class V>
inline Decay<V> decay(const V& x) {
    using Real = LaneScalar<V>;
    const V left = exp_lanes(-x);
    V series = V{} + Real(1);
    for (int k = detail::LaneSeries<Real>::kDecayTerms; k >= 2; --k)
        series = Real(1) - series * x * Real(1.0 / k);
    const V direct = (Real(1) - left) / max_lanes(x, V{} + Real(0.5));
    return {left, where_positive(Real(0.5) - x, series, direct)};
}

/// Error of atan2_lanes(), in rad, absolute; and relative of small angles from +x.
inline constexpr double kAtan2LanesError = 3e-7;

/// Angle in [-pi, pi] from +x to the point (x, y); 0 of the origin.
/// By the polynomial for arcs up to 45 deg.               [abramowitz-stegun-1964, eq. 4.4.49]
inline FloatLanes atan2_lanes(FloatLanes y, FloatLanes x) {
    static constexpr std::array<float, 9> coefficients = {
        1.0f,           -0.3333314528f, 0.1999355085f,  -0.1420889944f, 0.1065626393f,
        -0.0752896400f, 0.0429096138f,  -0.0161657367f, 0.0028662257f};
    const FloatLanes width = max_lanes(x, -x), height = max_lanes(y, -y);
    const FloatLanes longer = max_lanes(width, height), shorter = min_lanes(width, height);
    const FloatLanes slope = longer > 0 ? shorter / longer : FloatLanes{};
    const FloatLanes arc = slope * detail::horner(slope * slope, coefficients);
    constexpr float kPi = std::numbers::pi_v<float>;
    const FloatLanes quarter = height > width ? 0.5f * kPi - arc : arc;
    const FloatLanes half = x < 0 ? kPi - quarter : quarter;
    return y < 0 ? -half : half;
}

}  // namespace nacre
