#pragma once

#include <cmath>
#include <limits>

// A straight piece of ray among concentric spheres, by its height over the place where it starts.
// Heights are never differences of radii, so that layers of micrometres on a sphere of any size
// keep all digits; curvature 0 is a flat layer.

namespace nacre::volume {

struct RadialRay {
    double curvature;  ///< of the sphere through the start: 1 / radius, >= 0
    double cosine;     ///< of travel with the outward normal at the start

    /// The same cosine after a distance t. It increases with t, from the cosine at the start.
    double cosine_at(double t) const {
        const double along = cosine + curvature * t;
        return along / std::sqrt(1 + curvature * t * (cosine + along));
    }

    /// Height over the start after a distance t.
    double rise(double t) const {
        const double q = t * (2 * cosine + curvature * t);
        return q / (1 + std::sqrt(std::fmax(0.0, 1 + curvature * q)));
    }

    /// Distance to the sphere `height` >= 0 further out, which the ray leaves from inside; infinite
    /// if it never does (flat layers).
    double distance_outwards(double height) const {
        const double q = height * (2 + curvature * height);
        const double root = std::sqrt(cosine * cosine + curvature * q);
        if (cosine < 0) return (root - cosine) / curvature;
        return root > 0 ? q / (cosine + root) : 0;
    }

    /// Distance to the sphere `depth` >= 0 further in; infinite if the ray misses it.
    /// @param depth  less than the radius
    double distance_inwards(double depth) const {
        const double q = depth * (2 - curvature * depth);
        const double discriminant = cosine * cosine - curvature * q;
        if (!(cosine < 0) || discriminant < 0) return std::numeric_limits<double>::infinity();
        return q / (std::sqrt(discriminant) - cosine);
    }
};

}  // namespace nacre::volume
