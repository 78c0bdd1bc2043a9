#include "nacre/fit/fit.h"

#include <fmt/format.h>

#include "nacre/api/state.h"

namespace nacre {

bool shows_hot_spot(const Model& model) {
    const auto* nacre = model.get<NacreModel>();
    return nacre && nacre->hot_spot;
}

fit::FreeKeys Paint::free_keys(const std::vector<std::string>& patterns,
                               const FitSettings& settings, const Progress& progress) const {
    if (!patterns.empty()) {
        return fit::free_keys(recipe(), patterns, bounds(), settings.target.hot_spot, progress);
    }
    fit::FreeKeys free;
    for (const paint::ParameterBounds& b : bounds()) free.keys.push_back(b.key);
    if (free.keys.empty()) {
        throw SettingError("keys", "say which numbers are free, or bound them in a table [fit]");
    }
    return free;
}

Match Paint::fit(const Measurement& standard, const std::vector<std::string>& keys,
                 const FitSettings& settings, const Progress& progress) const {
    if (recipe().layers.empty()) {
        throw InputError(fmt::format("{}: layer: is missing; a fit needs at least one [[layer]]",
                                     state_->label()));
    }
    fit::FreeKeys free = free_keys(keys, settings, cancel_only(progress));
    const fit::FreeNumbers numbers(recipe(), free.keys, bounds());
    fit::Fit found = fit::fit(standard, numbers, settings, progress);
    io::RecipeFile made = state_->recipe_file();
    made.recipe = found.recipe;
    // A percentage says nothing about a number that was fitted to 0.
    std::erase_if(made.deviations, [&](const paint::ParameterDeviation& d) {
        return d.relative && paint::find_parameter(found.recipe, d.key).value == 0;
    });
    made.correlations =
        paint::correlations_among(std::move(made.correlations), [&](const std::string& key) {
            return std::ranges::any_of(made.deviations,
                                       [&](const auto& d) { return d.key == key; });
        });
    Paint paint(std::make_shared<const State>(std::move(made), file()));
    return {std::move(found), std::move(paint), std::move(free.skipped)};
}

}  // namespace nacre
