#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "nacre/core/rng.h"

namespace nacre::reference {

/// The random numbers of one block of walks.
class RandomStream {
 public:
    /// Streams whose (seed, experiment, block) differ share nothing visible.
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
    /// The first pair(), uniform in [0, 1): well spread over many walks they make the noise of what
    /// is drawn from it, and of what follows from that, small.
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

}  // namespace nacre::reference
