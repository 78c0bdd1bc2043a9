#pragma once

namespace nacre::optics {

/// S(q) of equal hard spheres by the closure of Percus and Yevick: how much more light than from
/// independent spheres is turned by the angle theta, q = 2 k sin(theta/2), since the places of
/// neighbours are not independent. It is below 1 forwards, 1 for thin suspensions, and goes to 1 as
/// q d grows.              [percus-yevick-1958; wertheim-1963; kinning-thomas-1984, eq. 8 to 10]
///
/// S(0) = (1 - v)^4/(1 + 2 v)^2. Against simulated hard spheres its peak is some per cent too high near
/// v = 0.5, and less below [verlet-weis-1972].
///
/// @param q_diameter       q times the diameter, >= 0
/// @param volume_fraction  v, in [0, 0.5]
/// @throws DomainError naming the argument, its value and its range
double percus_yevick(double q_diameter, double volume_fraction);

}  // namespace nacre::optics
