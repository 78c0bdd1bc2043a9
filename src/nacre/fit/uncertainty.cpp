#include "nacre/fit/uncertainty.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "nacre/core/error.h"
#include "nacre/fit/first_order.h"
#include "nacre/fit/sampled_spread.h"
#include "nacre/fit/uncertain_paint.h"
#include "nacre/paint/recipe_parameter.h"

namespace nacre::fit {
namespace {

void check(const std::vector<paint::ParameterDeviation>& deviations,
           const UncertaintyOptions& options) {
    if (deviations.empty()) {
        throw DomainError(
            "no number of the recipe has a standard deviation: there is nothing to "
            "carry through");
    }
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (deviations[i].key != deviations[j].key) continue;
            throw DomainError(
                fmt::format("{}: is named twice among the uncertain numbers", deviations[i].key));
        }
    }
    if (options.samples == 0) return;
    require_in_range(options.samples, UncertaintyOptions::kMinSamples,
                     UncertaintyOptions::kMaxSamples, "samples of the uncertainty");
}

}  // namespace

PaintReader solution_reader(std::vector<double> wavelengths_nm,
                            std::vector<measure::Geometry> geometries,
                            const measure::Conditions& conditions, bool hot_spot) {
    constexpr std::size_t kFilmsKept = 64;
    const auto films = std::make_shared<solver::FilmCache>(kFilmsKept, kFineCosines);
    return
        [=](const paint::Recipe& recipe, const solver::SolverSettings* like, SharedProgress& work) {
            const Solution solution =
                solve_alike(recipe, wavelengths_nm, kFineTolerance, like, *films, work);
            return PaintReading{read_solution(solution.paint, hot_spot, geometries, conditions),
                                solution.settings};
        };
}

Uncertainty uncertainty(const paint::Recipe& recipe,
                        const std::vector<paint::ParameterDeviation>& deviations,
                        const PaintReader& reader, const UncertaintyOptions& options,
                        const Progress& progress) {
    check(deviations, options);
    paint::require_no_lean(recipe, "uncertainties are carried to the colours of paints that are");
    paint::check_correlations(recipe, deviations, options.correlations);
    std::size_t active = 0;
    for (const paint::ParameterDeviation& deviation : deviations) {
        active += paint::standard_deviation(recipe, deviation) > 0;
    }
    std::vector<double> correlation = paint::correlation_matrix(deviations, options.correlations);
    SharedProgress work(progress, static_cast<double>(1 + active * (3 + active)) + options.samples);
    UncertainPaint paint(recipe, paint::correlation_root(correlation), reader, work);
    for (const paint::ParameterDeviation& deviation : deviations) {
        const paint::RecipeParameter parameter = paint::find_parameter(recipe, deviation.key);
        paint.add({parameter.key, parameter.value, paint::standard_deviation(recipe, deviation)},
                  parameter.range);
    }
    for (std::size_t i = 0; i < paint.numbers().size(); ++i) {
        std::vector<double> point(paint.numbers().size(), 0.0);
        for (const double side : {-1.0, 1.0}) {
            point[i] = side * UncertainNumber::kSigmasOfRange;
            if (!paint.is_valid(point)) paint.numbers()[i].meets_range = true;
        }
    }

    // Errors of the recipe are thrown here.
    const PaintReading here = reader(recipe, nullptr, work);
    work.add();
    paint.throw_if_stopped();
    const Evaluation centre{values_of(here.measurement), here.settings};
    const ValueLayout layout{here.measurement.readings.size(),
                             here.measurement.wavelengths_nm.size()};
    const Sensitivities moves = paint.moves(centre);

    Uncertainty out;
    out.measurement = here.measurement;
    out.numbers = paint.numbers();
    out.correlation = std::move(correlation);
    for (std::size_t r = 0; r < layout.readings; ++r) {
        out.readings.push_back(
            reading_of(here.measurement.readings[r], layout.lab(r), layout.spectrum(r), moves));
    }
    out.flop_index = metric_of(layout.flop(), moves);
    out.colour_travel = metric_of(layout.travel(), moves);
    if (options.samples == 0) return out;

    out.samples = options.samples;
    const SampledSums sums = sampled_sums(paint, layout, centre.values, options, out.redrawn);
    for (std::size_t r = 0; r < layout.readings; ++r) {
        out.readings[r].sampled = sums.spread(r, centre.values);
    }
    const auto add_sampled = [&](std::optional<MetricUncertainty>& metric, std::size_t position) {
        if (!metric) return;
        const double deviation = sums.deviation(position);
        if (std::isfinite(deviation)) metric->sampled = deviation;
    };
    add_sampled(out.flop_index, layout.flop());
    add_sampled(out.colour_travel, layout.travel());
    return out;
}

}  // namespace nacre::fit
