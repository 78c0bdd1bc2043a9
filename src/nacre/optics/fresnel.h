#pragma once

#include <complex>

#include "nacre/optics/material.h"

// Reflection and refraction of amplitudes at one flat interface, for media that may absorb. The
// real-valued short cut for two transparent media is optics/dielectric.h.
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

}  // namespace nacre::optics
