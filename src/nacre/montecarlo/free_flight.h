#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "nacre/montecarlo/events.h"
#include "nacre/montecarlo/medium.h"

// A straight piece of ray among concentric spheres, by its height over the place where it starts.
// Heights are never differences of radii, so that layers of micrometres on a sphere of any size
// keep all digits; curvature 0 is a flat layer.

namespace nacre::montecarlo {

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

// Flakes that a ray may meet, at a rate that has a closed form.
//
// The exact rate is c E[|w.m|] with m the unit normal of slopes (p, q). We take |w.m| / m_z
// instead, the projected area of flakes of area a / m_z: |mu - s p| if p is the slope along the
// ray. Its mean is that of a folded Gaussian, and the normal of such a candidate is drawn
// efficiently at any angle. A candidate is then real with the probability m_z. No table, no bias.

/// E[|mu - s p|] for p Gaussian of standard deviation alpha / sqrt(2), s the sine of mu. Even, and
/// increasing with |mu| for alpha < sqrt(2), which makes its value at one end of a ray a majorant.
inline double candidate_area(double mu, double alpha) {
    const double sine_sq = std::fmax(0.0, 1 - mu * mu);
    const double width_sq = alpha * alpha * sine_sq;
    constexpr double kFar = 36;  // erfc(6) = 2e-17: no flake is seen from behind
    const double cosine = std::abs(mu);
    if (mu * mu >= kFar * width_sq) return cosine;
    const double x = cosine / std::sqrt(width_sq);
    return cosine * std::erf(x) + std::sqrt(width_sq / std::numbers::pi) * std::exp(-x * x);
}

/// Slopes of a candidate, along the ray and across it.
struct CandidateSlopes {
    double along, across;
};

/// Density proportional to |mu - s p| exp(-(p^2 + q^2) / alpha^2): q is Gaussian, and p is drawn
/// from (|mu| + s |p|) exp(-p^2 / alpha^2) and kept with the ratio of the two.
inline CandidateSlopes sample_candidate(double mu, double sine, double alpha,
                                        RandomStream& random) {
    const double cosine = std::abs(mu);
    const double flat = std::sqrt(std::numbers::pi) * cosine, tilted = alpha * sine;
    for (;;) {
        const auto [radius, c, s] = random.slope();
        double along = alpha * radius * c;
        const double across = alpha * radius * s;
        if (random.uniform() * (flat + tilted) >= flat) {
            along = std::copysign(alpha * std::sqrt(random.exponential()), along);
        }
        const double visible = std::abs(mu - sine * along);
        if (random.uniform() * (cosine + sine * std::abs(along)) < visible) return {along, across};
    }
}

// The way to the next candidate on a piece of ray within one layer.

/// Candidates per um of path under this cosine with the radial direction: flakes by
/// candidate_area(), pigments by their largest scattering coefficient.
double candidate_rate(const Slab& slab, double cosine);

struct Candidate {
    double distance_um;
    double choice;  ///< uniform in [0, candidate_rate) at its place: which of them it is
};

/// Unbiased: tentative candidates follow each other at the largest rate on the piece, which is that
/// at one of its ends, and count with the ratio of the local rate to it.
///                                                                 [woodcock-1965; novak-2018]
/// @return empty if the light gets to the end of the piece, `length_um` away
std::optional<Candidate> fly_delta(const Slab& slab, const RadialRay& ray, double length_um,
                                   RandomStream& random);

/// By the optical depth of candidates, integrated by a composite Simpson rule of `panels` panels,
/// and inverted: within a panel the rate is the parabola that the rule integrates. The error falls
/// with the fourth power of the panels' width; where the rate is constant, there is none.
std::optional<Candidate> fly_simpson(const Slab& slab, const RadialRay& ray, double length_um,
                                     int panels, RandomStream& random);

/// Optical depth of the candidates on the piece, by the same rule.
double simpson_depth(const Slab& slab, const RadialRay& ray, double length_um, int panels);

}  // namespace nacre::montecarlo
