#include "nacre/io/measurement_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/measurement_file.h"
#include "nacre/spectra/observer.h"
#include "nacre/spectra/rgb.h"

namespace nacre::io {

namespace {

// ------------------------------------------------------------------------------- the columns

/// The names that a column may have, in small letters.
const std::map<std::string, std::vector<std::string>>& column_names() {
    static const std::map<std::string, std::vector<std::string>> names = {
        {"geometry", {"geometry"}},
        {"theta_i", {"theta_i", "theta_i_deg"}},
        {"aspecular_deg", {"aspecular_deg", "aspecular"}},
        {"theta_o", {"theta_o", "theta_o_deg"}},
        {"phi", {"phi", "phi_deg"}},
        {"l", {"l", "l*"}},
        {"a", {"a", "a*"}},
        {"b", {"b", "b*"}},
        {"c", {"c", "c*"}},
        {"h", {"h", "h_deg"}},
        {"x", {"x"}},
        {"y", {"y"}},
        {"z", {"z"}},
        {"lamp_half_angle_deg", {"lamp_half_angle_deg"}},
        {"detector_half_angle_deg", {"detector_half_angle_deg"}},
        {"illuminant", {"illuminant"}},
        {"observer", {"observer"}},
        {"sample", {"sample"}},
        {"chip", {"chip"}},
    };
    return names;
}

class MeasurementTable {
 public:
    MeasurementTable(std::string_view text, const std::string& filename)
        : filename_(filename), rows_(parse_csv(text, filename)) {
        if (rows_.empty()) throw InputError(filename + ": is empty: there is no header");
        if (rows_.size() - 1 > kMaxReadings) {
            throw InputError(fmt::format("{}: has {} rows; at most {} are allowed", filename,
                                         rows_.size() - 1, kMaxReadings));
        }
        if (rows_.size() == 1) throw InputError(filename + ": has a header, but no reading");
        read_header(rows_[0]);
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            if (rows_[i].size() != rows_[0].size()) {
                throw InputError(fmt::format("{}has {} cells; the header has {}",
                                             place(rows_[i][0]), rows_[i].size(), rows_[0].size()));
            }
        }
    }

    measure::Measurement measurement(measure::Conditions conditions) const {
        conditions.illuminant = same_in_all_rows(
            "illuminant", conditions.illuminant,
            [](const std::string& text) { return spectra::parse_illuminant(text); });
        conditions.observer =
            same_in_all_rows("observer", conditions.observer,
                             [](const std::string& text) { return spectra::parse_observer(text); });
        conditions.aperture.lamp_half_angle_deg =
            half_angle("lamp_half_angle_deg", conditions.aperture.lamp_half_angle_deg);
        conditions.aperture.detector_half_angle_deg =
            half_angle("detector_half_angle_deg", conditions.aperture.detector_half_angle_deg);
        const std::string sample =
            same_in_all_rows("sample", std::string{}, [](const std::string& text) { return text; });
        std::vector<MeasurementRow> rows;
        for (std::size_t i = 1; i < rows_.size(); ++i) rows.push_back(read_row(rows_[i]));
        return assemble_measurement(sample, conditions, wavelengths_nm_, rows);
    }

 private:
    std::string place(const CsvCell& cell) const {
        return fmt::format("{}:{}:{}: ", filename_, cell.line, cell.column);
    }

    void read_header(const CsvRow& header) {
        std::vector<std::string> known;
        for (const auto& [column, names] : column_names()) {
            known.insert(known.end(), names.begin(), names.end());
        }
        for (std::size_t i = 0; i < header.size(); ++i) {
            const std::string heading = lowercase(header[i].text);
            if (const auto wavelength = wavelength_of_heading(heading)) {
                add_wavelength(header[i], *wavelength, i);
                continue;
            }
            const auto found =
                std::find_if(column_names().begin(), column_names().end(), [&](const auto& entry) {
                    return std::find(entry.second.begin(), entry.second.end(), heading) !=
                           entry.second.end();
                });
            if (found == column_names().end()) {
                // Exporters add dates and comments, which are ignored; a misspelt name of a known
                // column must not be.
                const auto meant = closest_match(heading, known);
                if (meant && meant->size() > 2) {
                    throw InputError(fmt::format("{}unknown column '{}'{}", place(header[i]),
                                                 excerpt(header[i].text),
                                                 did_you_mean(heading, known)));
                }
                continue;
            }
            if (!columns_.emplace(found->first, i).second) {
                throw InputError(fmt::format("{}column '{}' appears twice", place(header[i]),
                                             excerpt(header[i].text)));
            }
        }
    }

    void add_wavelength(const CsvCell& heading, double wavelength_nm, std::size_t column) {
        if (!kMeasuredWavelength.contains(wavelength_nm)) {
            throw InputError(fmt::format("{}wavelength = {}: must be in {}", place(heading),
                                         wavelength_nm, kMeasuredWavelength.text()));
        }
        if (!wavelengths_nm_.empty() && !(wavelength_nm > wavelengths_nm_.back())) {
            throw InputError(fmt::format("{}wavelength = {} nm: must be above the {} nm before it",
                                         place(heading), wavelength_nm, wavelengths_nm_.back()));
        }
        if (wavelengths_nm_.size() == kMaxMeasuredWavelengths) {
            throw InputError(
                fmt::format("{}more than {} wavelengths", place(heading), kMaxMeasuredWavelengths));
        }
        wavelengths_nm_.push_back(wavelength_nm);
        spectrum_columns_.push_back(column);
    }

    /// Null if there is no such column, or the cell is empty.
    const CsvCell* cell(const CsvRow& row, const std::string& column) const {
        const auto found = columns_.find(column);
        if (found == columns_.end() || row[found->second].text.empty()) return nullptr;
        return &row[found->second];
    }

    double number(const CsvCell& cell, const std::string& what, const Range& range) const {
        const auto value = parse_number(cell.text);
        if (!value || !range.contains(*value)) {
            throw InputError(fmt::format("{}{} = {}: must be a number in {}", place(cell), what,
                                         excerpt(cell.text), range.text()));
        }
        return *value;
    }
    std::optional<double> number(const CsvRow& row, const std::string& column,
                                 const Range& range) const {
        const CsvCell* found = cell(row, column);
        if (!found) return std::nullopt;
        return number(*found, rows_[0][columns_.at(column)].text, range);  // as the file calls it
    }

    /// Three columns that belong together, or none of them.
    std::optional<Vec3d> triple(const CsvRow& row, const char* const (&columns)[3],
                                const Range& range) const {
        Vec3d values{};
        int found = 0;
        for (int c = 0; c < 3; ++c) {
            if (const auto value = number(row, columns[c], range)) {
                values[c] = *value;
                ++found;
            }
        }
        if (found == 0) return std::nullopt;
        if (found < 3) {
            throw InputError(fmt::format("{}{}, {} and {}: one is given without the others",
                                         place(row[0]), columns[0], columns[1], columns[2]));
        }
        return values;
    }

    std::optional<Vec3d> lab(const CsvRow& row) const {
        if (cell(row, "a") || cell(row, "b")) return triple(row, {"l", "a", "b"}, kMeasuredColour);
        auto lch = triple(row, {"l", "c", "h"}, kMeasuredColour);
        if (!lch) return std::nullopt;
        const double h = (*lch)[2] * std::numbers::pi / 180, c = (*lch)[1];
        return Vec3d{(*lch)[0], c * std::cos(h), c * std::sin(h)};
    }

    MeasurementRow read_row(const CsvRow& cells) const {
        MeasurementRow row;
        row.place = place(cells[0]);
        if (const CsvCell* name = cell(cells, "geometry")) row.name = name->text;
        row.theta_i_deg = number(cells, "theta_i", kMeasuredAngle);
        row.aspecular_deg = number(cells, "aspecular_deg", kMeasuredAngle);
        row.theta_o_deg = number(cells, "theta_o", kMeasuredAngle);
        row.phi_deg = number(cells, "phi", kMeasuredAngle);
        row.lab = lab(cells);
        row.xyz = triple(cells, {"x", "y", "z"}, kMeasuredTristimulus);
        const bool has_spectrum =
            std::any_of(spectrum_columns_.begin(), spectrum_columns_.end(),
                        [&](std::size_t column) { return !cells[column].text.empty(); });
        if (has_spectrum) {
            for (std::size_t i = 0; i < spectrum_columns_.size(); ++i) {
                row.reflectance_factor.push_back(number(cells[spectrum_columns_[i]],
                                                        fmt::format("R{}", wavelengths_nm_[i]),
                                                        kMeasuredReflectance));
            }
        }
        return row;
    }

    double half_angle(const std::string& column, double fallback) const {
        return same_in_all_rows(column, fallback, [](const std::string& text) {
            const auto value = parse_number(text);
            if (!value || !measure::kHalfAngle.contains(*value)) {
                throw InputError(fmt::format("'{}' is no number in {}", excerpt(text),
                                             measure::kHalfAngle.text()));
            }
            return *value;
        });
    }

    /// The value of a column that concerns the whole file.
    template <class Value, class Parse>
    Value same_in_all_rows(const std::string& column, Value fallback, const Parse& parse) const {
        const CsvCell* first = nullptr;
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            const CsvCell* here = cell(rows_[i], column);
            if (!here) {
                if (!first) continue;
                throw InputError(fmt::format("{}{}: is missing here, but is '{}' above",
                                             place(rows_[i][0]), column, excerpt(first->text)));
            }
            if (!first && i > 1) {
                throw InputError(fmt::format("{}{} = {}: is missing in the rows above",
                                             place(*here), column, excerpt(here->text)));
            }
            if (first && here->text != first->text) {
                throw InputError(
                    fmt::format("{}{} = {}: is '{}' above; it must be the same in "
                                "all rows",
                                place(*here), column, excerpt(here->text), excerpt(first->text)));
            }
            first = here;
        }
        if (!first) return fallback;
        try {
            return parse(first->text);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}{}: {}", place(*first), column, error.what()));
        }
    }

    const std::string& filename_;
    std::vector<CsvRow> rows_;
    std::map<std::string, std::size_t> columns_;
    std::vector<double> wavelengths_nm_;
    std::vector<std::size_t> spectrum_columns_;
};

}  // namespace

std::optional<double> wavelength_of_heading(const std::string& heading) {
    std::string_view text = heading;
    if (text.starts_with('r')) text.remove_prefix(1);
    if (text.ends_with("nm")) text.remove_suffix(2);
    return parse_number(text);
}

measure::Measurement parse_measurement_csv(std::string_view text, const std::string& filename,
                                           const measure::Conditions& defaults) {
    return MeasurementTable(text, filename).measurement(defaults);
}

bool has_measurement_header(std::string_view text) {
    // The first line that is neither empty nor a comment.
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        const std::string_view content = trimmed(line);
        if (!content.empty() && content.front() != '#') {
            std::vector<CsvRow> header;
            try {
                header = parse_csv(line, "");
            } catch (const InputError&) {
                return false;
            }
            return !header.empty() &&
                   std::any_of(header[0].begin(), header[0].end(), [](const CsvCell& cell) {
                       const std::string heading = lowercase(cell.text);
                       return heading == "geometry" || heading == "aspecular_deg" ||
                              heading == "aspecular" || heading == "theta_i" ||
                              heading == "theta_i_deg";
                   });
        }
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return false;
}

std::string measurement_csv(const measure::Measurement& measurement,
                            const std::vector<std::vector<double>>& standard_error,
                            const std::vector<MeasurementColumn>& more) {
    std::string csv = "geometry,theta_i,aspecular_deg,L,a,b,C,h,X,Y,Z";
    const auto out = std::back_inserter(csv);
    for (double wavelength : measurement.wavelengths_nm) fmt::format_to(out, ",R{}", wavelength);
    csv +=
        ",theta_o,phi,lamp_half_angle_deg,detector_half_angle_deg,illuminant,observer,chip,sample";
    if (!standard_error.empty()) {
        for (double wavelength : measurement.wavelengths_nm) {
            fmt::format_to(out, ",SE{}", wavelength);
        }
    }
    for (const MeasurementColumn& column : more) csv += "," + csv_cell(column.name);
    csv += '\n';
    const measure::Conditions& conditions = measurement.conditions;
    for (std::size_t row = 0; row < measurement.readings.size(); ++row) {
        const measure::Reading& reading = measurement.readings[row];
        const measure::Geometry& g = reading.geometry;
        fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{}", csv_cell(g.name), g.theta_i_deg,
                       g.aspecular_deg, reading.lab[0], reading.lab[1], reading.lab[2],
                       measure::chroma(reading.lab), measure::hue_deg(reading.lab), reading.xyz[0],
                       reading.xyz[1], reading.xyz[2]);
        for (std::size_t i = 0; i < measurement.wavelengths_nm.size(); ++i) {
            csv += ',';
            if (!reading.reflectance_factor.empty()) {
                fmt::format_to(out, "{}", reading.reflectance_factor[i]);
            }
        }
        fmt::format_to(
            out, ",{},{},{},{},{},{},{},{}", g.theta_o_deg, g.phi_deg,
            conditions.aperture.lamp_half_angle_deg, conditions.aperture.detector_half_angle_deg,
            spectra::name(conditions.illuminant), spectra::name(conditions.observer),
            spectra::css_colour(measure::srgb_chip(reading.lab)), csv_cell(measurement.name));
        if (!standard_error.empty()) {
            for (double error : standard_error.at(row)) fmt::format_to(out, ",{}", error);
        }
        for (const MeasurementColumn& column : more) csv += "," + csv_cell(column.cells.at(row));
        csv += '\n';
    }
    return csv;
}

}  // namespace nacre::io
