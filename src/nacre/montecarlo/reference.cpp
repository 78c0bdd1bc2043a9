#include "nacre/montecarlo/reference.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/montecarlo/depth_walk.h"

// Many walks from one direction, and the statistics of what they found.

namespace nacre::montecarlo {

/// Sums of what walks contributed, and of its square.
class Moments {
 public:
    explicit Moments(std::size_t detector_count);

    void add(const WalkTally& tally);
    void add(const Moments& other);

    std::size_t detector_count() const { return sum_.size() - 2; }
    Estimate radiance(std::size_t detector, int lane, std::uint64_t samples) const {
        return estimate(detector, lane, samples);
    }
    Estimate reflected(int lane, std::uint64_t samples) const {
        return estimate(detector_count(), lane, samples);
    }
    Estimate absorbed_by_substrate(int lane, std::uint64_t samples) const {
        return estimate(detector_count() + 1, lane, samples);
    }

 private:
    void add(std::size_t i, const Lanes& x);
    Estimate estimate(std::size_t i, int lane, std::uint64_t samples) const;

    // Of the radiance per detector, then of the power reflected, then of that absorbed below.
    std::vector<Lanes> sum_, sum_of_squares_;
};

/// The walks of one incident direction at one batch of wavelengths.
struct Experiment {
    const Medium& medium;
    const AirInterface& interface;
    Vec3d towards_light;
    std::span<const Vec3d> towards_detectors;
    std::span<const Connection> connections;  ///< one per detector; none if the interface scatters
    ReferenceSettings settings;
    std::uint64_t number;  ///< among the experiments of one call

    /// Walks are cut into blocks with a stream of random numbers each; the cut depends on nothing
    /// but the number of walks.
    static std::uint64_t block_count(std::uint64_t samples);

    /// All walks. Reports each block.
    /// @throws Stopped if `blocks` is stopped; in the last of them a part of the walks may be missing
    Moments run(SharedProgress& blocks) const;

 private:
    void run_block(std::uint64_t block, Moments& moments, SharedProgress& counter) const;
};

namespace {

// More detectors than this are served by walks of their own, to bound memory.
constexpr std::size_t kMaxDetectorsPerWalk = 1024;

[[noreturn]] void throw_stopped() {
    throw Stopped("the reference was stopped before its random walks were done");
}

Vec3d unit_vector(const Direction& direction) {
    const double theta = direction.theta_deg * kDegree;
    const double phi = direction.phi_deg * kDegree;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

void check(std::span<const Direction> directions, const char* which) {
    for (const Direction& d : directions) {
        if (!kPolarAngleRange.contains(d.theta_deg)) {
            throw DomainError(fmt::format("theta of the {} direction = {} is outside {}", which,
                                          d.theta_deg, kPolarAngleRange.text()));
        }
        if (!std::isfinite(d.phi_deg)) {
            throw DomainError(
                fmt::format("phi of the {} direction = {} is not finite", which, d.phi_deg));
        }
    }
}

void check(const paint::Recipe& recipe, std::span<const double> wavelengths_nm,
           const ReferenceSettings& settings) {
    if (recipe.layers.empty()) {
        throw DomainError("layer: is missing; light is followed through at least one [[layer]]");
    }
    paint::validate(recipe, {wavelengths_nm.begin(), wavelengths_nm.end()});
    constexpr Range kSamples = ReferenceSettings::kSamplesRange;
    if (!kSamples.contains(static_cast<double>(settings.samples))) {
        throw DomainError(
            fmt::format("samples = {} is outside {}", settings.samples, kSamples.text()));
    }
}

/// Runs of neighbouring wavelengths that one walk can carry: the binder refracts them alike.
std::vector<std::span<const double>> batches(const paint::Recipe& recipe,
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

/// The sums of one experiment, and where its results belong.
struct Outcome {
    std::size_t incident, first_outgoing, first_wavelength;
    const Medium& medium;
    const Moments& moments;
};

/// Runs an experiment for each batch of wavelengths, group of detectors and incident direction.
template <class Sink>
void run_all(const paint::Recipe& recipe, std::span<const Direction> incident,
             std::span<const Direction> outgoing, std::span<const double> wavelengths_nm,
             const ReferenceSettings& settings, const Progress& progress, Sink&& sink) {
    check(incident, "incident");
    check(outgoing, "outgoing");
    check(recipe, wavelengths_nm, settings);
    std::vector<Vec3d> detectors;
    for (const Direction& direction : outgoing) detectors.push_back(unit_vector(direction));

    const auto all_batches = batches(recipe, wavelengths_nm);
    const std::size_t groups = std::max<std::size_t>(
        1, (detectors.size() + kMaxDetectorsPerWalk - 1) / kMaxDetectorsPerWalk);
    SharedProgress blocks(progress,
                          static_cast<double>(all_batches.size() * groups * incident.size() *
                                              Experiment::block_count(settings.samples)));
    blocks.add(0);
    std::uint64_t number = 0;
    for (const std::span<const double>& batch : all_batches) {
        Medium medium(recipe, batch, &blocks);
        const auto interface = make_air_interface(recipe, medium.index);
        // Under an interface that scatters each walk connects to each detector by a way of its own.
        if (interface->scatters()) {
            for (Slab& slab : medium.slabs) slab.tabulate_extinction();
        }
        for (std::size_t group = 0; group < groups; ++group) {
            const std::size_t first_detector = group * kMaxDetectorsPerWalk;
            const auto own_detectors = std::span(detectors).subspan(
                first_detector, std::min(kMaxDetectorsPerWalk, detectors.size() - first_detector));
            std::vector<Connection> connections;
            if (!interface->scatters()) {
                RandomStream unused(0, 0, 0);
                for (const Vec3d& detector : own_detectors)
                    connections.emplace_back(interface->connect(detector, unused), medium);
            }
            for (std::size_t i = 0; i < incident.size(); ++i) {
                const Experiment experiment{medium,        *interface,  unit_vector(incident[i]),
                                            own_detectors, connections, settings,
                                            number++};
                const Moments moments = experiment.run(blocks);
                if (blocks.stopped()) throw_stopped();
                const auto first_wavelength =
                    static_cast<std::size_t>(batch.data() - wavelengths_nm.data());
                sink(Outcome{i, first_detector, first_wavelength, medium, moments});
            }
        }
    }
}

}  // namespace

std::vector<Estimate> reference_brdf(const paint::Recipe& recipe,
                                     std::span<const Direction> incident,
                                     std::span<const Direction> outgoing,
                                     std::span<const double> wavelengths_nm,
                                     const ReferenceSettings& settings, const Progress& progress) {
    std::vector<Estimate> result(incident.size() * outgoing.size() * wavelengths_nm.size());
    run_all(recipe, incident, outgoing, wavelengths_nm, settings, progress, [&](const Outcome& o) {
        for (std::size_t j = 0; j < o.moments.detector_count(); ++j) {
            const std::size_t row = o.incident * outgoing.size() + o.first_outgoing + j;
            for (int lane = 0; lane < o.medium.lane_count; ++lane) {
                result[row * wavelengths_nm.size() + o.first_wavelength + lane] =
                    o.moments.radiance(j, lane, settings.samples);
            }
        }
    });
    return result;
}

std::vector<Albedo> reference_albedo(const paint::Recipe& recipe,
                                     std::span<const Direction> incident,
                                     std::span<const double> wavelengths_nm,
                                     const ReferenceSettings& settings, const Progress& progress) {
    ReferenceSettings all_light = settings;
    all_light.part = Part::total;
    std::vector<Albedo> result(incident.size() * wavelengths_nm.size());
    run_all(recipe, incident, {}, wavelengths_nm, all_light, progress, [&](const Outcome& o) {
        for (int lane = 0; lane < o.medium.lane_count; ++lane) {
            Albedo& albedo = result[o.incident * wavelengths_nm.size() + o.first_wavelength + lane];
            albedo.reflectance = o.moments.reflected(lane, settings.samples);
            albedo.absorbed_by_substrate = o.moments.absorbed_by_substrate(lane, settings.samples);
        }
    });
    return result;
}

namespace {

// Some blocks have a few walks more.
constexpr std::uint64_t kWalksPerBlock = 256;

}  // namespace

Moments::Moments(std::size_t detector_count)
    : sum_(detector_count + 2), sum_of_squares_(detector_count + 2) {}

void Moments::add(const WalkTally& tally) {
    for (std::size_t j = 0; j < detector_count(); ++j) add(j, tally.radiance[j]);
    add(detector_count(), tally.reflected);
    add(detector_count() + 1, tally.absorbed_by_substrate);
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
    return estimate_of_mean(sum_[i][lane], sum_of_squares_[i][lane], static_cast<double>(samples));
}

std::uint64_t Experiment::block_count(std::uint64_t samples) {
    return std::max<std::uint64_t>(samples / kWalksPerBlock, 1);
}

void Experiment::run_block(std::uint64_t block, Moments& moments, SharedProgress& counter) const {
    RandomStream random(settings.seed, number, block);
    WalkTally tally;
    tally.radiance.resize(towards_detectors.size());
    std::vector<Connection> own_connections;
    const std::uint64_t blocks = block_count(settings.samples);
    const std::uint64_t count =
        settings.samples / blocks + (block < settings.samples % blocks ? 1 : 0);
    for (std::uint64_t i = 0; i < count && counter.keep_going(); ++i) {
        tally.clear();
        if (interface.scatters()) {
            own_connections.clear();
            for (const Vec3d& detector : towards_detectors)
                own_connections.emplace_back(interface.connect(detector, random), medium);
        }
        walk(medium, interface, towards_light, interface.scatters() ? own_connections : connections,
             settings.part, random, tally);
        if (interface.scatters() && settings.part == Part::total) {
            for (std::size_t j = 0; j < towards_detectors.size(); ++j) {
                tally.radiance[j] +=
                    interface.reflect_outside(towards_light, towards_detectors[j], random);
            }
        }
        moments.add(tally);
    }
}

// The tree of partial sums is fixed by the number of blocks, and so is the rounding.
Moments Experiment::run(SharedProgress& blocks) const {
    using Range = tbb::blocked_range<std::uint64_t>;
    return tbb::parallel_deterministic_reduce(
        Range(0, block_count(settings.samples), 1), Moments(towards_detectors.size()),
        [&](const Range& range, Moments moments) {
            for (std::uint64_t block = range.begin(); block < range.end(); ++block) {
                // An error ends the tree at once; its other leaves would still add up empty sums.
                if (blocks.stopped()) throw_stopped();
                run_block(block, moments, blocks);
                blocks.add();
            }
            return moments;
        },
        [](Moments left, const Moments& right) {
            left.add(right);
            return left;
        });
}

}  // namespace nacre::montecarlo
