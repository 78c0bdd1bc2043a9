#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "nacre/layers/recipe.h"

// Paint recipes as TOML. Every key with its unit and range: docs/recipe.md.

namespace nacre::io {

/// Reads a recipe.
///
/// @throws InputError naming file, line, column, key, value and what is allowed for the first
///         thing that is wrong: an unknown key, a missing one, a wrong type, a number out of
///         range, R + T > 1, an unknown material, no layer. Nothing is clamped or guessed.
layers::Recipe read_recipe(const std::filesystem::path& path);

/// The same from a text. `filename` is for messages; materials given as files are looked for from
/// `base_directory`.
layers::Recipe parse_recipe(std::string_view text, const std::string& filename,
                            const std::filesystem::path& base_directory);

/// The recipe as TOML that parses back to an equal recipe, without need of any other file:
/// materials that are not among those shipped are written out sample by sample.
std::string write_recipe(const layers::Recipe& recipe);

/// SHA-256 of write_recipe(), in hexadecimal: equal for recipes that differ only in layout,
/// comments or the order of keys.
std::string recipe_hash(const layers::Recipe& recipe);

}  // namespace nacre::io
