#include "nacre/io/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/paint/description.h"
#include "nacre/paint/recipe.h"
#include "nacre/spectra/colour.h"

namespace nacre::io {

namespace {

/// Not a number for what is none.
double number_of(const toml::node& node) {
    if (const auto* real = node.as_floating_point()) return real->get();
    if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
    return std::numeric_limits<double>::quiet_NaN();
}

std::string shown(const toml::node& node) {
    if (node.is_table()) return "{...}";
    if (const toml::array* array = node.as_array()) {
        return array->empty() ? "[]" : fmt::format("[...] ({} entries)", array->size());
    }
    // TOML writes every digit, as in 0.10000000000000001; the shortest that reads back will do.
    if (const auto* real = node.as_floating_point()) return fmt::format("{}", real->get());
    std::ostringstream out;
    node.visit([&](const auto& value) {
        if constexpr (toml::is_value<decltype(value)>) out << toml::toml_formatter(value);
    });
    return excerpt(out.str(), kMaxShownLength, ' ');
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += ", ";
        text += word;
    }
    return text;
}

std::string with_keys(const std::vector<std::string>& allowed) {
    return allowed.empty() ? "" : " with the keys " + joined(allowed);
}

}  // namespace

TableReader::TableReader(TomlDocument& document, const Keys& allowed)
    : TableReader(document, document.root(), "", allowed) {}

TableReader::TableReader(TomlDocument& document, const toml::table& table, std::string path,
                         const Keys& allowed)
    : document_(&document), table_(&table), path_(std::move(path)), allowed_(allowed) {
    for (auto&& [key, node] : table) {
        if (!may_have(key.str())) {
            if (!document.references().may_quote()) {
                throw InputError(fmt::format("{}an unknown key; allowed here: {}",
                                             document.place(key.source()), joined(allowed_)));
            }
            throw InputError(fmt::format(
                "{}{} = {}: unknown key{}; allowed here: {}", document.place(key.source()),
                path_of(excerpt(key.str(), kMaxShownLength, ' ')), shown(node),
                did_you_mean(key.str(), allowed_), joined(allowed_)));
        }
        document.note(path_of(key.str()), node.source());
    }
}

bool TableReader::may_have(std::string_view key) const {
    return allowed_.empty() || std::find(allowed_.begin(), allowed_.end(), key) != allowed_.end();
}

TableReader TableReader::narrowed(const Keys& allowed) const {
    return {*document_, *table_, path_, allowed};
}

TableReader TableReader::on(const toml::table& contents, const Keys& allowed) const {
    TableReader other = *this;
    other.table_ = &contents;
    other.allowed_ = allowed;
    return other;
}

std::vector<std::string> TableReader::keys() const {
    std::vector<std::string> keys;
    for (auto&& [key, node] : *table_) keys.emplace_back(key.str());
    return keys;
}

std::string TableReader::path_of(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

void TableReader::fail_at(const std::string& key, const toml::node& node,
                          std::string_view why) const {
    const bool hidden = node.is_string() && !document_->references().may_quote();
    throw InputError(fmt::format("{}{}{}: {}", document_->place(node.source()), key,
                                 hidden ? "" : " = " + shown(node), why));
}

void TableReader::fail(std::string_view key, std::string_view why) const {
    if (const toml::node* node = find(key)) fail_at(path_of(key), *node, why);
    throw InputError(
        fmt::format("{}{}: {}", document_->place(table_->source()), path_of(key), why));
}

void TableReader::fail(std::string_view why) const {
    throw InputError(fmt::format("{}{}: {}", document_->place(table_->source()),
                                 path_.empty() ? "file" : path_, why));
}

const toml::node* TableReader::find(std::string_view key) const {
    if (!may_have(key)) {
        throw std::logic_error(fmt::format("key {} was not announced", key));
    }
    return table_->get(key);
}

const toml::node& TableReader::require(std::string_view key, std::string_view what) const {
    const toml::node* node = find(key);
    if (!node) fail(key, fmt::format("is missing; it must be {}", what));
    return *node;
}

double TableReader::as_number(const toml::node& node, const std::string& key,
                              const Range& range) const {
    const double number = number_of(node);
    if (!std::isfinite(number) || !range.contains(number)) {
        fail_at(key, node,
                "must be a number in " + range.text() + percent_hint(key, number, range));
    }
    return number;
}

double TableReader::number(std::string_view key, const Range& range) const {
    return as_number(require(key, "a number in " + range.text()), path_of(key), range);
}

double TableReader::number(std::string_view key, std::string_view allowed) const {
    const double number = number_of(require(key, allowed));
    if (!std::isfinite(number)) fail(key, fmt::format("must be {}", allowed));
    return number;
}

std::string TableReader::text(std::string_view key, std::size_t max_length) const {
    const std::string what = fmt::format("text of 1 to {} characters", max_length);
    const auto* text = require(key, what).as_string();
    if (!text || text->get().empty() || text->get().size() > max_length)
        fail(key, "must be " + what);
    return text->get();
}

std::string TableReader::text_or(std::string_view key, std::string fallback,
                                 std::size_t max_length) const {
    const toml::node* node = find(key);
    if (!node) return fallback;
    const auto* text = node->as_string();
    if (!text || text->get().size() > max_length) {
        fail(key, fmt::format("must be text of at most {} characters", max_length));
    }
    return text->get();
}

bool TableReader::flag_or(std::string_view key, bool fallback) const {
    const toml::node* node = find(key);
    if (!node) return fallback;
    if (!node->is_boolean()) fail(key, "must be true or false");
    return node->as_boolean()->get();
}

std::vector<double> TableReader::numbers(std::string_view key, const Range& range,
                                         std::size_t min_size, std::size_t max_size) const {
    const std::string what =
        min_size == max_size
            ? fmt::format("{} numbers in {}", max_size, range.text())
            : fmt::format("{} to {} numbers in {}", min_size, max_size, range.text());
    const toml::array* array = require(key, "a list of " + what).as_array();
    if (!array || array->size() < min_size || array->size() > max_size) {
        fail(key, "must be a list of " + what);
    }
    std::vector<double> values;
    values.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i) {
        values.push_back(as_number((*array)[i], fmt::format("{}[{}]", path_of(key), i), range));
    }
    return values;
}

std::vector<std::string> TableReader::texts(std::string_view key, std::size_t max_length,
                                            std::size_t min_size, std::size_t max_size) const {
    const std::string what = fmt::format("a list of {} to {} texts of 1 to {} characters", min_size,
                                         max_size, max_length);
    const toml::array* array = require(key, what).as_array();
    if (!array || array->size() < min_size || array->size() > max_size)
        fail(key, "must be " + what);
    std::vector<std::string> values;
    for (std::size_t i = 0; i < array->size(); ++i) {
        const auto* text = (*array)[i].as_string();
        if (!text || text->get().empty() || text->get().size() > max_length) {
            fail_at(fmt::format("{}[{}]", path_of(key), i), (*array)[i],
                    fmt::format("must be text of 1 to {} characters", max_length));
        }
        values.push_back(text->get());
    }
    return values;
}

std::size_t TableReader::choice(std::string_view key, const std::vector<std::string>& words) const {
    const std::string what = "one of: " + joined(words);
    const auto* text = require(key, what).as_string();
    if (text) {
        const auto found = std::find(words.begin(), words.end(), text->get());
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    }
    fail(key, "must be " + what);
}

TableReader TableReader::table(std::string_view key, const Keys& allowed) const {
    const std::string what = "a table" + with_keys(allowed);
    const toml::table* table = require(key, what).as_table();
    if (!table) fail(key, "must be " + what);
    return {*document_, *table, path_of(key), allowed};
}

std::optional<TableReader> TableReader::table_if_present(std::string_view key,
                                                         const Keys& allowed) const {
    if (!has(key)) return std::nullopt;
    return table(key, allowed);
}

std::vector<TableReader> TableReader::tables(std::string_view key, std::size_t max_size,
                                             const Keys& allowed) const {
    const toml::node* node = find(key);
    if (!node) return {};
    const toml::array* array = node->as_array();
    if (!array || array->empty() || array->size() > max_size) {
        fail(key, fmt::format("must be a list of 1 to {} tables [[{}]]{}", max_size, path_of(key),
                              with_keys(allowed)));
    }
    std::vector<TableReader> readers;
    readers.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i) {
        const std::string entry = fmt::format("{}[{}]", path_of(key), i);
        const toml::table* table = (*array)[i].as_table();
        if (!table) {
            fail_at(entry, (*array)[i], "must be a table" + with_keys(allowed));
        }
        document_->note(entry, table->source());
        readers.emplace_back(*document_, *table, entry, allowed);
    }
    return readers;
}

bool TableReader::is_table(std::string_view key) const { return has(key) && find(key)->is_table(); }
bool TableReader::is_array(std::string_view key) const { return has(key) && find(key)->is_array(); }
bool TableReader::is_text(std::string_view key) const { return has(key) && find(key)->is_string(); }

std::vector<double> read_wavelengths(const TableReader& table, std::string_view key) {
    std::vector<double> wavelengths =
        table.numbers(key, paint::limits::kWavelength, 1, paint::kMaxSpectrumSamples);
    for (std::size_t i = 1; i < wavelengths.size(); ++i) {
        if (!(wavelengths[i] > wavelengths[i - 1])) {
            table.fail(key, fmt::format("must increase, but {} nm follows {} nm", wavelengths[i],
                                        wavelengths[i - 1]));
        }
    }
    return wavelengths;
}

namespace {

constexpr std::size_t kMaxSpectrumPathLength = 2000;

/// A file of two columns, `wavelength_nm` and one of values. Messages give places and numbers, and
/// quote no text: what stands in a file that is no spectrum is not for whoever sees the message.
spectra::Spectrum read_spectrum_file(const TableReader& table, std::string_view key,
                                     const Range& range) {
    const std::string name = table.text(key, kMaxSpectrumPathLength);
    if (!name.ends_with(".csv")) {
        table.fail(key, "must be a number in " + range.text() +
                            ", a table of wavelengths_nm and values, or the path of a .csv file");
    }
    const References& references = table.document().references();
    std::shared_ptr<const std::string> text;
    const std::string file = references.may_quote() ? name : "the file";
    try {
        text = references.read(references.resolve(name), kMaxTextBytes);
    } catch (const InputError& error) {
        if (references.may_quote()) table.fail(key, error.what());
        table.fail(key, "names no spectrum that can be read");
    }
    std::vector<CsvRow> rows;
    try {
        rows = parse_csv(*text, file);
    } catch (const InputError& error) {
        table.fail(key, error.what());
    }
    const auto refuse = [&](const CsvRow& row, const std::string& why) {
        table.fail(key, fmt::format("{}:{}: {}", file, row[0].line, why));
    };
    if (rows.size() < 2 || rows[0].size() != 2 || lowercase(rows[0][0].text) != "wavelength_nm") {
        table.fail(key, fmt::format("{} must have a header of two columns, wavelength_nm and one "
                                    "of values, and a row for each wavelength",
                                    file));
    }
    if (rows.size() - 1 > paint::kMaxSpectrumSamples) {
        table.fail(key, fmt::format("{} has {} rows; at most {} are allowed", file, rows.size() - 1,
                                    paint::kMaxSpectrumSamples));
    }
    CsvNumbers numbers(file, csv_separator(first_csv_line(*text)));
    const auto number = [&](const CsvCell& cell) {
        try {
            return numbers.parse(cell);
        } catch (const InputError& error) {
            table.fail(key, error.what());
        }
    };
    std::vector<double> wavelengths, values;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].size() != 2) {
            refuse(rows[i], "must have two cells" + numbers.advice(rows[i], 2));
        }
        const auto wavelength = number(rows[i][0]), value = number(rows[i][1]);
        if (!wavelength || !paint::limits::kWavelength.contains(*wavelength)) {
            refuse(rows[i], "wavelength_nm must be a number in " +
                                paint::limits::kWavelength.text() +
                                (wavelength ? "" : numbers.advice(rows[i][0])));
        }
        if (!wavelengths.empty() && *wavelength <= wavelengths.back()) {
            refuse(rows[i], "wavelength_nm must be above the one before");
        }
        if (!value || !range.contains(*value)) {
            refuse(rows[i], fmt::format("the value{} must be a number in {}{}",
                                        value ? fmt::format(", {},", *value) : std::string(),
                                        range.text(), value ? "" : numbers.advice(rows[i][1])));
        }
        wavelengths.push_back(*wavelength);
        values.push_back(*value);
    }
    return {std::move(wavelengths), std::move(values)};
}

}  // namespace

spectra::Spectrum read_spectrum(const TableReader& table, std::string_view key,
                                const Range& range) {
    if (table.is_text(key)) return read_spectrum_file(table, key, range);
    if (!table.is_table(key)) return table.number(key, range);
    const TableReader spectrum = table.table(key, {"wavelengths_nm", "values"});
    std::vector<double> wavelengths = read_wavelengths(spectrum, "wavelengths_nm");
    std::vector<double> values = spectrum.numbers("values", range, 1, paint::kMaxSpectrumSamples);
    if (values.size() != wavelengths.size()) {
        spectrum.fail("values", fmt::format("must have as many entries as wavelengths_nm, {}",
                                            wavelengths.size()));
    }
    return {std::move(wavelengths), std::move(values)};
}

spectra::Spectrum read_reflectance(const TableReader& table, std::string_view key) {
    constexpr Range fraction{0, 1};
    if (!table.is_array(key)) return read_spectrum(table, key, fraction);
    const std::vector<double> rgb = table.numbers(key, fraction, 3, 3);
    return spectra::reflectance_from_rec709({rgb[0], rgb[1], rgb[2]});
}

}  // namespace nacre::io
