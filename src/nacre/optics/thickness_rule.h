#pragma once

#include <complex>
#include <vector>

#include "nacre/optics/thin_film.h"

// Quadrature over the law of a film's thickness. Weights add up to 1: they are the law, cut at
// three deviations (normal) and at zero thickness, renormalised.

namespace nacre::optics {

/// The range of thicknesses that a law leaves after its cuts.
struct ThicknessRange {
    double lo_nm, hi_nm;
};
ThicknessRange thickness_range(double mean_nm, const ThicknessSpread& spread);

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

/// The same mean for a function that is analytic for Im thickness >= 0, on an arc through the
/// upper half plane between the ends of the law: there propagating waves decay, and with them the
/// narrow resonances that the function has on the real axis near grazing incidence.
struct ThicknessArc {
    std::vector<std::complex<double>> thickness_nm, weights;
};
ThicknessArc thickness_arc(double mean_nm, const ThicknessSpread& spread);

}  // namespace nacre::optics
