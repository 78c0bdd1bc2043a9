#include "nacre/fit/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/fit/effect.h"
#include "nacre/fit/search.h"
#include "nacre/solver/solver.h"

namespace nacre::fit {

namespace {

/// A number this near to its bound, as a fraction of the distance between both, is at it.
constexpr double kAtBound = 1e-3;

void check(const FitOptions& options) {
    require_in_range(options.starts, 1, FitOptions::kMaxStarts, "starts");
    require_in_range(options.equal_delta_e, 1e-3, 100, "the Delta E that counts as equal");
    require_in_range(options.matched_delta_e, 1e-3, 100, "the Delta E that counts as matched");
    if (options.noise_delta_e) {
        require_in_range(*options.noise_delta_e, 1e-6, 100, "noise in Delta E");
    }
}

/// A number that only matters elsewhere (the diameter of flakes to the mean colour, a clearcoat's
/// thickness if it absorbs nothing) cannot be found from colours.
void require_effect(const FreeNumbers& numbers, bool hot_spot, SharedProgress& work) {
    const EffectOnColours effect(numbers.start(), hot_spot, work);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (effect.of(numbers[i])) continue;
        throw DomainError(
            fmt::format("{}: {}, so that they cannot tell it", numbers[i].bounds.key, kNoEffect));
    }
}

/// With the default settings of the solver, without the reduced accuracy of the search.
measure::Measurement colours_of(const Target& target, const paint::Recipe& recipe,
                                SharedProgress& work) {
    return target.read(solver::solve(recipe, target.wavelengths_nm(Detail::fine), {}, nullptr,
                                     [&](double) { return work.keep_going(); }),
                       Detail::fine);
}

std::vector<double> values_at(const FreeNumbers& numbers, const std::vector<double>& x) {
    std::vector<double> values;
    for (std::size_t i = 0; i < numbers.size(); ++i) values.push_back(numbers[i].from_unit(x[i]));
    return values;
}

std::vector<FittedParameter> parameters_at(const FreeNumbers& numbers, const std::vector<double>& x,
                                           const Certainty& certainty) {
    std::vector<FittedParameter> parameters;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        FittedParameter parameter{
            numbers[i], numbers[i].from_unit(x[i]), {}, x[i]<kAtBound, x[i]> 1 - kAtBound};
        if (const auto& error = certainty.standard_error[i]) {
            parameter.standard_error = *error * numbers[i].slope(x[i]);
        }
        parameters.push_back(std::move(parameter));
    }
    return parameters;
}

}  // namespace

Fit fit(const measure::Measurement& standard, const FreeNumbers& numbers, const FitOptions& options,
        const Progress& progress) {
    const auto begin = std::chrono::steady_clock::now();
    check(options);
    const Target target(standard, options.target);
    paint::validate(numbers.start(), target.wavelengths_nm(Detail::fine));
    paint::require_no_lean(numbers.start(), "fits are of paints that are");
    SharedProgress work(progress, 1);
    require_effect(numbers, target.hot_spot(), work);
    ColourModel model(numbers, target, work);

    Fit out;
    out.standard = target.standard();
    // Errors of the recipe are thrown here.
    out.at_start = target.difference(colours_of(target, numbers.start(), work));

    SearchEffort effort;
    const std::vector<Descent> minima =
        search(model, numbers.start_point(), options.starts, options.seed, work, effort);
    const Descent& best = minima[0];
    const auto at_best = model.evaluate(best.x, Detail::fine);
    const auto jacobian =
        at_best ? model.central_jacobian(best.x, *at_best, Detail::fine) : std::nullopt;
    if (work.stopped()) throw Stopped(kStopped);
    if (!jacobian) throw Error(model.first_failure());
    out.certainty = certainty(at_best->values, *jacobian, numbers.size(),
                              {options.noise_delta_e, 3 * target.geometry_count(),
                               target.geometry_count(), options.equal_delta_e});

    out.noise_given = options.noise_delta_e.has_value();
    out.equal_delta_e = options.equal_delta_e;

    out.recipe = numbers.at(best.x);
    out.parameters = parameters_at(numbers, best.x, out.certainty);
    out.colours = colours_of(target, out.recipe, work);
    out.difference = target.difference(out.colours);
    out.converged = best.converged;
    out.ended = best.ended;
    if (target.has_spectra()) {
        for (spectra::Illuminant light : {spectra::Illuminant::A, spectra::Illuminant::FL11}) {
            measure::Conditions conditions = target.standard().conditions;
            conditions.illuminant = light;
            out.other_lights.emplace_back(
                light,
                measure::difference(restated(target.standard(), conditions),
                                    restated(out.colours, conditions), options.target.weights));
        }
    }
    for (const WeakDirection& weak : out.certainty.weak) {
        if (auto found = tradeoff(model, best.x, weak.step, options.equal_delta_e)) {
            out.tradeoffs.push_back(std::move(*found));
        }
    }
    for (std::size_t i = 1; i < minima.size(); ++i) {
        const measure::Difference there =
            target.difference(colours_of(target, numbers.at(minima[i].x), work));
        if (there.mean_delta_e_2000 > out.difference.mean_delta_e_2000 + options.equal_delta_e) {
            continue;
        }
        out.alternatives.push_back({values_at(numbers, minima[i].x), there.mean_delta_e_2000,
                                    there.max_delta_e_2000, minima[i].converged, minima[i].ended});
    }
    out.matched_delta_e = options.matched_delta_e;
    int solves = model.solves();
    if (options.remedies && !out.matched()) {
        out.remedies = find_remedies(target, out.recipe, numbers.start(), out.parameters,
                                     out.difference.mean_delta_e_2000, work, solves);
    }
    if (work.stopped()) throw Stopped(kStopped);
    work.add();
    out.effort = {solves,
                  static_cast<int>(model.films()),
                  effort.points,
                  effort.descents,
                  effort.finished,
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
    return out;
}

RoughFit screened(const measure::Measurement& standard, const FreeNumbers& numbers,
                  const FitOptions& options, const Progress& progress) {
    check(options);
    const Target target(standard, options.target);
    paint::validate(numbers.start(), target.wavelengths_nm(Detail::fine));
    paint::require_no_lean(numbers.start(), "fits are of paints that are");
    SharedProgress work(progress, 1);
    const ColourModel model(numbers, target, work);
    const Descent best =
        short_search(model, numbers.start_point(), options.starts, options.seed, work)[0];
    return {best.x, best.rms_delta_e};
}

RoughFit descended(const measure::Measurement& standard, const FreeNumbers& numbers,
                   const RoughFit& from, const FitOptions& options, const Progress& progress) {
    check(options);
    const Target target(standard, options.target);
    SharedProgress work(progress, 1);
    const ColourModel model(numbers, target, work);
    const Descent end = coarse_descent(model, from.x);
    if (!std::isfinite(end.rms_delta_e)) throw Error(model.first_failure());
    const measure::Measurement colours = colours_of(target, numbers.at(end.x), work);
    return {end.x, target.difference(colours).mean_delta_e_2000};
}

}  // namespace nacre::fit
