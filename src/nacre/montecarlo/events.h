#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "nacre/core/random.h"
#include "nacre/montecarlo/medium.h"

namespace nacre::montecarlo {

/// The random numbers of one block of walks.
class RandomStream {
 public:
    /// Streams whose (seed, experiment, block) differ are uncorrelated.
    RandomStream(std::uint64_t seed, std::uint64_t experiment, std::uint64_t block)
        : rng_(seed, hash_of(experiment, block)) {}

    /// Uniform in [0, 1).
    double uniform() { return rng_.uniform_double(); }
    /// Exponential with mean 1.
    double exponential() { return exponential_of(uniform()); }
    /// A point on the unit circle.
    std::tuple<double, double> cos_sin() { return cos_sin_of(uniform()); }

    /// Two numbers uniform in [0, 1), the first pair of which may come from outside: lead_with().
    std::array<double, 2> pair() {
        if (!has_lead_) {
            const double a = uniform();
            return {a, uniform()};
        }
        has_lead_ = false;
        return lead_;
    }
    /// Two Gaussian numbers of variance 1/2, as radius and direction: the slopes of a flake. Made
    /// from pair().
    struct Slope {
        double radius, cos, sin;
    };
    Slope slope() {
        const auto [a, b] = pair();
        const auto [c, s] = cos_sin_of(b);
        return {std::sqrt(exponential_of(a)), c, s};
    }
    /// The first pair(), uniform in [0, 1): numbers stratified over many walks reduce the noise of
    /// what is drawn from it, and of all that depends on that.
    void lead_with(double a, double b) {
        lead_ = {a, b};
        has_lead_ = true;
    }

 private:
    static double exponential_of(double u) { return -std::log(1 - u); }
    static std::tuple<double, double> cos_sin_of(double u) {
        const double phi = 2 * std::numbers::pi * u;
        return {std::cos(phi), std::sin(phi)};
    }

    Rng rng_;
    std::array<double, 2> lead_{};
    bool has_lead_ = false;
};

// The random draws at flakes and pigments, shared by all walks through a paint, whether they follow
// depth alone or positions in space.
//
// A walk carries a weight per wavelength, whose mean is what remains of the unit of power. An event
// of probability P_i at wavelength i is drawn with the weighted mean probability
// sum(w_i P_i) / sum(w_i), and multiplies w_i by P_i over that. This is the balance heuristic over
// the walks of each wavelength by itself, so that no weight exceeds the number of wavelengths.
//                                                                                  [wilkie-2014]

/// Below this cosine a direction in a flat layer is taken to stay there for ever; a walk meets such
/// a direction with a probability of the same order.
inline constexpr double kHorizontal = 1e-12;

/// A walk that takes longer is given up with an error. Light crosses a layer that does not absorb
/// after some square of its optical depth: 3000 is within reach.
inline constexpr std::uint64_t kMaxFlights = 20'000'000;

/// A walk whose mean weight is below this goes on at random.
inline constexpr double kRouletteThreshold = 0.1;

/// Gives up a walk that is still in the paint after kMaxFlights, or that the user interrupts: a walk
/// may take seconds.
/// @throws Error, Stopped
void check_patience(std::uint64_t flights);

/// To be called before each flight.
inline void count_flight(std::uint64_t flights) {
    constexpr std::uint64_t kCheckInterval = 1 << 10;
    if (flights % kCheckInterval == 0) check_patience(flights);
}

inline bool is_dark(const Lanes& lanes) { return lane_max(lanes) <= 0; }

/// exp(-depth) in the lanes in use, zero in the others.
inline Lanes attenuation(const Lanes& depth, int lane_count) {
    Lanes result{};
    for (int i = 0; i < lane_count; ++i) result[i] = std::exp(-depth[i]);
    return result;
}

/// Upward normal of a flake, z being the normal of the layer.
/// @param lean  of the flakes, if they do
inline Vec3d sample_beckmann_normal(double alpha, const std::optional<FlakeFrame>& lean,
                                    RandomStream& random) {
    const auto [radius, c, s] = random.slope();
    const double slope = alpha * radius;
    const Vec3d normal = normalize(Vec3d{-slope * c, -slope * s, 1});
    return lean ? lean->from_flakes(normal) : normal;
}

/// The inversion of Henyey and Greenstein's phase function, without its cancellation at small g.
Vec3d sample_henyey_greenstein(const Vec3d& in, double g, RandomStream& random);

/// The direction into which a pigment turns light. Where its phase function depends on wavelength,
/// the weight becomes that of each lane over the mean of all: their sum stays.
/// @param weight  of the lanes, not all zero
Vec3d sample_pigment(const Pigment& pigment, const Vec3d& in, Lanes& weight, RandomStream& random);

/// Direction about z with a density proportional to its cosine: Lambert's law.
inline Vec3d sample_lambert(RandomStream& random) {
    const double sine_sq = random.uniform();
    const auto [c, s] = random.cos_sin();
    const double sine = std::sqrt(sine_sq);
    return {sine * c, sine * s, std::sqrt(1 - sine_sq)};
}

enum class FlakeEvent { reflected, transmitted, absorbed };

/// Light meets a flake of this R and T: it is reflected or goes straight on, at random; absorption
/// reduces the weight. The weight is of no use after `absorbed`.
inline FlakeEvent draw_flake_event(const Lanes& reflectance, const Lanes& transmittance,
                                   Lanes& weight, RandomStream& random) {
    const Lanes reflected = weight * reflectance;
    const Lanes transmitted = weight * transmittance;
    const double sum_reflected = lane_sum(reflected), sum_transmitted = lane_sum(transmitted);
    const double sum = sum_reflected + sum_transmitted;
    if (sum <= 0) return FlakeEvent::absorbed;
    if (random.uniform() * sum < sum_reflected) {
        weight = reflected * (sum / sum_reflected);
        return FlakeEvent::reflected;
    }
    weight = transmitted * (sum / sum_transmitted);
    return FlakeEvent::transmitted;
}

/// The direction of light after specular reflection; `projection` is travel.normal.
inline Vec3d specular_direction(const Vec3d& travel, double projection, const Vec3d& normal) {
    return normalize(travel - 2 * projection * normal);
}

/// Light meets a candidate of slab.pigment_rate_per_um: the pigment that scatters it, at random, or
/// null if the candidate is not real.
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

}  // namespace nacre::montecarlo
