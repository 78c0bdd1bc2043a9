#pragma once

// The Beckmann distribution of flake normals: Gaussian slopes, two-sided flakes.
//
// D(m) is even and its integral over the whole sphere is 1. It is the microfacet Beckmann
// distribution D_B times |cos m| / 2: a microfacet surface counts facets per projected area, a
// flake medium counts them per flake area.                      [ergun-2016; jakob-2010, sec. 5]

namespace nacre::flakes {

/// D as a function of tan^2 of the angle between flake normal and surface normal, in 1/sr.
/// @param alpha  roughness, sqrt(2) times the standard deviation of a slope component; > 0
double flake_density(double tan2, double alpha);

/// s(mu) = Int |w.m| D(m) dm: the projected area of the flakes, per flake area, seen under the
/// cosine mu. s(1) = sqrt(pi)/alpha erfcx(1/alpha); s ~ mu s(1) for mu >> alpha.
/// Relative error below 1e-9 for alpha in [0.005, 2], mu in [0, 1].
double projected_area(double mu, double alpha);

/// Nodes for integrals over flake normals m ~ D: sum of weight f(cosine) approximates
/// Int f(|w.m|) |w.m| D(m) dm for smooth f.
/// Calls visit(cosine, weight) for every node; weights are positive and sum to s(mu).
template <class Visit>
void for_each_normal(double mu, double alpha, Visit&& visit);

}  // namespace nacre::flakes

#include "nacre/flakes/beckmann_inl.h"
