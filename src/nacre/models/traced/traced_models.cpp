#include "nacre/models/traced/traced_models.h"

#include "nacre/montecarlo/discs/disc_walk.h"

namespace nacre::models {

std::span<const bsdf::ModelInfo* const> traced_models() {
    static constexpr const bsdf::ModelInfo* kModels[] = {&montecarlo::ExplicitFlakesModel::info};
    return kModels;
}

}  // namespace nacre::models
