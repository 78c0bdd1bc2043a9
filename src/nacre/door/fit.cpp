#include "nacre/fit/fit.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/door/state.h"

namespace nacre {

bool shows_hot_spot(const Model& model) {
    const auto* nacre = model.get<NacreModel>();
    return nacre && nacre->hot_spot;
}

std::vector<std::string> Paint::free_keys(const std::vector<std::string>& patterns) const {
    std::vector<std::string> keys;
    for (const std::string& pattern : patterns) {
        for (const std::string& key : paint::matching_parameters(recipe(), pattern)) {
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
        }
    }
    if (patterns.empty()) {
        for (const paint::ParameterBounds& b : bounds()) keys.push_back(b.key);
        if (keys.empty()) {
            throw SettingError("keys",
                               "say which numbers are free, or bound them in a table [fit]");
        }
    }
    return keys;
}

Match Paint::fit(const Measurement& standard, const std::vector<std::string>& keys,
                 const FitSettings& settings, const Progress& progress) const {
    if (recipe().layers.empty()) {
        throw InputError(fmt::format("{}: layer: is missing; a fit needs at least one [[layer]]",
                                     state_->label()));
    }
    const fit::FreeNumbers numbers(recipe(), free_keys(keys), bounds());
    fit::Fit found = fit::fit(standard, numbers, settings, progress);
    io::RecipeFile made{found.recipe, bounds(), deviations()};
    // A percentage says nothing about a number that was fitted to 0.
    std::erase_if(made.deviations, [&](const paint::ParameterDeviation& d) {
        return d.relative && paint::find_parameter(found.recipe, d.key).value == 0;
    });
    Paint paint(std::make_shared<const State>(std::move(made), file()));
    return {std::move(found), std::move(paint)};
}

}  // namespace nacre
