#pragma once

#include <complex>
#include <vector>

#include "nacre/optics/thin_film.h"

// Quadrature over the law of a film's thickness. Weights add up to 1: they are the law, cut at
// three deviations (normal) and at zero thickness, renormalised. Normal and uniform laws, and the cut,
// which leaves out 0.27 %, are choices of this project: makers state at most a spread.

namespace nacre::optics {

/// The range of thicknesses that a law leaves after its cuts.
struct ThicknessRange {
    double lo_nm, hi_nm;
};
ThicknessRange thickness_range(double mean_nm, const ThicknessSpread& spread);

/// The mean of the law after its cuts: above `mean_nm` where thickness 0 cuts it.
double mean_thickness_nm(double mean_nm, const ThicknessSpread& spread);

/// The thickness below which this fraction of the law lies, to 1e-12 of its range; the mean where
/// nothing varies.
/// @param fraction  in [0, 1]
double thickness_quantile(double mean_nm, const ThicknessSpread& spread, double fraction);

/// Mean of f = sum weights[i] f(thickness_nm[i]).
struct ThicknessRule {
    std::vector<double> thickness_nm, weights;
};

/// For n <= 24 the n-point Gauss rule for the law itself: exact for polynomials of degree 2 n - 1
/// times it. Made from the three-term recurrence of its orthogonal polynomials by the eigenvalues
/// of the Jacobi matrix [golub-welsch-1969], the recurrence by the discretised Stieltjes procedure
/// [gautschi-2004, section 2.2.3]. For more nodes, Gauss-Legendre with the density in the weights.
/// Without spread the rule has one node.
ThicknessRule thickness_rule(double mean_nm, const ThicknessSpread& spread, int n);

/// How many nodes the rule needs. Its error falls like rho^(-2 n), rho being the half-axis sum of the
/// largest ellipse around the range of integration inside which R is analytic
/// [trefethen-2013, theorem 19.3]; so the nearest pole of R decides.
///
/// For a film in which waves run. As a function of its phase, in [-half_phase, half_phase], R has
/// its nearest pole where the amplitude after a round trip, p e^(Im phase), reaches 1.
/// @param p             largest amplitude after a round trip, in [0, 1]
/// @param target_error  relative error aimed at, in (0, 1)
/// @return  in [1, kMaxNodesPerFilm], rounded up so that few different counts occur
int nodes_for_wave(double half_phase, double p, double target_error);

/// Likewise for a film beyond its critical angle, where waves decay by `decay_per_nm` and nothing
/// resonates: the pole is at thickness 0, outside [lo, hi].
int nodes_for_decay(double lo_nm, double hi_nm, double decay_per_nm, double target_error);

inline constexpr int kMaxNodesPerFilm = 768;

/// The same mean for a function that is analytic for Im thickness >= 0, on an arc through the
/// upper half plane between the ends of the law: there propagating waves decay, and with them the
/// narrow resonances that the function has on the real axis near grazing incidence.
struct ThicknessArc {
    std::vector<std::complex<double>> thickness_nm, weights;
};
ThicknessArc thickness_arc(double mean_nm, const ThicknessSpread& spread);

}  // namespace nacre::optics
