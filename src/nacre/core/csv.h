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

/// The separator of the cells of a line: of comma, semicolon and tab that which stands in it most
/// often, outside of quotes; of those that stand in it equally often, the first.
char csv_separator(std::string_view line);

/// The first line of a text that is neither empty nor a comment.
std::string_view first_csv_line(std::string_view text);

/// The rows of a text; lines that are empty or start with '#' are left out. A byte order mark and
/// either kind of line end are understood.
/// @param separator  of cells; if none is given, csv_separator() of the first row
/// @throws InputError with file, line and column if the text is not UTF-8, a quote is not closed, or
///         something follows one, or there are more than kMaxCsvCells
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& filename,
                              std::optional<char> separator = std::nullopt);

/// The numbers of the cells of one file, with a decimal point or, where no comma is between the
/// cells, a decimal comma. A file has one of the two: a comma in one number and a point in another
/// may be a separator of thousands, which would be read as a thousandth.
class CsvNumbers {
 public:
    /// @param filename   for messages
    /// @param separator  of the file's cells
    CsvNumbers(std::string filename, char separator);

    /// A finite number; none if the cell holds something else.
    /// @throws InputError with file, line and column if its mark is not that of a cell before
    std::optional<double> parse(const CsvCell& cell);

    /// What helps where a cell that should be a number is none: "; ...", or nothing.
    std::string advice(const CsvCell& cell) const;
    /// The same where a row has another number of cells than the header.
    std::string advice(const CsvRow& row, std::size_t columns) const;

 private:
    std::string filename_;
    bool commas_;
    std::optional<CsvCell> comma_, point_;  // the first of each
};

/// A text as it is written into a cell: quoted where it has to be. A text that a spreadsheet would
/// take for a formula, since it begins with = + - @ and is no number, gets an apostrophe in front,
/// which parse_csv() takes off; so does one that begins with such an apostrophe. Bytes that are no
/// UTF-8 become escape sequences, as in printable().
std::string csv_cell(std::string_view text);

/// A table of csv_cell()s and numbers between commas as spreadsheets read it where the comma is the
/// decimal mark: semicolons between the cells, commas in the numbers.
std::string with_decimal_commas(std::string_view csv);

}  // namespace nacre
