#pragma once

#include <vector>

// A round solid angle about a direction, as an instrument's lamp or detector fills it.

namespace nacre::measure {

/// One direction of a rule.
struct ConeNode {
    double theta = 0, phi = 0;  ///< rad
    double weight = 0;          ///< of its projected solid angle; all of a rule sum to 1
};

/// A rule for the mean over a cone, weighted with the cosine: `rings` Gauss-Legendre nodes in the
/// solid angle times 4 `rings` equal steps around, exact for polynomials of degree 4 rings - 1 in
/// the directions of a small cone. Nodes below the horizon are left out. A half angle of 0 gives
/// the direction itself.
/// @param half_angle  rad, >= 0
/// @param theta, phi  of the axis, rad, theta in [0, pi/2)
/// @param rings  >= 1
std::vector<ConeNode> cone_rule(double theta, double phi, double half_angle, int rings);

}  // namespace nacre::measure
