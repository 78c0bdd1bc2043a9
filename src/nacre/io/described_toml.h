#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/io/table_reader.h"
#include "nacre/paint/description.h"
#include "nacre/spectra/spectrum.h"

// Reads and writes described objects (paint/description.h) as tables of TOML.

namespace nacre::io {

/// Fills the object with what the table says; where it lacks a key that is not required, the object
/// keeps its value. The table must be opened with the keys of the object, paint::keys_of().
/// @throws InputError naming file, line, column, key, value and what is allowed for the first
///         thing that is wrong: an unknown key, a missing one, a wrong type, a number out of range
void read_described(const TableReader& table, const paint::Described& object);

/// The object as TOML that reads back to an equal one, without need of any other file: materials
/// that are not among those shipped are written out sample by sample.
std::string write_described(const paint::Described& object);

// Values as TOML. A number is the shortest text that reads back to the same double.
std::string toml_text(const std::string& text);
/// As it is if it is bare, which is of letters, digits, `_` and `-`, else as a text.
std::string toml_key(const std::string& key);
bool is_bare_toml_key(std::string_view key);
std::string toml_number(double x);
std::string toml_list(const std::vector<double>& values);
std::string toml_spectrum(const spectra::Spectrum& spectrum);

}  // namespace nacre::io
