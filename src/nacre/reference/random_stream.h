#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <tuple>

namespace nacre::reference {

/// Random numbers of one block of walks. The generator and its seeding are the standard library's,
/// whose output the C++ standard fixes; the standard's distributions are not fixed, so the
/// transforms stand here.
class RandomStream {
 public:
    /// Streams whose (seed, stream, block) differ are independent for all practical purposes.
    RandomStream(std::uint64_t seed, std::uint64_t stream, std::uint64_t block) {
        std::seed_seq words{seed,         seed >> 32, stream,
                            stream >> 32, block,      block >> 32};  // takes 32 bits of each
        engine_.seed(words);
    }

    /// Uniform in [0, 1).
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    /// Exponential with mean 1.
    double exponential() { return -std::log1p(-uniform()); }
    /// A point on the unit circle.
    std::tuple<double, double> cos_sin() {
        const double phi = 2 * std::numbers::pi * uniform();
        return {std::cos(phi), std::sin(phi)};
    }

 private:
    std::mt19937_64 engine_;
};

}  // namespace nacre::reference
