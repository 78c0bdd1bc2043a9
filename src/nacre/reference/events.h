#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "nacre/reference/medium.h"
#include "nacre/reference/random_stream.h"

// What random walks do when they meet something: the draws that every walk through a paint shares,
// whatever it follows (depth alone here, places in space in volume/).
//
// A walk carries a weight per wavelength, whose mean is what remains of the unit of power. An event
// of probability P_i at wavelength i is drawn with the weighted mean probability
// sum(w_i P_i) / sum(w_i), and multiplies w_i by P_i over that. This is the balance heuristic over
// the walks of each wavelength by itself, so that no weight exceeds the number of wavelengths.
//                                                                                  [wilkie-2014]

namespace nacre::reference {

/// Below this cosine a direction in a flat layer is taken to stay there for ever; a walk meets such
/// a direction with a probability of the same order.
inline constexpr double kHorizontal = 1e-12;

/// A walk that takes longer is given up with an error. Light crosses a layer that does not absorb
/// after some square of its optical depth: 3000 is within reach.
inline constexpr std::uint64_t kMostFlights = 20'000'000;

/// A walk whose mean weight is below this goes on by lot.
inline constexpr double kRouletteThreshold = 0.1;

/// Gives up a walk that is still in the paint after kMostFlights.
[[noreturn]] void throw_endless_walk();

inline bool is_dark(const Lanes& lanes) { return lane_max(lanes) <= 0; }

/// exp(-depth) in the lanes in use, zero in the others.
inline Lanes attenuation(const Lanes& depth, int lane_count) {
    Lanes result{};
    for (int i = 0; i < lane_count; ++i) result[i] = std::exp(-depth[i]);
    return result;
}

/// Upward normal of a flake, z being the normal of the layer.
inline Direction3 sample_beckmann_normal(double alpha, RandomStream& random) {
    const auto [radius, c, s] = random.slope();
    const double slope = alpha * radius;
    return Direction3(-slope * c, -slope * s, 1).normalized();
}

/// The inversion of Henyey and Greenstein's phase function, without its cancellation at small g.
Direction3 sample_henyey_greenstein(const Direction3& in, double g, RandomStream& random);

/// Direction about z with a density proportional to its cosine: Lambert's law.
inline Direction3 sample_lambert(RandomStream& random) {
    const double sine_sq = random.uniform();
    const auto [c, s] = random.cos_sin();
    const double sine = std::sqrt(sine_sq);
    return {sine * c, sine * s, std::sqrt(1 - sine_sq)};
}

enum class FlakeEvent { reflected, passed, absorbed };

/// Light meets a flake of this R and T: it is reflected or goes straight on, by lot; what the flake
/// absorbs lightens it. The weight is of no use after `absorbed`.
inline FlakeEvent draw_flake_event(const Lanes& reflectance, const Lanes& transmittance,
                                   Lanes& weight, RandomStream& random) {
    const Lanes reflected = weight * reflectance;
    const Lanes passed = weight * transmittance;
    const double sum_reflected = lane_sum(reflected), sum_passed = lane_sum(passed);
    const double sum = sum_reflected + sum_passed;
    if (sum <= 0) return FlakeEvent::absorbed;
    if (random.uniform() * sum < sum_reflected) {
        weight = reflected * (sum / sum_reflected);
        return FlakeEvent::reflected;
    }
    weight = passed * (sum / sum_passed);
    return FlakeEvent::passed;
}
/// The same for a flake met under this cosine.
inline FlakeEvent draw_flake_event(const FlakeOptics& optics, double cosine, Lanes& weight,
                                   RandomStream& random) {
    return draw_flake_event(optics.reflectance(cosine), optics.transmittance(cosine), weight,
                            random);
}

/// Light that travels along `travel` off a mirror, of which `projection` is travel.normal.
inline Direction3 mirrored(const Direction3& travel, double projection, const Direction3& normal) {
    return (travel - 2 * projection * normal).normalized();
}

/// Light meets a candidate of slab.pigment_rate_per_um: the pigment that scatters it, by lot, or
/// none if the candidate was none.
const Pigment* draw_pigment(const Slab& slab, Lanes& weight, RandomStream& random);

/// Russian roulette by the mean weight over the lanes in use, which keeps the mean.
/// @return false if the walk ends here
inline bool survives_roulette(Lanes& weight, int lane_count, RandomStream& random) {
    const double mean = lane_sum(weight) / lane_count;
    if (mean >= kRouletteThreshold) return true;
    if (random.uniform() * kRouletteThreshold >= mean) return false;
    weight *= kRouletteThreshold / mean;
    return true;
}

}  // namespace nacre::reference
