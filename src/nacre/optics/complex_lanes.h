#pragma once

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>

#include "nacre/core/lanes.h"

// Complex arithmetic on lanes of wavelengths, for the averages over flakes. Scalars use
// std::complex; the two are tested against each other.

namespace nacre::optics {

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
inline ComplexLanes splat(std::complex<double> a) {
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

/// Taylor polynomial sum x^i / (start + stride i)! signs..., by Horner's rule, last term first.
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

}  // namespace nacre::optics
