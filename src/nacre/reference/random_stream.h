#pragma once

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
    double exponential() { return -std::log(1 - uniform()); }
    /// A point on the unit circle.
    std::tuple<double, double> cos_sin() {
        const double phi = 2 * std::numbers::pi * uniform();
        return {std::cos(phi), std::sin(phi)};
    }

 private:
    Rng rng_;
};

}  // namespace nacre::reference
