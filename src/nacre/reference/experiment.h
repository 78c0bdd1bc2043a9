#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/reference/walk.h"

// Many walks from one direction, and the statistics of what they found.

namespace nacre::reference {

/// Sums of what walks contributed, and of its square.
class Moments {
 public:
    explicit Moments(std::size_t eye_count);

    void add(const WalkTally& tally);
    void add(const Moments& other);

    std::size_t eye_count() const { return sum_.size() - 2; }
    Estimate radiance(std::size_t eye, int lane, std::uint64_t samples) const {
        return estimate(eye, lane, samples);
    }
    Estimate reflected(int lane, std::uint64_t samples) const {
        return estimate(eye_count(), lane, samples);
    }
    Estimate absorbed_by_substrate(int lane, std::uint64_t samples) const {
        return estimate(eye_count() + 1, lane, samples);
    }

 private:
    void add(std::size_t i, const Lanes& x);
    Estimate estimate(std::size_t i, int lane, std::uint64_t samples) const;

    // Of the radiance per eye, then of the power reflected, then of that absorbed below.
    std::vector<Lanes> sum_, sum_of_squares_;
};

/// Counts blocks and asks the caller whether to go on.
class Ticker {
 public:
    Ticker(const Progress& progress, double total) : progress_(progress), total_(total) {}

    void tick() {
        if (!progress_) return;
        const std::scoped_lock lock(mutex_);
        if (!stopped_ && !progress_(++done_ / total_)) stopped_ = true;
    }
    bool stopped() const { return stopped_; }

 private:
    const Progress& progress_;
    double total_, done_ = 0;
    std::mutex mutex_;
    std::atomic<bool> stopped_ = false;
};

/// What walks from one direction at one batch of wavelengths are about.
struct Experiment {
    const Medium& medium;
    const AirInterface& interface;
    Direction3 towards_light;
    std::span<const Direction3> towards_eyes;
    std::span<const Connection> connections;  ///< one per eye if the interface is smooth, else none
    ReferenceSettings settings;
    std::uint64_t number;  ///< among the experiments of one call

    /// Walks are cut into blocks with a stream of random numbers each; the cut depends on nothing
    /// but the number of walks.
    static std::uint64_t block_count(std::uint64_t samples);

    /// All walks; a part of them if `ticker` is stopped. Ticks once for each block.
    Moments run(Ticker& ticker) const;

 private:
    void run_block(std::uint64_t block, Moments& moments) const;
};

}  // namespace nacre::reference
