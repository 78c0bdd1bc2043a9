#pragma once

#include <string>
#include <utility>
#include <vector>

#include "nacre/core/references.h"
#include "nacre/io/recipe_file.h"

// The text of a recipe whose values were changed: what a person wrote stays as it is, comments and
// layout, but for these values.

namespace nacre::io {

struct RecipeText {
    std::string text;
    /// Why the recipe was written anew (write_recipe()), without the comments and the layout of its
    /// source. Empty if these are kept, or if it has no source.
    std::string rewritten;
};

/// The recipe's source with the numbers that differ from it. Where such a number is part of a
/// pigment that the source names by `from`, all keys of that pigment are written down there.
/// The text is read again: if that does not give the recipe, it is written anew.
/// @param there  the files that the text may name where it will stand
RecipeText recipe_text(const RecipeFile& file, const References& there);

/// A key and a value of a recipe as a user writes them: "coats[0].material", "SiO2".
using RecipeSetting = std::pair<std::string, std::string>;

/// The recipe with other values, read from its text with these in it (which becomes its source).
///
/// A key is one of those in paint::recipe_parameters(), or that of any other value, list or table,
/// or the end of one, as paint::matching_parameters() takes them; or the whole path of a key that the recipe's
/// tables may have. `X.max` scales the spectrum X. Values are as toml_value().
/// @throws DomainError "key=value: reason", naming the full key, its value and what is allowed
RecipeFile with_settings(const RecipeFile& file, const std::vector<RecipeSetting>& settings);

}  // namespace nacre::io
