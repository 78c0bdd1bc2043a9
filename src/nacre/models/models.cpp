#include "nacre/models/models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/bsdf/models/special_effect.h"
#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/core/error.h"
#include "nacre/montecarlo/discs/disc_walk.h"
#include "nacre/montecarlo/plane_walk.h"

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

namespace {

void require_ingredients(const ModelInfo& model, const paint::Recipe& recipe) {
    if (model.ingredients == Ingredients::layers && recipe.layers.empty()) {
        throw DomainError(fmt::format(
            "layer: is missing; the model {} needs at least one [[layer]]", model.name));
    }
    if (model.ingredients != Ingredients::microfacet) return;
    if (!recipe.microfacet) {
        throw DomainError(fmt::format(
            "microfacet: is missing; the model {} needs the table [microfacet]", model.name));
    }
    if (model.model == Model::special_effect && !recipe.microfacet->facets) {
        throw DomainError(fmt::format(
            "microfacet.facets: is missing; the model {} needs the table [microfacet.facets]",
            model.name));
    }
}

std::shared_ptr<const bsdf::Bsdf> tabulated(const BrdfTable& table) {
    return std::visit(
        [](const auto& t) -> std::shared_ptr<const bsdf::Bsdf> {
            return std::make_shared<const bsdf::Tabulated>(t);
        },
        table);
}

std::shared_ptr<const bsdf::Bsdf> make_microflake(const Paint& paint, const SurfaceOptions& options,
                                                  const Progress& progress) {
    if (paint.table) return tabulated(*paint.table);
    if (!paint.solved) throw DomainError("the model microflake needs a solved paint");
    if (options.table == Table::split) return std::make_shared<bsdf::Microflake>(paint.solved);
    return tabulated(make_table(*paint.solved, options, progress));
}

std::shared_ptr<const bsdf::Bsdf> make_nacre(const Paint& paint, const SurfaceOptions& options) {
    if (options.flakes == Flakes::explicit_discs) {
        return std::make_shared<montecarlo::DiscWalk>(
            paint.recipe, montecarlo::DiscSettings{.tile_width_mm = options.panel_width_mm,
                                                   .tile_height_mm = options.panel_height_mm,
                                                   .seed = options.seed});
    }
    if (!paint.solved) throw DomainError("the model nacre needs a solved paint");
    return std::make_shared<bsdf::Nacre>(paint.solved, options.seed,
                                         bsdf::NacreSettings{.hot_spot = options.hot_spot});
}

}  // namespace

BrdfTable fraction(std::variant<bsdf::RawBrdfTable, bsdf::CompressedBrdfTable> table) {
    return std::visit(
        [](auto&& t) -> BrdfTable {
            using T = std::decay_t<decltype(t)>;
            return std::make_shared<const T>(std::forward<decltype(t)>(t));
        },
        std::move(table));
}

BrdfTable make_table(const solver::SolvedPaint& paint, const SurfaceOptions& options,
                     const Progress& progress) {
    bsdf::RawBrdfTable raw = bsdf::make_raw_table(paint, options.table_size, progress);
    if (options.table == Table::svd) {
        return std::make_shared<const bsdf::CompressedBrdfTable>(
            bsdf::compress(raw, options.compression));
    }
    return std::make_shared<const bsdf::RawBrdfTable>(std::move(raw));
}

std::shared_ptr<const bsdf::Bsdf> make_surface(Model model, const Paint& paint,
                                               const SurfaceOptions& options,
                                               const Progress& progress) {
    if (!paint.table) require_ingredients(info(model), paint.recipe);
    switch (model) {
        case Model::microflake:
            return make_microflake(paint, options, progress);
        case Model::thin_film:
            return std::make_shared<bsdf::ThinFilm>(paint.recipe, options.colour);
        case Model::special_effect:
            return std::make_shared<bsdf::SpecialEffect>(paint.recipe, options.seed);
        case Model::nacre:
            return make_nacre(paint, options);
        case Model::walk:
            return std::make_shared<montecarlo::PlaneWalk>(paint.recipe);
        case Model::volume:
            return std::make_shared<montecarlo::ShellWalk>(
                paint.recipe, montecarlo::ShellSettings{.radius_mm = options.radius_mm,
                                                        .tracking = options.tracking,
                                                        .simpson_panels = options.simpson_panels});
    }
    throw DomainError("no such model");
}

std::string_view name(Flakes flakes) {
    switch (flakes) {
        case Flakes::hashed:
            return "hashed";
        case Flakes::explicit_discs:
            return "explicit";
    }
    return "";
}

std::string_view name(Table table) {
    switch (table) {
        case Table::split:
            return "split";
        case Table::raw:
            return "raw";
        case Table::svd:
            return "svd";
    }
    return "";
}

}  // namespace nacre::models
