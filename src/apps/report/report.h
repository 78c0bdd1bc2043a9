#pragma once

#include <set>
#include <string>
#include <vector>

#include "apps/report/page.h"
#include "apps/report/plot_data.h"

// A report for people: headings, text, tables, pictures and plots in one HTML page that needs no
// other file, no network and no script.
//
// Text is UTF-8. Fields described as "text" may carry a little markup, as in Markdown: `code`,
// *emphasis* and [words](address), the address being http, https, mailto, #anchor or a relative
// path. All else is shown as it stands; bytes that are not UTF-8, and control characters, become
// U+FFFD. Colours are "#rrggbb", encoded as sRGB; css_colour() makes them from numbers.

namespace nacre::report {

/// One image of a grid, embedded in the page; a click enlarges it to the window.
struct Picture {
    std::string caption = {};    ///< text below it, also what a screen reader says
    std::string png_bytes = {};  ///< the contents of a PNG file
};

/// One cell of a table.
struct Cell {
    std::string text = {};      ///< text
    bool numeric = false;       ///< set to the right, with digits of equal width
    bool strong = false;        ///< set in bold: the best of a row, say
    std::string swatch = {};    ///< colour of a small patch before the text; empty: none
    std::string footnote = {};  ///< text below the table that a mark in the cell points to
};

/// A cell with a number, as in number_cell("42.7").
Cell number_cell(std::string text);

struct Table {
    std::string caption = {};               ///< text above it
    std::vector<std::string> columns = {};  ///< headings, text; over numbers they stand right
    std::vector<std::vector<Cell>> rows = {};
};

/// A name and what is to be said about it: a parameter and its value.
struct Definition {
    std::string term = {};         ///< text
    std::string description = {};  ///< text
};

/// Collects a report's parts in their order. The page begins with the title, the subtitle and a
/// table of contents.
class Report {
 public:
    /// @param title    plain text without markup
    /// @param subtitle text; may be empty
    explicit Report(std::string title, std::string subtitle = {});

    /// Starts a section.
    /// @param level  1 for a section, 2 and 3 for those inside; the contents list levels 1 and 2
    /// @param anchor its name in links, as in [Table 1](#table-1): small letters, digits, hyphens,
    ///               the first a letter, and not used before; empty: made from the text
    /// @throws DomainError on another level or anchor
    void heading(int level, const std::string& text, const std::string& anchor = {});

    void paragraph(const std::string& text);

    /// A paragraph that stands out: what a hurried reader must not miss.
    void note(const std::string& text);

    void bullets(const std::vector<std::string>& texts);

    void definitions(const std::vector<Definition>& definitions);

    /// @throws DomainError if a row has another number of cells than there are columns, or a swatch
    /// is no colour
    void table(const Table& table);

    /// Pictures side by side, row by row; on a narrow screen at most two in a row.
    /// @param columns pictures in a row, 1 to 8
    /// @param caption text below all of them; may be empty
    /// @throws DomainError on another number of columns, or if a picture is no PNG file
    void pictures(const std::vector<Picture>& pictures, int columns,
                  const std::string& caption = {});

    /// A plot with its legend, and its numbers in a table that unfolds.
    /// @throws DomainError as check(const Plot&)
    void plot(const Plot& plot);

    /// The whole page.
    std::string html() const;

 private:
    std::string title_;
    std::string subtitle_;
    std::vector<Heading> headings_;
    std::set<std::string> anchors_;
    std::string body_;
    int tables_ = 0;
};

}  // namespace nacre::report
