#pragma once

#include <toml++/toml.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/references.h"
#include "nacre/io/table_reader.h"
#include "nacre/paint/recipe.h"

// Files of pigments (TOML): the keys of [[layer.pigment]] but the amount and `from`, and a
// `source`. A recipe names one by `from`. Those of data/pigments are part of the library.

namespace nacre::io {

/// A file of data/pigments, compiled into the library.
struct ShippedPigment {
    std::string_view name;
    std::string_view toml;
};

/// By their names, sorted.
std::span<const ShippedPigment> shipped_pigments();

/// What a file of a pigment says.
struct PigmentFile {
    paint::Pigment pigment;  ///< with the volume fraction that was asked for
    std::string source;      ///< of its numbers
};

/// @param filename         for messages
/// @param volume_fraction  of the pigment in the layer that it will be in, (0, 0.5]
/// @throws InputError naming file, line, key, value and allowed range
PigmentFile parse_pigment_file(std::string_view text, const std::string& filename,
                               double volume_fraction);
/// The same of a file that has been told apart; it may name no files.
PigmentFile parse_pigment_file(const TypedFile& file, double volume_fraction);

/// A pigment that ships, by its name, or the file of one: what ends in .toml.
/// @throws InputError as parse_pigment_file(), naming those that ship if it is neither
PigmentFile find_pigment(const std::string& name, double volume_fraction);

/// The white of tints, named as find_pigment() takes it: of some amount, in whose place each tint puts
/// its own.
/// @throws InputError as find_pigment()
paint::Pigment find_white(const std::string& name);

/// Whether a text has keys of a pigment and no others.
bool looks_like_pigment(const TomlDocument& document);

/// The text of such a file, without the pigment's amount.
std::string write_pigment_file(const PigmentFile& file);

/// The keys that stand beside `from` in a recipe: how much of the pigment there is, and its name.
std::vector<std::string> keys_beside_from();

/// The table of a pigment in a recipe, whose key `from` names a file, with the keys of the file.
/// @throws InputError if there is no such file, or it is wrong inside, or a key of the file stands
///         in the recipe too, or the recipe says no amount
std::shared_ptr<const toml::table> with_keys_from(const TableReader& table, std::string_view from);

}  // namespace nacre::io
