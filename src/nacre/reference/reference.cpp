#include "nacre/reference/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/reference/experiment.h"

namespace nacre::reference {
namespace {

// More eyes than this are served by walks of their own, to bound memory.
constexpr std::size_t kMostEyesPerWalk = 1024;

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

/// What came out of one experiment, and where its numbers belong.
struct Outcome {
    std::size_t incident, first_outgoing, first_wavelength;
    const Medium& medium;
    const Moments& moments;
};

/// Runs an experiment for each batch of wavelengths, group of eyes and incident direction.
template <class Sink>
void run_all(const layers::Recipe& recipe, std::span<const Direction> incident,
             std::span<const Direction> outgoing, std::span<const double> wavelengths_nm,
             const ReferenceSettings& settings, const Progress& progress, Sink&& sink) {
    check(incident, "incident");
    check(outgoing, "outgoing");
    check(recipe, wavelengths_nm, settings);
    std::vector<Direction3> eyes;
    for (const Direction& direction : outgoing) eyes.push_back(unit_vector(direction));

    const auto all_batches = batches(recipe, wavelengths_nm);
    const std::size_t groups =
        std::max<std::size_t>(1, (eyes.size() + kMostEyesPerWalk - 1) / kMostEyesPerWalk);
    Ticker ticker(progress, static_cast<double>(all_batches.size() * groups * incident.size() *
                                                Experiment::block_count(settings.samples)));
    std::uint64_t number = 0;
    for (const std::span<const double>& batch : all_batches) {
        const Medium medium(recipe, batch);
        const auto interface = make_air_interface(recipe, medium.index);
        for (std::size_t group = 0; group < groups; ++group) {
            const std::size_t first_eye = group * kMostEyesPerWalk;
            const auto own_eyes = std::span(eyes).subspan(
                first_eye, std::min(kMostEyesPerWalk, eyes.size() - first_eye));
            std::vector<Connection> connections;
            if (!interface->scatters()) {
                RandomStream unused(0, 0, 0);
                for (const Direction3& eye : own_eyes)
                    connections.emplace_back(interface->connect(eye, unused), medium);
            }
            for (std::size_t i = 0; i < incident.size(); ++i) {
                const Experiment experiment{medium,   *interface,  unit_vector(incident[i]),
                                            own_eyes, connections, settings,
                                            number++};
                const Moments moments = experiment.run(ticker);
                if (ticker.stopped())
                    throw Error("the reference was stopped before its random walks were done");
                const auto first_wavelength =
                    static_cast<std::size_t>(batch.data() - wavelengths_nm.data());
                sink(Outcome{i, first_eye, first_wavelength, medium, moments});
            }
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
    run_all(recipe, incident, outgoing, wavelengths_nm, settings, progress, [&](const Outcome& o) {
        for (std::size_t j = 0; j < o.moments.eye_count(); ++j) {
            const std::size_t row = o.incident * outgoing.size() + o.first_outgoing + j;
            for (int lane = 0; lane < o.medium.lane_count; ++lane) {
                result[row * wavelengths_nm.size() + o.first_wavelength + lane] =
                    o.moments.radiance(j, lane, settings.samples);
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
    run_all(recipe, incident, {}, wavelengths_nm, all_light, progress, [&](const Outcome& o) {
        for (int lane = 0; lane < o.medium.lane_count; ++lane) {
            Albedo& albedo = result[o.incident * wavelengths_nm.size() + o.first_wavelength + lane];
            albedo.reflectance = o.moments.reflected(lane, settings.samples);
            albedo.absorbed_by_substrate = o.moments.absorbed_by_substrate(lane, settings.samples);
        }
    });
    return result;
}

}  // namespace nacre::reference
