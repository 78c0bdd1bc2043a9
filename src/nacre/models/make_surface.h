#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/thin_film.h"
#include "nacre/core/progress.h"
#include "nacre/layers/brdf_table_svd.h"
#include "nacre/layers/recipe.h"
#include "nacre/layers/solved_paint.h"
#include "nacre/models/model.h"
#include "nacre/volume/shell_walk.h"

namespace nacre::models {

/// In which form the BRDF of a solved paint is kept for rendering.
enum class Table {
    split,  ///< ours: interface, single scattering in closed form, a low-rank remainder; spectral
    raw,    ///< as the paper tabulates it: angles times angles, RGB         [ergun-2016; mir-2022]
    svd     ///< the same after its singular value decomposition
};

/// How the model nacre shows single flakes.
enum class Flakes {
    hashed,         ///< statistics of flakes that are never stored, on any shape
    explicit_discs  ///< its ground truth: every flake a disc, under a flat panel
                    ///< (discs/disc_walk.h)
};

/// What may be chosen about a model. Each model reads its own lines.
struct SurfaceOptions {
    Table table = Table::split;                                    ///< microflake
    layers::BrdfTableSettings table_size;                          ///< microflake: raw and svd
    layers::CompressionSettings compression;                       ///< microflake: svd
    bsdf::ThinFilmColour colour = bsdf::ThinFilmColour::spectral;  ///< thin-film
    volume::Tracking tracking = volume::Tracking::delta;           ///< volume
    int simpson_panels = volume::ShellSettings{}.simpson_panels;   ///< volume
    /// volume: radius of the painted sphere; infinity is a flat panel.
    double radius_mm = std::numeric_limits<double>::infinity();
    std::uint64_t seed = 0;          ///< special-effect and nacre: which facets or flakes there are
    bool hot_spot = false;           ///< nacre: see bsdf::NacreSettings
    Flakes flakes = Flakes::hashed;  ///< nacre
    /// nacre with explicit flakes: size of the flat panel, in discs::kTileSide.
    double panel_width_mm = 0, panel_height_mm = 0;
};

/// A raw table or a compressed one.
using BrdfTable = std::variant<std::shared_ptr<const layers::RawBrdfTable>,
                               std::shared_ptr<const layers::CompressedBrdfTable>>;

/// Takes over a table read from a file.
BrdfTable share(std::variant<layers::RawBrdfTable, layers::CompressedBrdfTable> table);

/// @param options  options.table is raw or svd
/// @throws as layers::make_raw_table() and layers::compress()
BrdfTable make_table(const layers::SolvedPaint& paint, const SurfaceOptions& options,
                     const Progress& progress = {});

/// A paint as the user gives it.
struct Paint {
    layers::Recipe recipe = {};  ///< not needed with `table`
    std::shared_ptr<const layers::SolvedPaint> solved =
        {};  ///< microflake (unless `table` is set) and nacre (hashed): needed
    std::optional<BrdfTable> table = {};  ///< microflake: made earlier
};

/// The surface that a model makes of a paint.
///
/// @throws DomainError if the recipe lacks what the model reads (layers or [microfacet] with its
///         [microfacet.facets]), holds what it cannot do, or an option is out of range
/// @throws Error if `progress` asks to stop
std::shared_ptr<const bsdf::Bsdf> make_surface(Model model, const Paint& paint,
                                               const SurfaceOptions& options,
                                               const Progress& progress = {});

/// Names on the command line.
std::string_view name(Table table);
std::string_view name(Flakes flakes);

}  // namespace nacre::models
