#include "apps/cli/walk_sample.h"

#include <fmt/format.h>

#include <map>
#include <numbers>

#include "apps/cli/options.h"
#include "apps/cli/paint_source.h"
#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/io/recipe_file.h"
#include "nacre/montecarlo/reference.h"
#include "nacre/solver/solver.h"

namespace nacre::cli {

namespace {

/// Positions of the geometries by lamp: the views of one lamp share their walks.
std::map<double, std::vector<std::size_t>> by_lamp(const std::vector<measure::Geometry>& all) {
    std::map<double, std::vector<std::size_t>> lamps;
    for (std::size_t i = 0; i < all.size(); ++i) lamps[all[i].theta_i_deg].push_back(i);
    return lamps;
}

}  // namespace

MeasuredSample measure_by_walk(const std::filesystem::path& path, const InstrumentRequest& request,
                               const std::string& model, const CommonOptions& options) {
    const measure::Conditions conditions = request.conditions();
    if (!(conditions.aperture == measure::Aperture{})) {
        throw UsageError(fmt::format("--aperture: --model {} reads with points only", model));
    }
    const paint::Recipe recipe = load_recipe(path);
    const std::vector<double> nm =
        request.wavelengths_nm.value_or(solver::default_wavelengths_nm());
    const std::vector<measure::Geometry> geometries = request.geometries_or_default();

    MeasuredSample sample;
    sample.path = path.string();
    sample.recipe_sha256 = io::recipe_hash(recipe);
    sample.model = model;
    sample.measurement = {recipe.name.empty() ? path.stem().string() : recipe.name, conditions, nm,
                          std::vector<measure::Reading>(geometries.size())};
    sample.standard_error.resize(geometries.size());
    ProgressBar bar("walk", options.quiet);
    const Progress progress = bar.callback();
    const auto lamps = by_lamp(geometries);
    double done = 0;
    for (const auto& [lamp_deg, positions] : lamps) {
        const std::vector<montecarlo::Direction> incident = {{lamp_deg, 0}};
        std::vector<montecarlo::Direction> outgoing;
        for (std::size_t i : positions) {
            outgoing.push_back({geometries[i].theta_o_deg, geometries[i].phi_deg});
        }
        const auto estimates = montecarlo::reference_brdf(
            recipe, incident, outgoing, nm, {request.walks, options.seed, montecarlo::Part::total},
            [&](double fraction) {
                return progress((done + fraction) / static_cast<double>(lamps.size()));
            });
        done += 1;
        for (std::size_t view = 0; view < positions.size(); ++view) {
            std::vector<double> mean(nm.size()), error(nm.size());
            for (std::size_t i = 0; i < nm.size(); ++i) {
                const montecarlo::Estimate& estimate = estimates[view * nm.size() + i];
                mean[i] = std::numbers::pi * estimate.mean;
                error[i] = std::numbers::pi * estimate.standard_error;
            }
            const std::size_t position = positions[view];
            sample.measurement.readings[position] =
                measure::coloured(geometries[position], nm, std::move(mean), conditions);
            sample.standard_error[position] = std::move(error);
        }
    }
    return sample;
}

}  // namespace nacre::cli
