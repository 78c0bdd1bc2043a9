#include "nacre/fit/uncertainty.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/api/state.h"
#include "nacre/models/models.h"
#include "nacre/spectra/spectrum.h"

namespace nacre {

namespace {

/// Whole keys for those that were given, which may be their ends.
std::vector<paint::ParameterDeviation> with_whole_keys(
    const paint::Recipe& recipe, const std::vector<paint::ParameterDeviation>& deviations) {
    std::vector<paint::ParameterDeviation> whole;
    for (const paint::ParameterDeviation& d : deviations) {
        std::vector<paint::ParameterDeviation> meant;
        for (const std::string& key : paint::matching_parameters(recipe, d.key)) {
            meant.push_back({key, d.amount, d.relative});
        }
        whole = paint::with_deviations(std::move(whole), meant);
    }
    return whole;
}

/// Likewise; of those with `*` the numbers that have a standard deviation.
std::vector<paint::ParameterCorrelation> with_whole_keys(
    const paint::Recipe& recipe, const std::vector<paint::ParameterDeviation>& known,
    const std::vector<paint::ParameterCorrelation>& correlations) {
    std::vector<paint::ParameterCorrelation> whole;
    for (const paint::ParameterCorrelation& c : correlations) {
        paint::ParameterCorrelation meant{{}, c.coefficient};
        try {
            for (const std::string& pattern : c.keys) {
                const bool is_pattern = pattern.find('*') != std::string::npos;
                for (const std::string& key : paint::matching_parameters(recipe, pattern)) {
                    const bool is_known = std::ranges::any_of(
                        known, [&](const paint::ParameterDeviation& d) { return d.key == key; });
                    if (is_known || !is_pattern) meant.keys.push_back(key);
                }
            }
            paint::check_correlation(recipe, known, meant);
        } catch (const DomainError& error) {
            throw SettingError("correlation", error.what(), paint::correlation_text(c));
        }
        whole.push_back(std::move(meant));
    }
    return whole;
}

}  // namespace

bool has_uncertainty(const Model& model) {
    const bsdf::Capabilities& can = model.info().can;
    return !can.reference_only && !can.estimated_values && !model.makes_table();
}

Uncertainty Paint::measure_uncertainty(const std::vector<Geometry>& geometries,
                                       const MeasureSettings& settings,
                                       const UncertaintySettings& uncertainty,
                                       const Progress& progress) const {
    const paint::Recipe& own = recipe();
    const std::vector<paint::ParameterDeviation> known =
        paint::with_deviations(deviations(), with_whole_keys(own, uncertainty.deviations));
    const std::vector<paint::ParameterCorrelation> correlated = paint::with_correlations(
        correlations(), with_whole_keys(own, known, uncertainty.correlations));
    if (!uncertainty.correlations.empty()) {
        try {
            paint::check_correlations(own, known, correlated);
        } catch (const DomainError& error) {  // "correlation: ..."
            throw SettingError(error.what());
        }
    }
    if (known.empty()) {
        throw SettingError("uncertainty",
                           "say how well which numbers are known, or do so in a table "
                           "[uncertainty] of the recipe");
    }
    const Model model = settings.model.value_or(models::default_model());
    if (!has_uncertainty(model)) {
        throw SettingError("model",
                           "has no exact values, of which an uncertainty could be found by "
                           "differences",
                           std::string(model.info().name));
    }
    const measure::Conditions conditions{
        settings.illuminant.value_or(measure::Conditions{}.illuminant),
        settings.observer.value_or(measure::Conditions{}.observer),
        settings.aperture.value_or(measure::Conditions{}.aperture)};
    const std::vector<Geometry> wanted =
        geometries.empty() ? nacre::geometries(kDefaultGeometries) : geometries;

    fit::PaintReader reader;
    if (model.info().solution == bsdf::Solution::none) {
        // Of facets: nothing is solved.
        reader = [&](const paint::Recipe& recipe, const solver::SolverSettings*, SharedProgress&) {
            return fit::PaintReading{Paint(recipe).measure(wanted, settings).measurement, {}};
        };
    } else {
        if (own.layers.empty()) {
            throw InputError(state_->label() +
                             ": layer: is missing; solving a paint needs at least one [[layer]]");
        }
        reader =
            fit::solution_reader(settings.wavelengths_nm.empty() ? spectra::default_wavelengths_nm()
                                                                 : settings.wavelengths_nm,
                                 wanted, conditions, model.shows_hot_spot());
    }
    const auto naming_file = [&](const paint::Recipe& recipe, const solver::SolverSettings* like,
                                 SharedProgress& work) {
        return state_->naming_file([&] { return reader(recipe, like, work); });
    };
    fit::Uncertainty out = fit::uncertainty(
        own, known, naming_file, {uncertainty.samples, uncertainty.seed, correlated}, progress);
    out.measurement.name = name();
    return out;
}

}  // namespace nacre
