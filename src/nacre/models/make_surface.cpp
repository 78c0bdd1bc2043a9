#include "nacre/models/make_surface.h"

#include <fmt/format.h>

#include "nacre/bsdf/microflake.h"
#include "nacre/bsdf/nacre.h"
#include "nacre/bsdf/special_effect.h"
#include "nacre/bsdf/tabulated.h"
#include "nacre/core/error.h"
#include "nacre/discs/disc_walk.h"
#include "nacre/volume/plane_walk.h"

namespace nacre::models {
namespace {

void require_ingredients(const ModelInfo& model, const layers::Recipe& recipe) {
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
        return std::make_shared<discs::DiscWalk>(
            paint.recipe, discs::DiscSettings{.tile_width_mm = options.panel_width_mm,
                                              .tile_height_mm = options.panel_height_mm,
                                              .seed = options.seed});
    }
    if (!paint.solved) throw DomainError("the model nacre needs a solved paint");
    return std::make_shared<bsdf::Nacre>(paint.solved, options.seed,
                                         bsdf::NacreSettings{.hot_spot = options.hot_spot});
}

}  // namespace

BrdfTable share(std::variant<layers::RawBrdfTable, layers::CompressedBrdfTable> table) {
    return std::visit(
        [](auto&& t) -> BrdfTable {
            using T = std::decay_t<decltype(t)>;
            return std::make_shared<const T>(std::forward<decltype(t)>(t));
        },
        std::move(table));
}

BrdfTable make_table(const layers::SolvedPaint& paint, const SurfaceOptions& options,
                     const Progress& progress) {
    layers::RawBrdfTable raw = layers::make_raw_table(paint, options.table_size, progress);
    if (options.table == Table::svd) {
        return std::make_shared<const layers::CompressedBrdfTable>(
            layers::compress(raw, options.compression));
    }
    return std::make_shared<const layers::RawBrdfTable>(std::move(raw));
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
            return std::make_shared<volume::PlaneWalk>(paint.recipe);
        case Model::volume:
            return std::make_shared<volume::ShellWalk>(
                paint.recipe, volume::ShellSettings{.radius_mm = options.radius_mm,
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
