#include "nacre/core/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/text.h"

namespace nacre {

namespace {

constexpr const char* kCommasNeed = "; decimal commas need semicolons or tabs between the cells";

/// Whether spreadsheets take a cell for a formula.
bool looks_like_formula(std::string_view text) {
    constexpr std::string_view kStarts = "=+-@\t\r";
    return !text.empty() && kStarts.find(text.front()) != std::string_view::npos &&
           !parse_number(text);
}

/// Apostrophes in front of what looks like a formula.
bool is_disarmed(std::string_view text) {
    const std::size_t marks = std::min(text.find_first_not_of('\''), text.size());
    return marks > 0 && looks_like_formula(text.substr(marks));
}

/// Splits a text into rows of cells, each with the line and column where it starts.
class CsvParser {
 public:
    CsvParser(std::string_view text, const std::string& filename, char separator)
        : text_(text), filename_(filename), separator_(separator) {}

    std::vector<CsvRow> rows() {
        std::vector<CsvRow> rows;
        while (!at_end()) {
            if (trimmed(text_.substr(position_, text_.find('\n', position_) - position_))
                    .starts_with('#')) {
                while (!at_end() && peek() != '\n') advance();
            }
            CsvRow row = this->row();
            if (row.size() > 1 || !row[0].text.empty()) rows.push_back(std::move(row));
        }
        return rows;
    }

 private:
    bool at_end() const { return position_ == text_.size(); }
    char peek() const { return text_[position_]; }
    bool at_cell_end() const { return at_end() || peek() == separator_ || peek() == '\n'; }
    void advance() {
        if (text_[position_++] == '\n') {
            ++line_;
            line_start_ = position_;
        }
    }
    std::size_t column() const { return position_ - line_start_ + 1; }

    /// Cells up to the end of the line, which is consumed with them.
    CsvRow row() {
        CsvRow row;
        while (true) {
            row.push_back(cell());
            if (is_disarmed(row.back().text)) row.back().text.erase(0, 1);
            if (at_end()) return row;
            const bool last = peek() == '\n';
            advance();
            if (last) return row;
        }
    }
    CsvCell cell() {
        while (!at_cell_end() && (peek() == ' ' || peek() == '\t' || peek() == '\r')) advance();
        CsvCell cell{{}, line_, column()};
        if (++cells_ > kMaxCsvCells) fail(cell, fmt::format("more than {} cells", kMaxCsvCells));
        if (!at_end() && peek() == '"') {
            quoted(cell);
            return cell;
        }
        const std::size_t begin = position_;
        while (!at_cell_end()) advance();
        cell.text = trimmed(text_.substr(begin, position_ - begin));
        return cell;
    }
    void quoted(CsvCell& cell) {
        advance();
        while (true) {
            if (at_end()) fail(cell, "the quote that starts here is not closed");
            const char c = peek();
            advance();
            if (c != '"') {
                cell.text += c;
            } else if (!at_end() && peek() == '"') {
                cell.text += '"';
                advance();
            } else {
                break;
            }
        }
        while (!at_cell_end()) {
            if (peek() != ' ' && peek() != '\t' && peek() != '\r') {
                fail(cell, "something follows the quoted text before the next separator");
            }
            advance();
        }
    }
    [[noreturn]] void fail(const CsvCell& cell, std::string_view why) const {
        throw InputError(fmt::format("{}:{}:{}: {}", filename_, cell.line, cell.column, why));
    }

    std::string_view text_;
    const std::string& filename_;
    char separator_;
    std::size_t position_ = 0, line_ = 1, line_start_ = 0, cells_ = 0;
};

}  // namespace

char csv_separator(std::string_view line) {
    constexpr std::string_view kSeparators = ",;\t";
    std::size_t counts[kSeparators.size()] = {};
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        const std::size_t which = kSeparators.find(c);
        if (!quoted && which != std::string_view::npos) ++counts[which];
    }
    return kSeparators[static_cast<std::size_t>(std::max_element(counts, std::end(counts)) -
                                                counts)];
}

std::string_view first_csv_line(std::string_view text) {
    text = without_byte_order_mark(text);
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        const std::string_view content = trimmed(line);
        if (!content.empty() && content.front() != '#') return line;
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return {};
}

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& filename,
                              std::optional<char> separator) {
    require_utf8(text, filename);
    text = without_byte_order_mark(text);
    return CsvParser(text, filename, separator.value_or(csv_separator(first_csv_line(text))))
        .rows();
}

CsvNumbers::CsvNumbers(std::string filename, char separator)
    : filename_(std::move(filename)), commas_(separator != ',') {}

std::optional<double> CsvNumbers::parse(const CsvCell& cell) {
    std::string text = replaced(replaced(cell.text, "\u2212", "-"), "\u00b0", "");
    const bool point = text.find('.') != std::string::npos;
    const bool comma = commas_ && !point && std::count(text.begin(), text.end(), ',') == 1;
    if (comma) text = replaced(text, ",", ".");
    const auto value = parse_number(text);
    if (value && comma && !comma_) comma_ = cell;
    if (value && point && !point_) point_ = cell;
    if (comma_ && point_) {
        throw InputError(fmt::format(
            "{}:{}:{}: {} has a decimal comma, but {} in line {} has a point; a file must have "
            "one or the other, and nothing between thousands",
            filename_, comma_->line, comma_->column, excerpt(comma_->text), excerpt(point_->text),
            point_->line));
    }
    return value;
}

std::string CsvNumbers::advice(const CsvCell& cell) const {
    if (cell.text.find(',') == std::string::npos) return "";
    return commas_ ? "; thousands are written without a mark" : kCommasNeed;
}

std::string CsvNumbers::advice(const CsvRow& row, std::size_t columns) const {
    return !commas_ && row.size() > columns ? kCommasNeed : "";
}

std::string csv_cell(std::string_view text) {
    // A name of a file may hold any bytes, a table may not.
    if (first_not_utf8(text) || text.find('\0') != std::string_view::npos) {
        return csv_cell(printable(text));
    }
    const bool disarm = looks_like_formula(text) || is_disarmed(text);
    const std::string mark = disarm ? "'" : "";
    const bool plain =
        text.find_first_of(",;\t\r\n\"#") == std::string_view::npos && trimmed(text) == text;
    if (plain) return mark + std::string(text);
    std::string quoted = "\"" + mark;
    for (char c : text) {
        if (c == '"') quoted += c;
        quoted += c;
    }
    return quoted + '"';
}

std::string with_decimal_commas(std::string_view csv) {
    std::string result;
    std::size_t begin = 0;  // of a cell
    bool quoted = false;
    for (std::size_t i = 0; i <= csv.size(); ++i) {
        const bool end = i == csv.size();
        if (!end && csv[i] == '"') quoted = !quoted;
        if (!end && (quoted || (csv[i] != ',' && csv[i] != '\n'))) continue;
        const std::string_view cell = csv.substr(begin, i - begin);
        result += parse_number(cell) ? replaced(cell, ".", ",") : std::string(cell);
        if (!end) result += csv[i] == ',' ? ';' : csv[i];
        begin = i + 1;
    }
    return result;
}

}  // namespace nacre
