#include "nacre/reference/experiment.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace nacre::reference {
namespace {

// Some blocks have a few walks more.
constexpr std::uint64_t kWalksPerBlock = 256;

}  // namespace

Moments::Moments(std::size_t eye_count) : sum_(eye_count + 2), sum_of_squares_(eye_count + 2) {}

void Moments::add(const WalkTally& tally) {
    for (std::size_t j = 0; j < eye_count(); ++j) add(j, tally.radiance[j]);
    add(eye_count(), tally.reflected);
    add(eye_count() + 1, tally.absorbed_by_substrate);
}

void Moments::add(const Moments& other) {
    for (std::size_t i = 0; i < sum_.size(); ++i) {
        sum_[i] += other.sum_[i];
        sum_of_squares_[i] += other.sum_of_squares_[i];
    }
}

void Moments::add(std::size_t i, const Lanes& x) {
    sum_[i] += x;
    sum_of_squares_[i] += x * x;
}

Estimate Moments::estimate(std::size_t i, int lane, std::uint64_t samples) const {
    const double n = static_cast<double>(samples);
    const double mean = sum_[i][lane] / n;
    const double variance = (sum_of_squares_[i][lane] / n - mean * mean) * n / (n - 1);
    return {mean, std::sqrt(std::max(0.0, variance) / n)};  // < 0 by rounding alone
}

std::uint64_t Experiment::block_count(std::uint64_t samples) {
    return std::max<std::uint64_t>(samples / kWalksPerBlock, 1);
}

void Experiment::run_block(std::uint64_t block, Moments& moments) const {
    RandomStream random(settings.seed, number, block);
    WalkTally tally;
    tally.radiance.resize(towards_eyes.size());
    std::vector<Connection> own_connections;
    const std::uint64_t blocks = block_count(settings.samples);
    const std::uint64_t count =
        settings.samples / blocks + (block < settings.samples % blocks ? 1 : 0);
    for (std::uint64_t i = 0; i < count; ++i) {
        tally.clear();
        if (interface.scatters()) {
            own_connections.clear();
            for (const Direction3& eye : towards_eyes)
                own_connections.emplace_back(interface.connect(eye, random), medium);
        }
        walk(medium, interface, towards_light, interface.scatters() ? own_connections : connections,
             settings.part, random, tally);
        if (interface.scatters() && settings.part == Part::total) {
            for (std::size_t j = 0; j < towards_eyes.size(); ++j) {
                tally.radiance[j] +=
                    interface.reflect_outside(towards_light, towards_eyes[j], random);
            }
        }
        moments.add(tally);
    }
}

// The tree of partial sums is fixed by the number of blocks, and so is the rounding.
Moments Experiment::run(Ticker& ticker) const {
    using Range = tbb::blocked_range<std::uint64_t>;
    return tbb::parallel_deterministic_reduce(
        Range(0, block_count(settings.samples), 1), Moments(towards_eyes.size()),
        [&](const Range& range, Moments moments) {
            for (std::uint64_t block = range.begin(); block < range.end(); ++block) {
                if (ticker.stopped()) break;
                run_block(block, moments);
                ticker.tick();
            }
            return moments;
        },
        [](Moments left, const Moments& right) {
            left.add(right);
            return left;
        });
}

}  // namespace nacre::reference
