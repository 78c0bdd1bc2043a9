#pragma once

#include <optional>

#include "nacre/reference/medium.h"
#include "nacre/reference/random_stream.h"
#include "nacre/volume/radial_ray.h"

// The way to the next candidate on a piece of ray within one layer.

namespace nacre::volume {

/// Candidates per um of path under this cosine with the radial direction: flakes by
/// candidate_area(), pigments by their largest scattering coefficient.
double candidate_rate(const reference::Slab& slab, double cosine);

struct Candidate {
    double distance_um;
    double lot;  ///< uniform in [0, candidate_rate) at its place: which of them it is
};

/// Unbiased: tentative candidates follow each other at the largest rate on the piece, which is that
/// at one of its ends, and count with the ratio of the local rate to it.
///                                                                 [woodcock-1965; novak-2018]
/// @return empty if the light gets to the end of the piece, `length_um` away
std::optional<Candidate> fly_delta(const reference::Slab& slab, const RadialRay& ray,
                                   double length_um, reference::RandomStream& random);

/// By the optical depth of candidates, integrated by a composite Simpson rule of `panels` panels,
/// and inverted: within a panel the rate is the parabola that the rule integrates. The error falls
/// with the fourth power of the panels' width; where the rate is constant, there is none.
std::optional<Candidate> fly_simpson(const reference::Slab& slab, const RadialRay& ray,
                                     double length_um, int panels, reference::RandomStream& random);

/// Optical depth of the candidates on the piece, by the same rule.
double simpson_depth(const reference::Slab& slab, const RadialRay& ray, double length_um,
                     int panels);

}  // namespace nacre::volume
