#include "nacre/models/models.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/bsdf/models/special_effect.h"
#include "nacre/bsdf/models/thin_film.h"
#include "nacre/core/error.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/montecarlo/shell_walk.h"

namespace nacre::models {

std::span<const bsdf::ModelInfo* const> all_models() {
    static constexpr const bsdf::ModelInfo* kModels[] = {
        &bsdf::MicroflakeModel::info, &bsdf::ThinFilmModel::info,   &bsdf::SpecialEffectModel::info,
        &bsdf::NacreModel::info,      &montecarlo::WalkModel::info, &montecarlo::VolumeModel::info};
    return kModels;
}

bsdf::Model default_model() { return all_models().front()->standard(); }

bsdf::Model default_picture_model() { return bsdf::NacreModel{}; }

std::vector<std::string_view> names_where(bool (*condition)(const bsdf::ModelInfo&)) {
    std::vector<std::string_view> names;
    for (const bsdf::ModelInfo* model : all_models()) {
        if (!condition(*model)) continue;
        const bool first = model == &default_picture_model().info();
        names.insert(first ? names.begin() : names.end(), model->name);
    }
    return names;
}

std::vector<std::string_view> names_of_fitted() {
    std::vector<std::string_view> names;
    for (const bsdf::ModelInfo* model : all_models()) {
        if (model->can.fitted) names.push_back(model->name);
    }
    return names;
}

std::vector<std::string_view> names_with_arrays() {
    return names_where(
        [](const bsdf::ModelInfo& model) { return model.standard().makes_arrays(); });
}

const bsdf::ModelInfo* find_model(std::string_view name) {
    const auto models = all_models();
    const auto found =
        std::find_if(models.begin(), models.end(), [&](const auto* m) { return m->name == name; });
    return found == models.end() ? nullptr : *found;
}

bsdf::Model named_model(std::string_view name) {
    const bsdf::ModelInfo* info = find_model(name);
    if (!info) {
        std::vector<std::string_view> names;
        for (const bsdf::ModelInfo* model : all_models()) names.push_back(model->name);
        throw DomainError(
            fmt::format("model = {}: is no model; there are: {}", name, fmt::join(names, ", ")));
    }
    return info->standard();
}

}  // namespace nacre::models
