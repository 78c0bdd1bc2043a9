#include "nacre/reference/reference.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/reference/walk.h"

namespace nacre::reference {
namespace {

// Walks are cut into blocks with a stream of random numbers each; the cut depends on nothing but
// the number of walks.
constexpr std::uint64_t kMostBlocks = 1024;
constexpr std::uint64_t kSmallestBlock = 64;

Direction3 unit_vector(const Direction& direction) {
    const double theta = direction.theta_deg * std::numbers::pi / 180;
    const double phi = direction.phi_deg * std::numbers::pi / 180;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

void check(std::span<const Direction> directions, const char* which) {
    for (const Direction& d : directions) {
        if (!(d.theta_deg >= 0 && d.theta_deg < 90)) {
            throw DomainError(fmt::format("theta of the {} direction = {} is outside [0, 90) deg",
                                          which, d.theta_deg));
        }
        if (!std::isfinite(d.phi_deg)) {
            throw DomainError(
                fmt::format("phi of the {} direction = {} is not finite", which, d.phi_deg));
        }
    }
}

void check(const layers::Recipe& recipe, std::span<const double> wavelengths_nm,
           const ReferenceSettings& settings) {
    layers::validate(recipe, {wavelengths_nm.begin(), wavelengths_nm.end()});
    constexpr std::uint64_t kMostSamples = 1'000'000'000'000'000;
    if (settings.samples < 2 || settings.samples > kMostSamples) {
        throw DomainError(
            fmt::format("samples = {} is outside [2, {}]", settings.samples, kMostSamples));
    }
}

/// Runs of neighbouring wavelengths that one walk can carry: the binder refracts them alike.
std::vector<std::span<const double>> batches(const layers::Recipe& recipe,
                                             std::span<const double> wavelengths_nm) {
    const auto index = [&](std::size_t i) { return recipe.binder.index(wavelengths_nm[i]); };
    std::vector<std::span<const double>> result;
    for (std::size_t first = 0, last; first < wavelengths_nm.size(); first = last) {
        last = first + 1;
        while (last < wavelengths_nm.size() && last - first < kLanes && index(last) == index(first))
            ++last;
        result.push_back(wavelengths_nm.subspan(first, last - first));
    }
    return result;
}

/// Sums of a random variable and of its square over walks.
struct Moments {
    std::vector<Lanes> sum, sum_of_squares;

    explicit Moments(std::size_t count) : sum(count), sum_of_squares(count) {}

    void add(std::size_t i, const Lanes& x) {
        sum[i] += x;
        sum_of_squares[i] += x * x;
    }
    void add(const Moments& other) {
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += other.sum[i];
            sum_of_squares[i] += other.sum_of_squares[i];
        }
    }
    Estimate estimate(std::size_t i, int lane, std::uint64_t samples) const {
        const double n = static_cast<double>(samples);
        const double mean = sum[i][lane] / n;
        const double variance = (sum_of_squares[i][lane] / n - mean * mean) * n / (n - 1);
        return {mean, std::sqrt(std::max(0.0, variance) / n)};  // < 0 by rounding alone
    }
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
    std::span<const Connection> connections;  // used by all walks if the interface is smooth
    ReferenceSettings settings;
    std::uint64_t stream;

    /// Moments of the radiance per eye, then of the power reflected and absorbed below.
    std::size_t quantity_count() const { return towards_eyes.size() + 2; }
    std::uint64_t block_count() const {
        return std::clamp<std::uint64_t>(settings.samples / kSmallestBlock, 1, kMostBlocks);
    }

    void run_block(std::uint64_t block, Moments& moments) const {
        RandomStream random(settings.seed, stream, block);
        WalkTally tally;
        tally.radiance.resize(towards_eyes.size());
        std::vector<Connection> own_connections;
        const std::uint64_t quotient = settings.samples / block_count();
        const std::uint64_t count = quotient + (block < settings.samples % block_count() ? 1 : 0);
        for (std::uint64_t i = 0; i < count; ++i) {
            tally.clear();
            if (interface.scatters()) {
                own_connections.clear();
                for (const Direction3& eye : towards_eyes)
                    own_connections.emplace_back(interface.connect(eye, random), medium);
            }
            walk(medium, interface, towards_light,
                 interface.scatters() ? own_connections : connections, settings.part, random,
                 tally);
            for (std::size_t j = 0; j < tally.radiance.size(); ++j)
                moments.add(j, tally.radiance[j]);
            moments.add(tally.radiance.size(), tally.reflected);
            moments.add(tally.radiance.size() + 1, tally.absorbed_by_substrate);
        }
    }

    /// All blocks. The tree of partial sums is fixed by their number, hence also the rounding.
    Moments run(Ticker& ticker) const {
        using Range = tbb::blocked_range<std::uint64_t>;
        return tbb::parallel_deterministic_reduce(
            Range(0, block_count(), 1), Moments(quantity_count()),
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
};

/// Runs every experiment and hands its moments to  sink(incident, first wavelength, medium,
/// moments).
template <class Sink>
void run_all(const layers::Recipe& recipe, std::span<const Direction> incident,
             std::span<const Direction> outgoing, std::span<const double> wavelengths_nm,
             const ReferenceSettings& settings, const Progress& progress, Sink&& sink) {
    check(incident, "incident");
    check(outgoing, "outgoing");
    check(recipe, wavelengths_nm, settings);
    std::vector<Direction3> towards_eyes;
    for (const Direction& direction : outgoing) towards_eyes.push_back(unit_vector(direction));

    const auto all_batches = batches(recipe, wavelengths_nm);
    const double experiments = static_cast<double>(incident.size() * all_batches.size());
    std::optional<Ticker> ticker;
    std::uint64_t stream = 0;
    for (const std::span<const double>& batch : all_batches) {
        const Medium medium(recipe, batch);
        const auto interface = make_air_interface(recipe, medium.index);
        std::vector<Connection> connections;
        if (!interface->scatters()) {
            RandomStream unused(0, 0, 0);
            for (const Direction3& eye : towards_eyes)
                connections.emplace_back(interface->connect(eye, unused), medium);
        }
        for (std::size_t i = 0; i < incident.size(); ++i) {
            const Experiment experiment{medium,       *interface,  unit_vector(incident[i]),
                                        towards_eyes, connections, settings,
                                        stream++};
            if (!ticker) {
                ticker.emplace(progress,
                               experiments * static_cast<double>(experiment.block_count()));
            }
            const Moments moments = experiment.run(*ticker);
            if (ticker->stopped())
                throw Error("the reference was stopped before its random walks were done");
            sink(i, static_cast<std::size_t>(batch.data() - wavelengths_nm.data()), medium,
                 *interface, moments);
        }
    }
}

}  // namespace

std::vector<Estimate> reference_brdf(const layers::Recipe& recipe,
                                     std::span<const Direction> incident,
                                     std::span<const Direction> outgoing,
                                     std::span<const double> wavelengths_nm,
                                     const ReferenceSettings& settings, const Progress& progress) {
    std::vector<Estimate> result(incident.size() * outgoing.size() * wavelengths_nm.size());
    run_all(recipe, incident, outgoing, wavelengths_nm, settings, progress,
            [&](std::size_t i, std::size_t first_wavelength, const Medium& medium,
                const AirInterface&, const Moments& moments) {
                for (std::size_t j = 0; j < outgoing.size(); ++j) {
                    for (int lane = 0; lane < medium.lane_count; ++lane) {
                        result[(i * outgoing.size() + j) * wavelengths_nm.size() +
                               first_wavelength + lane] =
                            moments.estimate(j, lane, settings.samples);
                    }
                }
            });
    return result;
}

std::vector<Albedo> reference_albedo(const layers::Recipe& recipe,
                                     std::span<const Direction> incident,
                                     std::span<const double> wavelengths_nm,
                                     const ReferenceSettings& settings, const Progress& progress) {
    ReferenceSettings all_light = settings;
    all_light.part = Part::total;
    std::vector<Albedo> result(incident.size() * wavelengths_nm.size());
    run_all(recipe, incident, {}, wavelengths_nm, all_light, progress,
            [&](std::size_t i, std::size_t first_wavelength, const Medium& medium,
                const AirInterface& interface, const Moments& moments) {
                const double mirror = interface.outer_reflectance(unit_vector(incident[i]).z());
                for (int lane = 0; lane < medium.lane_count; ++lane) {
                    Albedo& albedo = result[i * wavelengths_nm.size() + first_wavelength + lane];
                    albedo.reflectance = moments.estimate(0, lane, settings.samples);
                    albedo.reflectance.mean += mirror;
                    albedo.absorbed_by_substrate = moments.estimate(1, lane, settings.samples);
                }
            });
    return result;
}

}  // namespace nacre::reference
