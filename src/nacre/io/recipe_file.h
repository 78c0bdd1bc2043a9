#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/references.h"
#include "nacre/io/file_kind.h"
#include "nacre/paint/parameter_correlation.h"
#include "nacre/paint/parameter_deviation.h"
#include "nacre/paint/recipe.h"
#include "nacre/paint/recipe_parameter.h"

// Paint recipes as TOML. Every key with its unit and range: docs/recipe.md.

namespace nacre::io {

/// Reads a recipe.
///
/// @throws InputError naming file, line, column, key, value and what is allowed for the first
///         thing that is wrong: an unknown key, a missing one, a wrong type, a number out of
///         range, R + T > 1, an unknown material, no layer. Nothing is clamped or guessed.
paint::Recipe read_recipe(const std::filesystem::path& path);

/// The same from a text. `filename` is for messages; `references` are the files that it may name
/// as materials.
paint::Recipe parse_recipe(std::string_view text, const std::string& filename,
                           const References& references);

/// The text that a recipe was read from.
struct RecipeSource {
    std::string text;
    std::string filename;   ///< for messages
    References references;  ///< the files that it may name
};

/// A recipe, the bounds of its numbers in a fit, from the table [fit] of its file, and how well they
/// are known, from its table [uncertainty], both in the order of paint::recipe_parameters(), and
/// which of them are wrong together, in the order of the file. They are not part of the paint.
struct RecipeFile {
    paint::Recipe recipe;
    std::vector<paint::ParameterBounds> bounds;
    std::vector<paint::ParameterDeviation> deviations = {};
    std::vector<paint::ParameterCorrelation> correlations = {};
    /// Null where no text holds it. The numbers above may have been changed since: io/recipe_text.h.
    std::shared_ptr<const RecipeSource> source = {};
};

/// As read_recipe(), which checks these tables too, but does not hand them over.
/// @throws InputError as read_recipe(), as paint::check_bounds(), paint::check_deviation() and
///         paint::check_correlations()
RecipeFile read_recipe_file(const std::filesystem::path& path);
RecipeFile parse_recipe_file(std::string_view text, const std::string& filename,
                             const References& references);
/// The same of a file that has been told apart, whatever it was found to be.
RecipeFile parse_recipe_file(const TypedFile& file);

/// The recipe as TOML that parses back to an equal recipe, without need of any other file:
/// materials that are not among those shipped are written out sample by sample.
std::string write_recipe(const paint::Recipe& recipe,
                         const std::vector<paint::ParameterBounds>& bounds = {},
                         const std::vector<paint::ParameterDeviation>& deviations = {},
                         const std::vector<paint::ParameterCorrelation>& correlations = {});

/// Values of the table [uncertainty], as write_recipe() has them: of a number, and of `correlation`.
std::string toml_deviation(const paint::ParameterDeviation& deviation);
std::string toml_correlations(const std::vector<paint::ParameterCorrelation>& correlations);

/// SHA-256 of write_recipe() of the recipe alone, in hexadecimal: equal for recipes that differ only in
/// layout, comments or the order of keys.
std::string recipe_hash(const paint::Recipe& recipe);

}  // namespace nacre::io
