#include "nacre/io/csv_reader.h"

#include <fmt/format.h>

#include "nacre/core/error.h"
#include "nacre/optics/number_text.h"

namespace nacre::io {

namespace {

char separator_of(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        const std::string_view content = optics::trimmed(line);
        if (!content.empty() && content.front() != '#') {
            if (line.find(',') != std::string_view::npos) return ',';
            if (line.find(';') != std::string_view::npos) return ';';
            if (line.find('\t') != std::string_view::npos) return '\t';
            return ',';
        }
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return ',';
}

/// Walks over a text and knows where it is.
class CsvParser {
 public:
    CsvParser(std::string_view text, const std::string& filename)
        : text_(text), filename_(filename), separator_(separator_of(text)) {}

    std::vector<CsvRow> rows() {
        std::vector<CsvRow> rows;
        while (!at_end()) {
            if (peek() == '#') {
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

    /// Up to the end of the line, which is passed over.
    CsvRow row() {
        CsvRow row;
        while (true) {
            row.push_back(cell());
            if (at_end()) return row;
            const bool last = peek() == '\n';
            advance();
            if (last) return row;
        }
    }
    CsvCell cell() {
        while (!at_cell_end() && (peek() == ' ' || peek() == '\t' || peek() == '\r')) advance();
        CsvCell cell{{}, line_, column()};
        if (++cells_ > kMostCsvCells) fail(cell, fmt::format("more than {} cells", kMostCsvCells));
        if (!at_end() && peek() == '"') {
            quoted(cell);
            return cell;
        }
        const std::size_t begin = position_;
        while (!at_cell_end()) advance();
        cell.text = optics::trimmed(text_.substr(begin, position_ - begin));
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

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& filename) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    return CsvParser(text, filename).rows();
}

std::string csv_cell(std::string_view text) {
    const bool plain = text.find_first_of(",;\t\r\n\"#") == std::string_view::npos &&
                       optics::trimmed(text) == text;
    if (plain) return std::string(text);
    std::string quoted = "\"";
    for (char c : text) {
        if (c == '"') quoted += c;
        quoted += c;
    }
    return quoted + '"';
}

}  // namespace nacre::io
