#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/vec.h"

// What the materials of renderers have in common. Directions point away from the surface
// (docs/conventions.md); l is that of the lamp, v that of the viewer.

namespace nacre::exchange {

/// A lamp and a viewer, and their half vector h; the normal is z.
struct ShadingDirections {
    Vec3d l, v, h;
    double vh = 1;  ///< cosine of v with h
};

/// @param theta_i, theta_o  in [0, pi/2), rad
/// @param phi  phi_o - phi_i, rad
inline ShadingDirections shading_directions(double theta_i, double theta_o, double phi) {
    const Vec3d l = {std::sin(theta_i), 0, std::cos(theta_i)};
    const Vec3d v = {std::sin(theta_o) * std::cos(phi), std::sin(theta_o) * std::sin(phi),
                     std::cos(theta_o)};
    const Vec3d h = normalize(l + v);
    return {l, v, h, dot(v, h)};
}

/// The distribution of facets of Trowbridge and Reitz, in 1/sr.        [walter-2007, eq. 33]
inline double ggx_distribution(double nh, double alpha) {
    const double a2 = alpha * alpha, root = nh * nh * (a2 - 1) + 1;
    return a2 / (std::numbers::pi * root * root);
}

/// c^5 of 1 - cosine: what Schlick's approximation of Fresnel's reflectance adds.  [schlick-1994]
inline double schlick_weight(double cosine) {
    const double c = 1 - cosine;
    return c * c * c * c * c;
}

inline double max_component(const Vec3d& c) { return std::max(c.x, std::max(c.y, c.z)); }

/// Reflectance at normal incidence of the interface between two real indices.
inline double normal_reflectance(double inside, double outside) {
    const double r = (inside - outside) / (inside + outside);
    return r * r;
}

}  // namespace nacre::exchange
