#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/measurement_formats.h"
#include "nacre/io/measurement_table.h"
#include "nacre/spectra/observer.h"

namespace nacre::io {

namespace {

constexpr std::size_t kCgatsHeadBytes = std::size_t{1} << 16;
constexpr std::string_view kBeginFormat = "BEGIN_DATA_FORMAT", kEndFormat = "END_DATA_FORMAT",
                           kBeginData = "BEGIN_DATA", kEndData = "END_DATA";

/// A table of CGATS.
struct CgatsTable {
    std::map<std::string, CsvCell> keywords;
    CsvRow fields;
    std::vector<CsvRow> sets;
};

class CgatsParser {
 public:
    CgatsParser(std::string_view text, const std::string& filename)
        : text_(without_byte_order_mark(text)), filename_(filename) {}

    CgatsTable table() {
        enum class Part { keywords, fields, sets, end } part = Part::keywords;
        while (next_line()) {
            const CsvRow line = cells_between_spaces();
            if (line.empty()) continue;
            const std::string& first = line[0].text;
            if (first == kBeginFormat || first == kBeginData) {
                if (part == Part::end || (first == kBeginFormat && !table_.fields.empty())) {
                    fail(line[0], "a second table begins here; one is read");
                }
                if (first == kBeginData && table_.fields.empty()) {
                    fail(line[0], "values begin before BEGIN_DATA_FORMAT has named their fields");
                }
                part = first == kBeginFormat ? Part::fields : Part::sets;
            } else if (first == kEndFormat) {
                part = Part::keywords;
            } else if (first == kEndData) {
                part = Part::end;
            } else if (part == Part::fields) {
                table_.fields.insert(table_.fields.end(), line.begin(), line.end());
            } else if (part == Part::sets) {
                add_to_sets(line);
            } else if (part == Part::keywords && line.size() > 1) {
                // WEIGHTING_FUNCTION stands once for the light and once for the observer.
                const auto [known, is_new] = table_.keywords.emplace(first, line[1]);
                if (!is_new) known->second.text += ";" + line[1].text;
            }
        }
        if (part == Part::sets) throw InputError(filename_ + ": ends without END_DATA");
        if (!unfinished_.empty()) wrong_number(unfinished_);
        check_number("NUMBER_OF_SETS", table_.sets.size());
        check_number("NUMBER_OF_FIELDS", table_.fields.size());
        return std::move(table_);
    }

 private:
    bool next_line() {
        if (text_.empty()) return false;
        line_ = text_.substr(0, text_.find('\n'));
        text_.remove_prefix(std::min(text_.size(), line_.size() + 1));
        ++line_number_;
        return true;
    }

    [[noreturn]] void fail(const CsvCell& cell, const std::string& why) const {
        throw InputError(fmt::format("{}:{}:{}: {}", filename_, cell.line, cell.column, why));
    }
    [[noreturn]] void wrong_number(const CsvRow& set) const {
        fail(set[0], fmt::format("has {} values; BEGIN_DATA_FORMAT names {} fields", set.size(),
                                 table_.fields.size()));
    }

    CsvCell cell(std::size_t begin, std::size_t end) const {
        return {std::string(line_.substr(begin, end - begin)), line_number_, begin + 1};
    }

    void count_cell() {
        if (++cells_ > kMaxCsvCells) {
            throw InputError(fmt::format("{}: more than {} values", filename_, kMaxCsvCells));
        }
    }

    /// Words, and texts in quotes, up to a comment.
    CsvRow cells_between_spaces() {
        constexpr std::string_view kSpaces = " \t\r";
        CsvRow row;
        for (std::size_t at = 0; at < line_.size();) {
            if (kSpaces.find(line_[at]) != std::string_view::npos) {
                ++at;
                continue;
            }
            if (line_[at] == '#') break;
            count_cell();
            if (line_[at] == '"') {
                const std::size_t end = line_.find('"', at + 1);
                if (end == std::string_view::npos) {
                    fail(cell(at, at), "the quote that starts here is not closed");
                }
                row.push_back(cell(at + 1, end));
                row.back().column = at + 1;
                at = end + 1;
            } else {
                const std::size_t end = std::min(line_.find_first_of(kSpaces, at), line_.size());
                row.push_back(cell(at, end));
                at = end;
            }
        }
        return row;
    }

    /// What stands between tabs, spaces in it included.
    CsvRow cells_between_tabs() {
        CsvRow row;
        std::size_t begin = 0;
        for (const std::string_view piece : split(line_, '\t')) {
            count_cell();
            std::string_view text = trimmed(piece);
            if (text.size() > 1 && text.front() == '"' && text.back() == '"') {
                text = text.substr(1, text.size() - 2);
            }
            row.push_back({std::string(text), line_number_, begin + 1});
            begin += piece.size() + 1;
        }
        while (!row.empty() && row.back().text.empty()) row.pop_back();
        return row;
    }

    /// A set may stand in several lines, but begins with a line.
    void add_to_sets(const CsvRow& line) {
        const std::size_t wanted = table_.fields.size();
        if (unfinished_.empty() && line.size() != wanted &&
            line_.find('\t') != std::string_view::npos) {
            // Names with spaces that nobody quoted.
            if (CsvRow row = cells_between_tabs(); row.size() == wanted) {
                table_.sets.push_back(std::move(row));
                return;
            }
        }
        unfinished_.insert(unfinished_.end(), line.begin(), line.end());
        if (unfinished_.size() > wanted) wrong_number(unfinished_);
        if (unfinished_.size() < wanted) return;
        table_.sets.push_back(std::move(unfinished_));
        unfinished_.clear();
    }

    void check_number(const std::string& keyword, std::size_t found) const {
        const auto stated = table_.keywords.find(keyword);
        if (stated == table_.keywords.end()) return;
        if (parse_number(stated->second.text) == static_cast<double>(found)) return;
        fail(stated->second,
             fmt::format("{} = {}: there are {}", keyword, excerpt(stated->second.text), found));
    }

    std::string_view text_;
    const std::string& filename_;
    std::string_view line_;
    std::size_t line_number_ = 0, cells_ = 0;
    CgatsTable table_;
    CsvRow unfinished_;
};

// ----------------------------------------------------------------------- what the keywords say

/// The value that a keyword has, or a part of one: "Illumination=D50 ObserverAngle=2", "OBSERVER, 10
/// degree".
std::optional<CsvCell> stated(const CgatsTable& table, std::initializer_list<const char*> keywords,
                              std::initializer_list<std::string_view> parts) {
    for (const char* keyword : keywords) {
        if (const auto found = table.keywords.find(keyword); found != table.keywords.end()) {
            return found->second;
        }
    }
    for (const char* keyword : {"MEASUREMENT_SOURCE", "WEIGHTING_FUNCTION"}) {
        const auto found = table.keywords.find(keyword);
        if (found == table.keywords.end()) continue;
        const std::string text = lowercase(found->second.text);
        for (const std::string_view part : parts) {
            std::size_t at = text.find(part);
            if (at == std::string::npos) continue;
            at = text.find_first_not_of(" =,:", at + part.size());
            if (at == std::string::npos) continue;
            const std::size_t end = text.find_first_of(" ;,\t", at);
            CsvCell cell = found->second;
            cell.text = cell.text.substr(at, end == std::string::npos ? end : end - at);
            return cell;
        }
    }
    return std::nullopt;
}

template <class Parse>
auto parsed_keyword(const CsvCell& cell, const std::string& filename, const Parse& parse) {
    try {
        return parse(cell.text);
    } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}:{}:{}: {}", filename, cell.line, cell.column, error.what()));
    }
}

/// Light and observer, and a note about what is not stated.
measure::Conditions conditions_of(const CgatsTable& table, const std::string& filename,
                                  measure::Conditions conditions, std::vector<std::string>& notes) {
    const auto illuminant = stated(table, {"ILLUMINANT", "ILLUMINANT_NAME", "ILLUMINATION_NAME"},
                                   {"illumination", "illuminant"});
    const auto observer =
        stated(table, {"OBSERVER", "OBSERVER_ANGLE"}, {"observerangle", "observer"});
    if (illuminant) {
        conditions.illuminant = parsed_keyword(*illuminant, filename, spectra::parse_illuminant);
    }
    if (observer) {
        conditions.observer = parsed_keyword(*observer, filename, [](const std::string& text) {
            const auto field = words(text);  // further ones say more about the observer
            return spectra::parse_observer(field.empty() ? text : std::string(field[0]));
        });
    }
    if (const auto note =
            note_of_light(filename, illuminant.has_value(), observer.has_value(), conditions)) {
        notes.push_back(*note);
    }
    return conditions;
}

// -------------------------------------------------------------------------- what the fields say

/// SPECTRAL_NM beside SPECTRAL_PCT or SPECTRAL_DEC holds a wavelength in each set, which must be the
/// same in all: it becomes the heading of the values.
void name_wavelengths(CgatsTable& table, const std::string& filename) {
    std::vector<bool> is_wavelength(table.fields.size(), false);
    for (std::size_t i = 0; i + 1 < table.fields.size() && !table.sets.empty(); ++i) {
        CsvCell& value = table.fields[i + 1];
        const bool percent = value.text == "SPECTRAL_PCT";
        if (table.fields[i].text != "SPECTRAL_NM" || (!percent && value.text != "SPECTRAL_DEC")) {
            continue;
        }
        const std::string& wavelength = table.sets[0][i].text;
        for (const CsvRow& set : table.sets) {
            if (set[i].text == wavelength) continue;
            throw InputError(fmt::format(
                "{}:{}:{}: SPECTRAL_NM = {}: is {} in the first set; it "
                "must be the same in all",
                filename, set[i].line, set[i].column, excerpt(set[i].text), excerpt(wavelength)));
        }
        value.text = fmt::format("R{} [{}]", wavelength, percent ? "%" : "1");
        is_wavelength[i] = true;
    }
    const auto without_wavelengths = [&](CsvRow& row) {
        CsvRow kept;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (!is_wavelength[i]) kept.push_back(std::move(row[i]));
        }
        row = std::move(kept);
    };
    without_wavelengths(table.fields);
    for (CsvRow& set : table.sets) without_wavelengths(set);
}

}  // namespace

bool looks_like_cgats(std::string_view text) {
    text = without_byte_order_mark(text.substr(0, kCgatsHeadBytes));
    for (const std::string_view line : split(text, '\n')) {
        if (trimmed(line) == kBeginFormat) return true;
    }
    return false;
}

MeasurementFile parse_measurement_cgats(std::string_view text, const std::string& filename,
                                        const measure::Conditions& defaults) {
    require_utf8(text, filename);
    CgatsTable table = CgatsParser(text, filename).table();
    name_wavelengths(table, filename);
    std::vector<std::string> notes;
    const measure::Conditions conditions = conditions_of(table, filename, defaults, notes);
    MeasurementTableHints hints{.decimal_commas = true, .light_is_noted = true};
    if (const auto norm = table.keywords.find("SPECTRAL_NORM"); norm != table.keywords.end()) {
        const auto value = parse_number(norm->second.text);
        if (value != 1.0 && value != 100.0) {
            throw InputError(fmt::format("{}:{}:{}: SPECTRAL_NORM = {}: must be 1 or 100", filename,
                                         norm->second.line, norm->second.column,
                                         excerpt(norm->second.text)));
        }
        hints.percent = value == 100.0;
    }
    if (const auto geometry = stated(table, {"GEOMETRY", "MEASUREMENT_GEOMETRY"}, {"geometry"})) {
        hints.geometry = geometry->text;
    }
    std::vector<CsvRow> rows = {std::move(table.fields)};
    rows.insert(rows.end(), std::make_move_iterator(table.sets.begin()),
                std::make_move_iterator(table.sets.end()));
    MeasurementFile file = read_measurement_table(std::move(rows), filename, hints, conditions);
    file.notes.insert(file.notes.begin(), notes.begin(), notes.end());
    return file;
}

}  // namespace nacre::io
