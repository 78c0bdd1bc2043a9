#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/measure/measurement.h"

// Comma-separated values, as spreadsheets and instruments export them. [shafranovich-2005]

namespace nacre::io {

struct CsvCell {
    std::string text;                  ///< without quotes, and without spaces around unless quoted
    std::size_t line = 1, column = 1;  ///< where it starts, in bytes, counted from 1
};
using CsvRow = std::vector<CsvCell>;

/// In all rows: 250 MB of them, and what the largest text file of numbers needs.
inline constexpr std::size_t kMaxCsvCells = 5'000'000;

/// The rows of a text; lines that are empty or start with '#' are left out. Cells are separated by
/// commas, or by the semicolons or tabs that stand in the first row where it has no comma. A byte
/// order mark and either kind of line end are understood.
/// @throws InputError with file, line and column if a quote is not closed, or something follows
/// one,
///         or there are more than kMaxCsvCells
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& filename);

/// A cell as it is written: quoted where it has to be.
std::string csv_cell(std::string_view text);

// The CSV of io/measurement_file.h. Internal to this folder.

measure::Measurement parse_measurement_csv(std::string_view text, const std::string& filename,
                                           const measure::Conditions& defaults);

/// Whether the first line that says something has a column of geometries or of lamps.
bool has_measurement_header(std::string_view text);

}  // namespace nacre::io
