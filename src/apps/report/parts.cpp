#include "apps/report/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "apps/report/markup.h"
#include "apps/report/plot_data.h"
#include "nacre/core/base64.h"
#include "nacre/core/error.h"

namespace nacre::report {

namespace {

struct Size {
    std::uint32_t width, height;
};

// The size of a PNG picture, from its first chunk, IHDR.       [iso-15948-2004, section 11.2.2]
std::optional<Size> png_size(std::string_view bytes) {
    using namespace std::string_view_literals;
    constexpr std::string_view kBeginning = "\x89PNG\r\n\x1a\n\0\0\0\x0DIHDR"sv;
    if (bytes.size() < kBeginning.size() + 8 || bytes.substr(0, kBeginning.size()) != kBeginning) {
        return {};
    }
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
        }
        return value;
    };
    const Size size{number(kBeginning.size()), number(kBeginning.size() + 4)};
    if (size.width == 0 || size.height == 0) return {};
    return size;
}

}  // namespace

std::string pictures_html(const std::vector<Picture>& pictures, int columns,
                          const std::string& caption) {
    if (columns < 1 || columns > 8) {
        throw DomainError(fmt::format("pictures: columns = {} is outside [1, 8]", columns));
    }
    std::string html = fmt::format(
        "<figure class=\"pictures\">\n<div class=\"grid\" style=\"--columns:{}\">\n", columns);
    for (const Picture& picture : pictures) {
        const auto size = png_size(picture.png_bytes);
        if (!size) {
            throw DomainError(fmt::format("the picture '{}' is no PNG file", picture.caption));
        }
        // The hidden check box remembers whether the picture is enlarged: no script is needed.
        const std::string plain = escape_html(markup_to_plain(picture.caption));
        html += fmt::format(
            "<figure><label><input type=\"checkbox\" aria-label=\"Enlarge: {0}\"><img "
            "alt=\"{0}\" width=\"{1}\" height=\"{2}\" src=\"data:image/png;base64,{3}\"></label>",
            plain, size->width, size->height, base64(picture.png_bytes));
        if (!picture.caption.empty()) {
            html += "<figcaption>" + markup_to_html(picture.caption) + "</figcaption>";
        }
        html += "</figure>\n";
    }
    html += "</div>\n";
    if (!caption.empty()) html += "<figcaption>" + markup_to_html(caption) + "</figcaption>\n";
    return html + "</figure>\n";
}

namespace {

// The notes of one table, marked a to z, then aa and so on. Equal notes share a mark.
class Notes {
 public:
    explicit Notes(int table) : table_(table) {}

    // The mark in a cell that points to the note.
    std::string mark(const std::string& text) {
        const auto found = std::find(texts_.begin(), texts_.end(), text);
        const auto index = static_cast<std::size_t>(found - texts_.begin());
        if (found == texts_.end()) texts_.push_back(text);
        return fmt::format("<sup><a href=\"#{}\">{}</a></sup>", name(index), letters(index));
    }

    std::string html() const {
        if (texts_.empty()) return {};
        std::string html = "<ul class=\"notes\">\n";
        for (std::size_t i = 0; i < texts_.size(); ++i) {
            html += fmt::format("<li id=\"{}\"><sup>{}</sup> {}</li>\n", name(i), letters(i),
                                markup_to_html(texts_[i]));
        }
        return html + "</ul>\n";
    }

 private:
    static std::string letters(std::size_t index) {
        std::string text;
        for (std::size_t n = index + 1; n > 0; n = (n - 1) / 26) {
            text.insert(text.begin(), static_cast<char>('a' + (n - 1) % 26));
        }
        return text;
    }

    std::string name(std::size_t index) const {
        return fmt::format("note_{}_{}", table_, letters(index));
    }

    int table_;
    std::vector<std::string> texts_;
};

void check(const Table& table) {
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string where = fmt::format("table '{}', row {}", table.caption, row + 1);
        if (table.rows[row].size() != table.columns.size()) {
            throw DomainError(fmt::format("{}: {} cells for {} columns", where,
                                          table.rows[row].size(), table.columns.size()));
        }
        for (const Cell& cell : table.rows[row]) {
            if (!cell.swatch.empty()) require_colour(cell.swatch, where);
        }
    }
}

bool holds_numbers(const Table& table, std::size_t column) {
    bool any = false;
    for (const auto& row : table.rows) {
        if (row[column].text.empty()) continue;
        if (!row[column].numeric) return false;
        any = true;
    }
    return any;
}

std::string cell_html(const Cell& cell, bool names_row, Notes& notes) {
    std::string text = markup_to_html(cell.text);
    if (cell.strong) text = "<strong>" + text + "</strong>";
    if (!cell.swatch.empty()) {
        text = fmt::format("<span class=\"swatch\" style=\"background:{}\"></span>{}", cell.swatch,
                           text);
    }
    if (!cell.footnote.empty()) text += notes.mark(cell.footnote);
    const char* number = cell.numeric ? " class=\"number\"" : "";
    return names_row ? fmt::format("<th scope=\"row\"{}>{}</th>", number, text)
                     : fmt::format("<td{}>{}</td>", number, text);
}

}  // namespace

Cell number_cell(std::string text) { return {.text = std::move(text), .numeric = true}; }

std::string table_html(const Table& table, int number) {
    check(table);
    Notes notes(number);
    std::string html = "<figure class=\"table\">\n";
    if (!table.caption.empty()) {
        html += "<figcaption>" + markup_to_html(table.caption) + "</figcaption>\n";
    }
    html += "<div class=\"scroll\" tabindex=\"0\"><table>\n<thead><tr>";
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        html += fmt::format("<th scope=\"col\"{}>{}</th>",
                            holds_numbers(table, column) ? " class=\"number\"" : "",
                            markup_to_html(table.columns[column]));
    }
    html += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        html += "<tr>";
        for (std::size_t column = 0; column < row.size(); ++column) {
            html += cell_html(row[column], column == 0 && row.size() > 1, notes);
        }
        html += "</tr>\n";
    }
    return html + "</tbody>\n</table></div>\n" + notes.html() + "</figure>\n";
}

}  // namespace nacre::report
