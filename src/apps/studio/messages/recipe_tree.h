#pragma once

#include <nlohmann/json.hpp>
#include <string>

// A recipe as its page holds it: the tree of its tables as JSON, keys as docs/recipe.md has them.
// Ranges and meanings are not looked at here: a tree becomes a TOML text, which the one reader of
// recipes reads (io/recipe_file.h).

namespace nacre::studio {

/// Keys keep their order.
using Tree = nlohmann::ordered_json;

/// The tables of a recipe that parses (io::parse_recipe_file), its keys in the order of the text.
/// @param filename  for messages
/// @throws InputError as io::TomlDocument
Tree tree_of_toml(const std::string& text, const std::string& filename);

/// As a person would write it: a header a table, short tables in a line.
/// @throws InputError naming the key if it is not an object at the top, nests too deeply, or holds a
///         null, which TOML has not
std::string toml_of_tree(const Tree& tree);

/// The same tree, but with the comments and the layout of a text that differs from it in values
/// only; without these where it differs in more.
/// @param before  a text of TOML; empty: there is none
/// @throws InputError as toml_of_tree()
std::string toml_of_tree(const Tree& tree, const std::string& before);

}  // namespace nacre::studio
