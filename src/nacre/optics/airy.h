#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/lanes.h"
#include "nacre/optics/thickness_rule.h"

// One smooth film between two half spaces: the exact reflectance, fast enough for every
// facet, its Fourier series in the film's phase, and its averages over a spread of thickness.
// Indices do not depend on wavelength, so that a wavelength enters through the phase alone.
// Stacks of films, and dispersion: thin_film.h. Signs and the meaning of k: docs/conventions.md.

namespace nacre::optics {

/// Indices and extinctions that AiryFilm takes.
inline constexpr Range kAiryIndexRange{.lo = 0.01, .hi = 10};
inline constexpr Range kAiryExtinctionRange{.lo = 0, .hi = 100};

/// Error of AiryFilm::reflectance against stack_reflectance, in double lanes and in float lanes,
/// for films of up to 10 wavelengths' optical thickness, without extreme contrasts (indices 0.5 to
/// 4). In float it grows in proportion with the thickness: the phase is a float.
inline constexpr double kAiryError = 2e-13;
inline constexpr double kAiryFloatError = 4e-5;

/// The film seen under one angle. It holds the characteristic matrix's amplitudes, which do not
/// depend on wavelength, so that a reflectance costs one sine and cosine.
///
/// For each polarisation R = N / (N + K), N = |u cos(delta) + v sin(delta)/q|^2, where delta = 2 pi
/// q d / lambda is the phase of one passage and q = eta_2 cos(theta_2). cos(delta) and
/// sin(delta)/q are entire functions of q^2, so this holds through the critical angle, beyond which
/// they turn into hyperbolic functions; N and K are never negative, so R stays in [0, 1].
template <class Real>
class AiryAngle {
 public:
    struct Polarised {
        Real u_re, u_im, v_re, v_im, k;
    };

    /// Unpolarised reflectance for each lane's d / lambda, thickness over vacuum wavelength, >= 0.
    template <class V>
    V reflectance(V thickness_over_wavelength) const;

    /// Likewise for s and p apart.
    template <class V>
    struct Pair {
        V s, p;
    };
    template <class V>
    Pair<V> polarised_reflectance(V thickness_over_wavelength) const;

 private:
    friend class AiryFilm;
    Polarised s_, p_;
    Real q_;  // |eta_2 cos theta_2|, at least a tiny number
    bool evanescent_;
};

/// The same as a sum over orders of interference: Belcour & Barla's form.
///   R = c0 + 2 sum_{m >= 1} strength ratio^m cos(m (2 pi OPD / lambda + phase)),
///   OPD = 2 eta_2 d cos(theta_2)
///                                                                     [belcour-barla-2017, sec. 4]
/// c0 = R12 + R*, strength = R* - T121, ratio = sqrt(R12 R23), R* = T121^2 R23 / (1 - R12 R23),
/// T121 = t12 t21 = 1 - R12, phase = arg r21 + arg r23. Belcour & Barla's C_m = strength ratio^m.
struct AiryTerms {
    struct Polarised {
        double c0, strength, ratio, phase;
    };
    Polarised s, p;
    double film_cosine;                 ///< cos(theta_2)
    double optical_path_per_thickness;  ///< OPD / d = 2 eta_2 cos(theta_2)
};

/// Averages over a film's thickness.
struct AiryMoments {
    double mean = 0, mean_square = 0;
    double variance() const { return mean_square > mean * mean ? mean_square - mean * mean : 0; }
};

/// Error of AiryFilm::moments against sums over stack_reflectance.
inline constexpr double kAiryMomentsError = 1e-8;

/// Outside (eta_1, real) | film (eta_2, real, thickness d) | base (eta_3 + i kappa_3).
class AiryFilm {
 public:
    /// @param outside_ior  eta_1, in kAiryIndexRange: 1 in air, the binder's under a coat
    /// @param film_ior     eta_2, the same range
    /// @param base_ior     eta_3, the same range
    /// @param base_extinction  kappa_3 itself (not kappa_3 / eta_3), in kAiryExtinctionRange
    /// @throws DomainError naming the argument, its value and its range
    AiryFilm(double outside_ior, double film_ior, double base_ior, double base_extinction);

    /// Works out what depends on the angle. @param cosine  of incidence, outside, in [0, 1];
    /// values below 1e-5 count as 1e-5.
    template <class Real>
    AiryAngle<Real> at(Real cosine) const;

    /// Unpolarised reflectance at eight wavelengths, exact.
    /// @param cosine  as at(); thickness_nm  d >= 0; inverse_wavelengths_per_nm  1 / lambda
    template <class V, class Real>
    V reflectance(Real cosine, Real thickness_nm, V inverse_wavelengths_per_nm) const {
        return at(cosine).reflectance(thickness_nm * inverse_wavelengths_per_nm);
    }

    /// The series at this angle; empty where the film's wave is evanescent (total reflection from
    /// outside into the film, or within rounding of it), which has no orders of interference.
    std::optional<AiryTerms> terms(double cosine) const;

    /// Mean and mean square of the unpolarised reflectance over thicknesses distributed uniformly
    /// between `range.lo_nm` >= 0 and `range.hi_nm` >= lo, in closed form: the series above sums to
    /// 1 / (1 - z e^(i x)), whose products split into partial fractions and integrate to
    /// logarithms. Where the film's wave is evanescent: by Gauss-Legendre quadrature.
    AiryMoments moments(double cosine, ThicknessRange range, double wavelength_nm) const;

 private:
    double outside_ior_, film_ior_;
    std::complex<double> base_;            // index
    double eps_1_, eps_2_, eps_21_;        // squares of indices; eps_2 - eps_1
    std::complex<double> eps_3_, eps_31_;  // likewise
};

template <class Real>
AiryAngle<Real> AiryFilm::at(Real cosine) const {
    // Normal components of the wave vectors, q_j = n_j cos(theta_j), from q_1 without the sine,
    // which keeps all digits near grazing incidence and for equal indices. Amplitudes below are
    // those of the characteristic matrix, multiplied by q's so that nothing is divided by them.
    const Real n1 = static_cast<Real>(outside_ior_);
    const Real q1 = n1 * std::max(cosine, Real(1e-5)), q1_squared = q1 * q1;
    const Real q2_squared = static_cast<Real>(eps_21_) + q1_squared;
    const Real x = static_cast<Real>(eps_31_.real()) + q1_squared;
    const Real y = static_cast<Real>(eps_31_.imag());
    // sqrt(x + i y), y >= 0: the root in the first quadrant, without cancellation.
    const Real large = std::sqrt((std::sqrt(x * x + y * y) + std::abs(x)) / 2);
    const Real small = large > 0 ? y / (2 * large) : Real(0);
    const Real a = x > 0 ? large : small, b = x > 0 ? small : large;

    AiryAngle<Real> angle;
    angle.evanescent_ = q2_squared < 0;
    angle.q_ = std::max(std::sqrt(std::abs(q2_squared)), Real(1e-6));
    // s: u = q1 - q3, v = -i (q1 q3 - q2^2).
    angle.s_ = {q1 - a, -b, q1 * b, q2_squared - q1 * a, 4 * q1 * a};
    // p: u = eps1 q3 - eps3 q1, v = -i (eps1 eps3 q2^2/eps2 - eps2 q1 q3).
    const Real e1 = static_cast<Real>(eps_1_), e2 = static_cast<Real>(eps_2_);
    const Real e3 = static_cast<Real>(eps_3_.real()), f3 = static_cast<Real>(eps_3_.imag());
    const Real g = e1 * q2_squared / e2, h = e2 * q1;
    angle.p_ = {e1 * a - e3 * q1, e1 * b - f3 * q1, g * f3 - h * b, h * a - g * e3,
                4 * e1 * q1 * (e3 * a + f3 * b)};
    return angle;
}

template <class Real>
template <class V>
typename AiryAngle<Real>::template Pair<V> AiryAngle<Real>::polarised_reflectance(
    V thickness_over_wavelength) const {
    V cosine, sine_over_q;
    V scale = V{} + Real(1);  // of N: 1, or e^(-2 |delta|) that keeps hyperbolic functions finite
    if (!evanescent_) [[likely]] {
        const auto wave = cos_sin_turns(q_ * thickness_over_wavelength);
        cosine = wave.cosine;
        sine_over_q = wave.sine * (1 / q_);
    } else {
        constexpr Real two_pi = Real(6.283185307179586476925);
        const V twice = (2 * two_pi * q_) * thickness_over_wavelength;
        const auto wave = decay(twice);
        cosine = Real(0.5) + Real(0.5) * wave.left;
        sine_over_q = two_pi * thickness_over_wavelength * wave.mean;
        scale = wave.left;
    }
    const auto reflectance = [&](const Polarised& w) {
        const V re = w.u_re * cosine + w.v_re * sine_over_q;
        const V im = w.u_im * cosine + w.v_im * sine_over_q;
        const V n = re * re + im * im;
        return n / (n + w.k * scale);
    };
    return {reflectance(s_), reflectance(p_)};
}

template <class Real>
template <class V>
V AiryAngle<Real>::reflectance(V thickness_over_wavelength) const {
    const auto pair = polarised_reflectance(thickness_over_wavelength);
    return Real(0.5) * (pair.s + pair.p);
}

}  // namespace nacre::optics
