#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "nacre/measure/instrument.h"
#include "nacre/models/models.h"
#include "nacre/paint/recipe.h"
#include "nacre/solver/solved_paint.h"

// A paint, as a model shows it, by values: what `eval` prints and instruments are held against.

namespace nacre::cli {

/// How the values are wanted.
struct BrdfRequest {
    bsdf::Model model = models::default_model();
    bool model_given = false;  ///< asked for, rather than the default
    solver::Part part = solver::Part::total;
    /// Middle "X,Y" and side of the patch whose single flakes are to show; empty: the mean.
    std::string at, footprint;
};

/// Checks what the command line says before any work is done.
/// @param part  "total", "single" or "multiple"
/// @throws UsageError if the model gives no values, is alike all over while a patch is asked for,
///         or has no parts
BrdfRequest parse_brdf_request(const ModelOptions& model, std::uint64_t seed,
                               const std::string& part = "total", const std::string& at = {},
                               const std::string& footprint = {});

/// @throws UsageError if the model gives no values, only pictures
void require_values(const bsdf::ModelInfo& model);

/// Whether the model's values are those of the solved paint itself, by parts and in double
/// precision.
bool answers_by_solution(const bsdf::Model& model);

struct BrdfSource {
    std::optional<paint::Recipe> recipe;  ///< none: not known, as from a table
    std::vector<double> wavelengths_nm;
    measure::Brdf brdf;
    bool measured = false;  ///< from a file of a measured BRDF: no model had a part in it
};

/// Reads a recipe, a solved paint, a table of a BRDF or a measured BRDF (measured_source.h). The
/// model microflake answers in double precision, exactly at the wavelengths solved; others as the
/// renderer sees them.
/// @param wavelengths_nm  none: those of a solved paint, else 400 to 700 nm by 10
/// @throws UsageError if a measured BRDF is to be shown by a model, or in parts
/// @throws as load_paint() and load_surface()
BrdfSource load_brdf(const std::filesystem::path& path, const BrdfRequest& request,
                     const std::optional<std::vector<double>>& wavelengths_nm,
                     const CommonOptions& options);

}  // namespace nacre::cli
