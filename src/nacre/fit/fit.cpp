#include "nacre/fit/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/fit/search.h"
#include "nacre/solver/solver.h"

namespace nacre::fit {

namespace {

/// A number this near to its bound, as a fraction of the distance between both, is at it.
constexpr double kAtBound = 1e-3;
/// Numbers whose component of a weak direction is below this fraction of the largest are not named.
constexpr double kPartOfTradeoff = 0.15;
/// A weak direction is not reported if the bounds end it within this fraction of their distance.
constexpr double kMinRoom = 0.02;

void check(const FitOptions& options) {
    require_in_range(options.starts, 1, FitOptions::kMaxStarts, "starts");
    require_in_range(options.equal_delta_e, 1e-3, 100, "the Delta E that counts as equal");
    if (options.noise_delta_e) {
        require_in_range(*options.noise_delta_e, 1e-6, 100, "noise in Delta E");
    }
}

/// Diameters and their spreads, which the hot spot depends on.
std::vector<double> flake_sizes(const paint::Recipe& recipe) {
    std::vector<double> sizes;
    for (const paint::Layer& layer : recipe.layers) {
        for (const paint::FlakeSpecies& flake : layer.flakes) {
            sizes.push_back(flake.diameter_um);
            sizes.push_back(flake.diameter_spread_um);
            if (flake.quantiles) {
                const auto& [d10, d50, d90] = *flake.quantiles;
                sizes.insert(sizes.end(), {d10, d50, d90});
            }
        }
    }
    return sizes;
}

/// A number that only matters elsewhere (the diameter of flakes to the mean colour, a clearcoat's
/// thickness if it absorbs nothing) cannot be found from colours.
void require_effect(const FreeNumbers& numbers, bool hot_spot, SharedProgress& work) {
    const std::vector<double> wavelengths = {450, 550, 650};
    const std::vector<double> start = numbers.start_point();
    const paint::Recipe recipe_here = numbers.at(start);
    const solver::PaintMedium here = solver::make_medium(recipe_here, wavelengths, nullptr, &work);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::vector<double> moved = start;
        moved[i] = start[i] > 0.5 ? start[i] - 0.25 : start[i] + 0.25;
        try {
            const paint::Recipe recipe = numbers.at(moved);
            if (!(solver::make_medium(recipe, wavelengths, nullptr, &work) == here)) continue;
            if (hot_spot && flake_sizes(recipe) != flake_sizes(recipe_here)) continue;
        } catch (const DomainError&) {
            continue;  // invalid with the other numbers as they are: it may have an effect
        }
        throw DomainError(fmt::format(
            "{}: does not change the colours of this paint, so that they cannot tell it",
            numbers[i].bounds.key));
    }
}

/// With the default settings of the solver, without the reduced accuracy of the search.
measure::Measurement colours_of(const Target& target, const paint::Recipe& recipe,
                                SharedProgress& work) {
    return target.read(solver::solve(recipe, target.wavelengths_nm(Detail::fine), {}, nullptr,
                                     [&](double) { return work.ask(); }),
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

/// Empty where the bounds leave no room along the direction.
std::optional<Tradeoff> describe(const FreeNumbers& numbers, const std::vector<double>& x,
                                 const std::vector<double>& step, double equal_delta_e) {
    // As far as the bounds allow, in the sense of the direction in which they allow more.
    const auto room = [&](double sign) {
        double fraction = 1;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double d = sign * step[i];
            if (std::abs(d) < 1e-3) continue;
            fraction = std::min(fraction, (d > 0 ? 1 - x[i] : x[i]) / std::abs(d));
        }
        return std::max(fraction, 0.0);
    };
    const double sign = room(1) >= room(-1) ? 1 : -1, fraction = room(sign);
    std::vector<std::size_t> order;
    double largest = 0;
    for (double d : step) largest = std::max(largest, std::abs(d));
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::abs(step[i]) >= kPartOfTradeoff * largest) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(step[a]) > std::abs(step[b]);
    });
    if (fraction * largest < kMinRoom) return std::nullopt;
    Tradeoff tradeoff;
    tradeoff.rms_delta_e = fraction * equal_delta_e;
    for (std::size_t i : order) {
        tradeoff.changes.push_back({numbers[i].bounds.key, numbers[i].from_unit(x[i]),
                                    numbers[i].from_unit(x[i] + sign * fraction * step[i])});
    }
    return tradeoff;
}

}  // namespace

Fit fit(const measure::Measurement& standard, const FreeNumbers& numbers, const FitOptions& options,
        const Progress& progress) {
    const auto begin = std::chrono::steady_clock::now();
    check(options);
    const Target target(standard, options.target);
    paint::validate(numbers.start(), target.wavelengths_nm(Detail::fine));
    SharedProgress work(progress, 1);
    require_effect(numbers, target.hot_spot(), work);
    ColourModel model(numbers, target, work);

    Fit out;
    out.standard = target.standard();
    const auto compare = [&](const measure::Measurement& sample) {
        return measure::difference(target.standard(), sample, options.target.weights);
    };
    // Errors of the recipe are thrown here.
    out.at_start = compare(colours_of(target, numbers.start(), work));

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
    out.difference = compare(out.colours);
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
        if (auto tradeoff = describe(numbers, best.x, weak.step, options.equal_delta_e)) {
            out.tradeoffs.push_back(std::move(*tradeoff));
        }
    }
    for (std::size_t i = 1; i < minima.size(); ++i) {
        const measure::Difference there =
            compare(colours_of(target, numbers.at(minima[i].x), work));
        if (there.mean_delta_e_2000 > out.difference.mean_delta_e_2000 + options.equal_delta_e) {
            continue;
        }
        out.alternatives.push_back({values_at(numbers, minima[i].x), there.mean_delta_e_2000,
                                    there.max_delta_e_2000, minima[i].converged, minima[i].ended});
    }
    work.add();
    out.effort = {model.solves(),
                  static_cast<int>(model.films()),
                  effort.points,
                  effort.descents,
                  effort.finished,
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
    return out;
}

}  // namespace nacre::fit
