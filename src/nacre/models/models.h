#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/models/thin_film.h"
#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/core/progress.h"
#include "nacre/montecarlo/shell_walk.h"
#include "nacre/paint/recipe.h"
#include "nacre/solver/solved_paint.h"

// The appearance models that Nacre offers, as data: what they are called, what they take and what
// they can show. make_surface.h builds them.

namespace nacre::models {

enum class Model { microflake, thin_film, special_effect, nacre, walk, volume };

/// What a model can show: the columns of Table 3 of Mir et al. [mir-2022]. A test measures each.
struct Capabilities {
    bool goniochromism = false;        ///< colour that turns with angle
    bool sparkle = false;              ///< single flakes that flash
    bool multiple_scattering = false;  ///< between flakes and between layers
    bool reference_only = false;       ///< an unbiased simulation: no values, only pictures
};

/// Which part of a recipe a model reads.
enum class Ingredients { layers, microfacet };

struct ModelInfo {
    Model model;
    std::string_view name;     ///< on the command line
    std::string_view summary;  ///< in one line
    std::string_view source;   ///< authors and year
    Ingredients ingredients;
    Capabilities can;
};

std::span<const ModelInfo> all_models();
const ModelInfo& info(Model model);
/// Null if there is none of that name.
const ModelInfo* find_model(std::string_view name);

/// In which form the BRDF of a solved paint is kept for rendering.
enum class Table {
    split,  ///< ours: interface, single scattering in closed form, a low-rank multiple scattering;
            ///< spectral
    raw,    ///< as the paper tabulates it: angles times angles, RGB         [ergun-2016; mir-2022]
    svd     ///< the same after its singular value decomposition
};

/// How the model nacre shows single flakes.
enum class Flakes {
    hashed,         ///< statistics of flakes that are never stored, on any shape
    explicit_discs  ///< its ground truth: every flake a disc, under a flat panel
                    ///< (montecarlo/discs/disc_walk.h)
};

/// What may be chosen about a model. Each model reads its own lines.
struct SurfaceOptions {
    Table table = Table::split;                                       ///< microflake
    bsdf::BrdfTableSettings table_size;                               ///< microflake: raw and svd
    bsdf::CompressionSettings compression;                            ///< microflake: svd
    bsdf::ThinFilmColour colour = bsdf::ThinFilmColour::spectral;     ///< thin-film
    montecarlo::Tracking tracking = montecarlo::Tracking::delta;      ///< volume
    int simpson_panels = montecarlo::ShellSettings{}.simpson_panels;  ///< volume
    /// volume: radius of the painted sphere; infinity is a flat panel.
    double radius_mm = std::numeric_limits<double>::infinity();
    std::uint64_t seed = 0;          ///< special-effect and nacre: which facets or flakes there are
    bool hot_spot = false;           ///< nacre: see bsdf::NacreSettings
    Flakes flakes = Flakes::hashed;  ///< nacre
    /// nacre with explicit flakes: size of the flat panel, in montecarlo::kTileSide.
    double panel_width_mm = 0, panel_height_mm = 0;
};

/// A raw table or a compressed one.
using BrdfTable = std::variant<std::shared_ptr<const bsdf::RawBrdfTable>,
                               std::shared_ptr<const bsdf::CompressedBrdfTable>>;

/// Takes over a table read from a file.
BrdfTable fraction(std::variant<bsdf::RawBrdfTable, bsdf::CompressedBrdfTable> table);

/// @param options  options.table is raw or svd
/// @throws as bsdf::make_raw_table() and bsdf::compress()
BrdfTable make_table(const solver::SolvedPaint& paint, const SurfaceOptions& options,
                     const Progress& progress = {});

/// A paint as the user gives it.
struct Paint {
    paint::Recipe recipe = {};  ///< not needed with `table`
    std::shared_ptr<const solver::SolvedPaint> solved =
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
