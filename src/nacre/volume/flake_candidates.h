#pragma once

#include <cmath>
#include <numbers>

#include "nacre/reference/medium.h"
#include "nacre/reference/random_stream.h"

// Flakes that a ray may meet, at a rate that has a closed form.
//
// The exact rate is c E[|w.m|] with m the unit normal of slopes (p, q). We take |w.m| / m_z
// instead, which is |mu - s p| if p is the slope along the ray: as if the flakes had the projected
// area of their own a / m_z. Its mean is that of a folded Gaussian, and the normal of such a
// candidate can be drawn well at any angle. A candidate is then real with the probability m_z. No
// table, no bias.

namespace nacre::volume {

/// E[|mu - s p|] for p Gaussian of standard deviation alpha / sqrt(2), s the sine of mu. Even, and
/// increasing with |mu| for alpha < sqrt(2), which makes its value at one end of a ray a majorant.
inline double candidate_area(double mu, double alpha) {
    const double sine_sq = std::fmax(0.0, 1 - mu * mu);
    const double width_sq = alpha * alpha * sine_sq;
    constexpr double kFar = 36;  // erfc(6) = 2e-17: no flake is seen from its other side
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
                                        reference::RandomStream& random) {
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

}  // namespace nacre::volume
