#pragma once

#include <cmath>
#include <complex>
#include <type_traits>

#include "nacre/core/lane_math.h"
#include "nacre/core/lanes.h"
#include "nacre/optics/material.h"

// Reflection and refraction at one flat interface: complex amplitudes for media that may absorb,
// and below them the real-valued reflectance between two transparent media, for inner loops.
// Signs, time factor and the meaning of k: docs/conventions.md.

namespace nacre::optics {

/// Amplitude ratios of the electric field, reflected and transmitted over incident, perpendicular
/// (s) and parallel (p) to the plane of incidence. At normal incidence r_p = -r_s.
struct FresnelAmplitudes {
    std::complex<double> r_s, r_p, t_s, t_p;
};

/// Error of each amplitude, divided by max(1, |amplitude|), against 50-digit arithmetic over the
/// valid range; near the critical angle multiply by n_i / |n_t cos_t|.
inline constexpr double kFresnelError = 4e-15;

/// Fresnel's equations for absorbing media.            [born-wolf-1999, 1.5 eq. 20-21, 14.2]
///
/// @param n_i    index on the incident side, n in (0, 1e3], k in [0, 1e3]; may absorb
/// @param n_t    index on the far side, the same range
/// @param cos_i  cosine of the incidence angle, in (0, 1]
/// @return       amplitudes; |r| = 1 under total internal reflection
/// @throws DomainError naming the argument, its value and its range
///
/// The far-side wave is the one that decays: of the two roots of the refracted cosine we take
/// Im(n_t cos_t) >= 0.
FresnelAmplitudes fresnel(ComplexIndex n_i, ComplexIndex n_t, double cos_i);

/// n_t cos_t, the normal component of the wave vector beyond the interface in units of 2 pi /
/// wavelength: the root with Im >= 0, and with Re >= 0 where it is real.
/// Takes n_i cos_i from the incident side; no range checks.
std::complex<double> normal_wavevector(ComplexIndex n_i, ComplexIndex n_t, double cos_i);
/// The same at a vector of wavelengths, from a transparent medium.
inline ComplexLanes normal_wavevector(const DoubleLanes& n_i, const ComplexLanes& n_t,
                                      double cos_i) {
    const ComplexLanes from{n_i, {}};
    ComplexLanes square = (n_t - from) * (n_t + from);
    square.re += n_i * n_i * (cos_i * cos_i);
    return sqrt_upper(square);
}

// The interface between two transparent media, fast: one function for double, float, FloatLanes
// and DoubleLanes. No argument is checked here; the callers are inner loops.

namespace detail {
template <class T>
inline T square_root(T x) {
    if constexpr (std::is_floating_point_v<T>) {
        return std::sqrt(x);
    } else {
        return sqrt_lanes(x);
    }
}
}  // namespace detail

/// Square of the refracted cosine times (n_t/n_i)^2, by Snell's law; <= 0 beyond the critical
/// angle. Written without the sine so that it keeps all digits at grazing incidence and for
/// nearly equal indices.
template <class T>
inline T scaled_refracted_cos_squared(T relative_index, T cos_i) {
    return (relative_index - 1) * (relative_index + 1) + cos_i * cos_i;
}

/// Cosine of the refracted direction, n_i sin_i = n_t sin_t; 0 beyond the critical angle.
/// @param n_i, n_t  real indices of the incident and far side, > 0
/// @param cos_i     in [0, 1]
template <class T>
inline T refracted_cos(T n_i, T n_t, T cos_i) {
    const T relative_index = n_t / n_i;
    const T g = scaled_refracted_cos_squared(relative_index, cos_i);
    return detail::square_root(max_lanes(g, T{})) / relative_index;
}

/// Unpolarised Fresnel reflectance between transparent media; 1 beyond the critical angle, and at
/// cos_i = 0 unless the indices are equal; 0 for equal indices. The transmittance is 1 minus it.
///                                                              [born-wolf-1999, 1.5 eq. 20-21]
/// @param n_i, n_t  real indices of the incident and far side, > 0
/// @param cos_i     in [0, 1]
template <class T>
inline T dielectric_reflectance(T n_i, T n_t, T cos_i) {
    const T relative_index = n_t / n_i;
    const T g = scaled_refracted_cos_squared(relative_index, cos_i);
    const T one = T{} + 1;
    // q = (n_t/n_i) cos_t. Of the 0/0 at grazing incidence only the selected value survives.
    const T q = detail::square_root(where_positive(g, g, one));
    const T r_s = (cos_i - q) / (cos_i + q);
    const T r_p = (relative_index * relative_index * cos_i - q) /
                  (relative_index * relative_index * cos_i + q);
    const T half = (r_s * r_s + r_p * r_p) / 2;
    const T beyond = by_registers([](auto n, auto all) { return n == 1 ? decltype(n){} : all; },
                                  relative_index, one);
    return where_positive(g, half, beyond);
}

/// The same as a function of the relative index n_t / n_i alone.
template <class T>
inline T fresnel_dielectric(T relative_index, T cos_i) {
    return dielectric_reflectance(T{} + 1, relative_index, cos_i);
}

/// Unpolarised reflectance of a metal n + i k in a medium of index 1, the square moduli of the
/// amplitudes above written in real numbers.                       [born-wolf-1999, 14.2 eq. 15-17]
/// @param n, k   lanes; n > 0, k >= 0
/// @param cos_i  in [0, 1]
template <class V, class T>
inline V conductor_reflectance(const V& n, const V& k, T cos_i) {
    const T cos2 = cos_i * cos_i, sin2 = 1 - cos2;
    // a + i b = sqrt(index^2 - sin^2), the scaled cosine beyond the face.
    const V real = n * n - k * k - sin2;
    const V size = sqrt_lanes(real * real + T(4) * n * n * k * k);  // a^2 + b^2
    const V half = (size + real) * T(0.5);
    const V a = sqrt_lanes(max_lanes(half, V{}));
    const V mixed = T(2) * cos_i * a;
    const V r_s = (size + cos2 - mixed) / (size + cos2 + mixed);
    const V along = cos2 * size + sin2 * sin2;
    const V r_p = r_s * (along - sin2 * mixed) / (along + sin2 * mixed);
    return (r_s + r_p) * T(0.5);
}

}  // namespace nacre::optics
