#pragma once

// How many nodes Gauss's rule needs for the mean over a film's thickness. Its error falls like
// rho^(-2 n), rho being the half-axis sum of the largest ellipse around the range of integration
// inside which R is analytic [trefethen-2013, theorem 19.3]; so the nearest pole of R decides.

namespace nacre::optics {

inline constexpr int kMostNodesPerFilm = 768;

/// For a film in which waves run. As a function of its phase, in [-half_phase, half_phase], R has
/// its nearest pole where the amplitude after a round trip, p e^(Im phase), reaches 1.
/// @param p             largest amplitude after a round trip, in [0, 1]
/// @param target_error  relative error aimed at, in (0, 1)
/// @return  in [1, kMostNodesPerFilm], rounded up so that few different counts occur
int nodes_for_wave(double half_phase, double p, double target_error);

/// For a film beyond its critical angle, where waves decay by `decay_per_nm` and nothing resonates:
/// the pole is at thickness 0, outside [lo, hi].
int nodes_for_decay(double lo_nm, double hi_nm, double decay_per_nm, double target_error);

}  // namespace nacre::optics
