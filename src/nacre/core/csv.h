#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Comma-separated values, as spreadsheets and instruments export them. [shafranovich-2005]

namespace nacre {

struct CsvCell {
    std::string text;                  ///< without quotes, without spaces around unless quoted, and
                                       ///< without the apostrophe of csv_cell()
    std::size_t line = 1, column = 1;  ///< where it starts, in bytes, counted from 1
};
using CsvRow = std::vector<CsvCell>;

/// Limit on the cells of one text, all rows together: some 250 MB of memory. A text of
/// kMaxTextFileBytes (core/file.h) reaches it with 13 bytes a cell.
inline constexpr std::size_t kMaxCsvCells = 5'000'000;

/// The rows of a text; lines that are empty or start with '#' are left out. A byte order mark and
/// either kind of line end are understood.
/// @param separator  of cells; if none is given, the commas, or else the semicolons, or else the
///                   tabs that stand in the first row
/// @throws InputError with file, line and column if a quote is not closed, or something follows
///         one, or there are more than kMaxCsvCells
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& filename,
                              std::optional<char> separator = std::nullopt);

/// A text as it is written into a cell: quoted where it has to be. A text that a spreadsheet would
/// take for a formula, since it begins with = + - @ and is no number, gets an apostrophe in front,
/// which parse_csv() takes off; so does one that begins with such an apostrophe.
std::string csv_cell(std::string_view text);

}  // namespace nacre
