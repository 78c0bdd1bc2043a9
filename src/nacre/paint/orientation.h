#pragma once

#include <vector>

#include "nacre/paint/recipe.h"

// Laws of flake normals as mixtures of Beckmann's, which is what the solver, the walks and the
// models of single flakes know. A mixture is exact for all of them: flakes of several alphas lie
// beside each other.
//
// Gaussian slopes of flakes are those of [ergun-2016]; GGX is the other law that microfacets have
// [walter-2007, eq. 33]. That flakes in a sprayed film follow one of them is an assumption: no
// measured law could be cited, which is why a table may be stated.

namespace nacre::paint {

/// A fraction of the flakes' area whose slopes have Beckmann's law.
struct SlopeComponent {
    double fraction = 1;
    double alpha = 0.1;
};

/// GGX as a mixture, derived here: its density of slopes [walter-2007, eq. 33 times cos^4] is the mean of
/// Beckmann's over 1/a^2 = u / alpha^2, u with the law exp(-u),
///
///     Int_0^inf exp(-u) u / (pi alpha^2) exp(-u t^2/alpha^2) du
///         = 1 / (pi alpha^2) (1 + t^2/alpha^2)^-2,
///
/// taken by the trapezoidal rule in ln u. As (1 + t^2/alpha^2) only shifts ln u, its relative
/// error is the same at all slopes, 2 |Gamma(2 + 2 pi i / step)|, here 0.9 %. Flakes with a > 1, a
/// fraction 1 - exp(-alpha^2), get a = 1: the tail ends near a slope of 1.
std::vector<SlopeComponent> ggx_mixture(double alpha);
/// Relative, of the density of slopes up to kGgxSlope: for alpha up to 0.2, and up to 0.5.
inline constexpr double kGgxError = 0.012, kWideGgxError = 0.035;
inline constexpr double kGgxSlope = 0.25;  ///< up to this slope, 14 deg

/// The mixture nearest to a measured law in likelihood [dempster-laird-rubin-1977], and the largest
/// difference between their cumulative laws. That a law is such a mixture is a choice, and what is not
/// is refused.
struct TiltFit {
    std::vector<SlopeComponent> components;
    double residual = 0;
};
TiltFit fit_tilts(const TabulatedTilts& table);
/// A law of tilts whose mixture differs by more, as a ring without flat flakes, is refused.
inline constexpr double kMaxTiltResidual = 0.03;

/// The mixture of a law at the top of its layer; of Beckmann's own the law itself.
/// @throws DomainError if tilts are no mixture of Beckmann's laws
std::vector<SlopeComponent> beckmann_mixture(const Orientation& orientation);

/// The tilt that half of the flakes' area stays within, at the top of the layer: tan^2 = alpha^2 ln 2
/// for Gaussian slopes, alpha^2 for GGX.              [walter-2007, eq. 28 and 35 with 1/2]
double median_tilt_deg(const Orientation& orientation);

}  // namespace nacre::paint
