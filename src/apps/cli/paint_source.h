#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/options.h"
#include "nacre/models/models.h"
#include "nacre/solver/solver.h"

// Everything that takes a recipe takes a solved paint too.

namespace nacre::cli {

/// A recipe, or the recipe inside a solved paint.
/// @throws InputError, also for a measured BRDF, which has none
paint::Recipe load_recipe(const std::filesystem::path& path);

/// A solved paint as it is, or a recipe solved at the given wavelengths (by default 400 to 700 nm
/// by 10, solver::default_wavelengths_nm()). Says on stderr, unless quiet, what the solver could
/// not resolve in it.
///
/// @throws InputError if the file is wrong, or is a solved paint that lacks a wavelength asked for
/// @throws DomainError, Error as solver::solve()
solver::SolvedPaint load_paint(const std::filesystem::path& path,
                               const std::optional<std::vector<double>>& wavelengths_nm,
                               const CommonOptions& options,
                               const solver::SolverSettings& settings = {});

/// Position of a wavelength among those of a solved paint.
/// @throws InputError if it is not there
std::size_t wavelength_position(const solver::SolvedPaint& paint, double wavelength_nm,
                                const std::filesystem::path& path);

/// A paint as a model shows it.
struct PaintSurface {
    std::shared_ptr<const bsdf::Bsdf> surface;
    /// None: made from a table of a BRDF, or measured.
    std::optional<paint::Recipe> recipe;

    std::string recipe_sha256() const;  ///< empty without a recipe
};

/// Reads a recipe, a solved paint or a table of a BRDF, and makes a surface of it; or a measured
/// BRDF, in which no model has a part: `model` must then be models::default_model().
/// @throws InputError naming the file, also where the recipe lacks what the model reads
/// @throws as load_paint()
PaintSurface load_surface(const std::filesystem::path& path, const bsdf::Model& model,
                          const CommonOptions& options);

/// Whether the file starts like a table of a BRDF (nacre solve --table raw or svd).
bool is_brdf_table(const std::filesystem::path& path);

}  // namespace nacre::cli
