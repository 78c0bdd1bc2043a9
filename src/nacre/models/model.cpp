#include "nacre/models/model.h"

#include <algorithm>
#include <array>

namespace nacre::models {
namespace {

constexpr std::array<ModelInfo, 6> kModels{{
    {Model::microflake,
     "microflake",
     "flakes in layers, solved by radiative transfer: a smooth mean over many flakes",
     "Ergun et al. 2016",
     Ingredients::layers,
     {true, false, true, false}},
    {Model::thin_film,
     "thin-film",
     "microfacets under one smooth interference film",
     "Belcour and Barla 2017",
     Ingredients::microfacet,
     {true, false, false, false}},
    {Model::special_effect,
     "special-effect",
     "single microfacets, each with its own place, normal and film thickness",
     "Guo et al. 2018",
     Ingredients::microfacet,
     {true, true, false, false}},
    {Model::nacre,
     "nacre",
     "single flakes in layers: their light one by one, the rest solved by radiative transfer",
     "this project",
     Ingredients::layers,
     {true, true, true, false}},
    {Model::walk,
     "walk",
     "random walks of light through the layers, one path at a time",
     "position-free reference",
     Ingredients::layers,
     {true, false, true, true}},
    {Model::volume,
     "volume",
     "random walks through the paint as a volume that follows the surface",
     "volumetric reference of Mir et al. 2022",
     Ingredients::layers,
     {true, false, true, true}},
}};

}  // namespace

std::span<const ModelInfo> all_models() { return kModels; }

const ModelInfo& info(Model model) {
    return *std::find_if(kModels.begin(), kModels.end(),
                         [&](const ModelInfo& i) { return i.model == model; });
}

const ModelInfo* find_model(std::string_view name) {
    const auto found = std::find_if(kModels.begin(), kModels.end(),
                                    [&](const ModelInfo& i) { return i.name == name; });
    return found == kModels.end() ? nullptr : &*found;
}

}  // namespace nacre::models
