#include "nacre/io/measurement_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/colour_agreement.h"
#include "nacre/io/measurement_columns.h"
#include "nacre/io/measurement_scale.h"
#include "nacre/spectra/observer.h"

namespace nacre::io {

namespace {

/// Columns whose misspelt names are refused; other names are those of dates and remarks.
const std::vector<std::string>& watched_names() {
    static const std::vector<std::string> names = {
        "geometry",      "theta_i",  "theta_i_deg",
        "aspecular",     "theta_o",  "theta_o_deg",
        "aspecular_deg", "phi_deg",  "lamp_half_angle_deg",
        "illuminant",    "observer", "detector_half_angle_deg"};
    return names;
}

constexpr std::size_t kMaxMeasuredAngles = 1000;  // that columns are called by

/// The columns of one reading: those of a row, or those of an angle in it.
struct ReadingColumns {
    std::string geometry;  ///< by which the columns are called; empty: a row is a reading
    std::map<std::string, std::size_t> columns = {};
    std::vector<std::size_t> spectrum = {};
    std::vector<double> wavelengths_nm = {};
};

class MeasurementTable {
 public:
    MeasurementTable(std::vector<CsvRow> rows, const std::string& filename,
                     const MeasurementTableHints& hints)
        : filename_(filename),
          hints_(hints),
          rows_(std::move(rows)),
          numbers_(filename, hints.decimal_commas ? ';' : ',') {
        if (rows_.empty()) throw InputError(filename + ": is empty: there is no header");
        if (rows_.size() == 1) throw InputError(filename + ": has a header, but no reading");
        read_header(rows_[0]);
        if ((rows_.size() - 1) * readings_.size() > kMaxReadings) {
            throw InputError(fmt::format("{}: has {} readings; at most {} are allowed", filename,
                                         (rows_.size() - 1) * readings_.size(), kMaxReadings));
        }
        for (std::size_t i = 1; i < rows_.size(); ++i) fit_to_header(rows_[i]);
    }

    MeasurementFile samples(measure::Conditions conditions) {
        conditions.illuminant = same_in_all_rows(
            "illuminant", conditions.illuminant,
            [](const CsvCell& cell) { return spectra::parse_illuminant(cell.text); });
        conditions.observer = same_in_all_rows(
            "observer", conditions.observer,
            [](const CsvCell& cell) { return spectra::parse_observer(cell.text); });
        conditions.aperture.lamp_half_angle_deg =
            half_angle("lamp_half_angle_deg", conditions.aperture.lamp_half_angle_deg);
        conditions.aperture.detector_half_angle_deg =
            half_angle("detector_half_angle_deg", conditions.aperture.detector_half_angle_deg);
        std::vector<std::string> names;  // of samples
        std::vector<std::size_t> sample_of;
        std::vector<MeasurementRow> readings;
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            const std::size_t sample = sample_of_row(i, names);
            for (const ReadingColumns& columns : readings_) {
                if (auto reading = read(rows_[i], columns)) {
                    readings.push_back(std::move(*reading));
                    sample_of.push_back(sample);
                }
            }
        }
        MeasurementFile file;
        apply_scale(readings, conditions, file.notes);
        if (!hints_.light_is_noted && std::ranges::any_of(readings, states_colour)) {
            const auto states = [&](const char* column) {
                return cell(rows_[1], columns_, column);
            };
            if (const auto note = note_of_light(filename_, states("illuminant"), states("observer"),
                                                conditions)) {
                file.notes.push_back(*note);
            }
        }
        std::vector<std::vector<MeasurementRow>> by_sample(names.size());
        for (std::size_t i = 0; i < readings.size(); ++i) {
            by_sample[sample_of[i]].push_back(std::move(readings[i]));
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (by_sample[i].empty()) continue;  // an empty row among them
            ColourAgreement agreement;
            file.samples.push_back(assemble_measurement(names[i], conditions, wavelengths_nm_,
                                                        by_sample[i], agreement));
            file.contradictions.push_back(agreement.contradictions());
        }
        if (file.samples.empty()) throw InputError(filename_ + ": has a header, but no reading");
        return file;
    }

 private:
    std::string place(const CsvCell& cell) const {
        return fmt::format("{}:{}:{}: ", filename_, cell.line, cell.column);
    }
    bool by_angle() const { return !readings_[0].geometry.empty(); }

    // ------------------------------------------------------------------------------ the header

    void read_header(const CsvRow& header) {
        if (header.size() > kMaxMeasuredColumns) {
            throw InputError(
                fmt::format("{}more than {} columns", place(header[0]), kMaxMeasuredColumns));
        }
        std::vector<std::optional<MeasurementHeading>> headings;
        bool names_geometries = false;
        for (const CsvCell& cell : header) {
            headings.push_back(heading_of(cell.text));
            if (!headings.back()) continue;
            const std::string& column = headings.back()->column;
            names_geometries = names_geometries || column == "geometry" ||
                               column == "aspecular_deg" || column == "theta_i";
        }
        ReadingColumns row;  // what is called by no angle
        for (std::size_t i = 0; i < header.size(); ++i) {
            const auto& heading = headings[i];
            if (!heading) {
                refuse_misspelt(header[i]);
            } else if (heading->geometry.empty()) {
                add(row, *heading, header[i], i);
            } else if (!names_geometries) {
                add(columns_of(heading->geometry, header[i]), *heading, header[i], i);
            }
        }
        columns_ = row.columns;
        if (readings_.empty()) readings_.push_back(std::move(row));
        for (const ReadingColumns& columns : readings_) {
            if (columns.wavelengths_nm.empty()) continue;  // colours alone were read there
            if (wavelengths_nm_.empty()) wavelengths_nm_ = columns.wavelengths_nm;
            if (columns.wavelengths_nm != wavelengths_nm_) {
                throw InputError(
                    fmt::format("{}the spectra at {} have other wavelengths than those "
                                "before them",
                                place(header[0]), columns.geometry));
            }
        }
    }

    ReadingColumns& columns_of(const std::string& geometry, const CsvCell& cell) {
        const auto found = std::ranges::find(readings_, geometry, &ReadingColumns::geometry);
        if (found != readings_.end()) return *found;
        if (readings_.size() == kMaxMeasuredAngles) {
            throw InputError(fmt::format("{}more than {} angles", place(cell), kMaxMeasuredAngles));
        }
        return readings_.emplace_back(ReadingColumns{.geometry = geometry});
    }

    void add(ReadingColumns& columns, const MeasurementHeading& heading, const CsvCell& cell,
             std::size_t position) {
        if (heading.column == "r") {
            add_wavelength(columns, heading, cell, position);
        } else if (!columns.columns.emplace(heading.column, position).second) {
            throw InputError(
                fmt::format("{}column '{}' appears twice", place(cell), excerpt(cell.text)));
        }
    }

    void add_wavelength(ReadingColumns& columns, const MeasurementHeading& heading,
                        const CsvCell& cell, std::size_t position) {
        std::vector<double>& nm = columns.wavelengths_nm;
        if (!kMeasuredWavelength.contains(heading.wavelength_nm)) {
            throw InputError(fmt::format("{}wavelength = {}: must be in {}", place(cell),
                                         heading.wavelength_nm, kMeasuredWavelength.text()));
        }
        if (!nm.empty() && !(heading.wavelength_nm > nm.back())) {
            throw InputError(fmt::format("{}wavelength = {} nm: must be above the {} nm before it",
                                         place(cell), heading.wavelength_nm, nm.back()));
        }
        if (nm.size() == kMaxMeasuredWavelengths) {
            throw InputError(
                fmt::format("{}more than {} wavelengths", place(cell), kMaxMeasuredWavelengths));
        }
        says_percent_ = says_percent_ || heading.percent;
        says_factor_ = says_factor_ || heading.factor;
        nm.push_back(heading.wavelength_nm);
        columns.spectrum.push_back(position);
    }

    /// Exporters add dates and comments, which are passed over; a misspelt name must not be.
    void refuse_misspelt(const CsvCell& cell) const {
        if (!closest_match(cell.text, watched_names())) return;
        throw InputError(fmt::format("{}unknown column '{}'{}", place(cell), excerpt(cell.text),
                                     did_you_mean(cell.text, watched_names())));
    }

    /// Spreadsheets fill rows with empty cells.
    void fit_to_header(CsvRow& row) const {
        const std::size_t width = rows_[0].size();
        while (row.size() > width && row.back().text.empty()) row.pop_back();
        if (row.size() == width) return;
        const bool commas = row.size() > width && !hints_.decimal_commas;
        throw InputError(fmt::format(
            "{}has {} cells; the header has {}{}", place(row[0]), row.size(), width,
            commas ? "; decimal commas need semicolons or tabs between the cells" : ""));
    }

    // -------------------------------------------------------------------------------- the rows

    /// Null if there is no such column, or the cell is empty.
    static const CsvCell* cell(const CsvRow& row, const std::map<std::string, std::size_t>& columns,
                               const std::string& column) {
        const auto found = columns.find(column);
        if (found == columns.end() || row[found->second].text.empty()) return nullptr;
        return &row[found->second];
    }

    double number(const CsvCell& cell, const std::string& what, const Range& range) {
        const auto value = numbers_.parse(cell);
        if (!value || !range.contains(*value)) {
            throw InputError(fmt::format("{}{} = {}: must be a number in {}{}", place(cell), what,
                                         excerpt(cell.text), range.text(),
                                         value ? "" : numbers_.advice(cell)));
        }
        return *value;
    }
    std::optional<double> number(const CsvRow& row, const ReadingColumns& columns,
                                 const std::string& column, const Range& range) {
        const CsvCell* found = cell(row, columns.columns, column);
        if (!found) return std::nullopt;
        // As the file calls it.
        return number(*found, rows_[0][columns.columns.at(column)].text, range);
    }

    /// Three columns that belong together, or none of them.
    std::optional<WrittenColour> triple(const CsvRow& row, const ReadingColumns& columns,
                                        const char* const (&names)[3], const Range& range) {
        Vec3d values{};
        double unit = 1;  // of all three: zeros at the end of one may be left out
        int found = 0;
        for (int c = 0; c < 3; ++c) {
            if (const auto value = number(row, columns, names[c], range)) {
                values[c] = *value;
                unit = std::min(unit, last_digit(cell(row, columns.columns, names[c])->text));
                ++found;
            }
        }
        if (found == 0) return std::nullopt;
        if (found < 3) {
            // As in headings: L, a and b; X, Y and Z.
            const auto written = [](char name) {
                constexpr std::string_view kSmall = "abh";
                return kSmall.find(name) != std::string_view::npos
                           ? name
                           : static_cast<char>(std::toupper(name));
            };
            throw InputError(fmt::format("{}{}, {} and {}{}: one is given without the others",
                                         place(row[0]), written(*names[0]), written(*names[1]),
                                         written(*names[2]),
                                         by_angle() ? " at " + columns.geometry : ""));
        }
        return WrittenColour{values, {unit, unit, unit}};
    }

    /// Beside a and b: none unless they are numbers, as the hue of greys is often none.
    std::optional<WrittenColour> chroma_beside(const CsvRow& row, const ReadingColumns& columns) {
        for (const char* name : {"l", "c", "h"}) {
            const CsvCell* found = cell(row, columns.columns, name);
            const auto value = found ? CsvNumbers(numbers_).parse(*found) : std::nullopt;
            if (!value || !kMeasuredColour.contains(*value)) return std::nullopt;
        }
        return triple(row, columns, {"l", "c", "h"}, kMeasuredColour);
    }

    void read_colour(const CsvRow& row, const ReadingColumns& columns, MeasurementRow& reading) {
        const auto has = [&](const char* name) { return cell(row, columns.columns, name); };
        reading.states_lab = has("a") || has("b") || !(has("c") || has("h"));
        if (reading.states_lab) {
            if (const auto lab = triple(row, columns, {"l", "a", "b"}, kMeasuredColour)) {
                reading.lab = lab->values;
                reading.lab_unit = lab->unit;
            }
            reading.lch = chroma_beside(row, columns);
        } else {
            reading.lch = triple(row, columns, {"l", "c", "h"}, kMeasuredColour);
            if (reading.lch) reading.lab = lab_of_lch(reading.lch->values);
        }
        if (const auto xyz = triple(row, columns, {"x", "y", "z"}, kMeasuredTristimulus)) {
            reading.xyz = xyz->values;
            reading.xyz_unit = xyz->unit;
        }
    }

    std::vector<double> spectrum(const CsvRow& row, const ReadingColumns& columns, double& unit) {
        const bool there = std::any_of(columns.spectrum.begin(), columns.spectrum.end(),
                                       [&](std::size_t i) { return !row[i].text.empty(); });
        std::vector<double> values;
        unit = 1;
        for (std::size_t i = 0; there && i < columns.spectrum.size(); ++i) {
            CsvCell cell = row[columns.spectrum[i]];
            if (cell.text.ends_with('%')) {  // as spreadsheets show a number in percent
                cell.text = trimmed(std::string_view(cell.text).substr(0, cell.text.size() - 1));
                says_percent_ = true;
            }
            values.push_back(
                number(cell, fmt::format("R{}", columns.wavelengths_nm[i]), kMeasuredReflectance));
            unit = std::min(unit, last_digit(cell.text));
        }
        return values;
    }

    /// The name of a geometry; "-15" is the text of a number.
    std::string geometry_in(const CsvRow& row) {
        const CsvCell* name = cell(row, columns_, "geometry");
        if (!name) return {};
        // Beside directions a name is a label, which may be a number too.
        if (cell(row, columns_, "theta_o")) return name->text;
        if (const auto angle = numbers_.parse(*name)) return fmt::format("{}", *angle);
        const std::string spaceless = replaced(replaced(name->text, "\u2212", "-"), " ", "");
        return spaceless == name->text ? name->text
                                       : geometry_name_of(spaceless).value_or(name->text);
    }

    /// None where a row says nothing at an angle.
    std::optional<MeasurementRow> read(const CsvRow& row, const ReadingColumns& columns) {
        MeasurementRow reading;
        reading.place = place(row[0]);
        if (by_angle()) {
            reading.name = columns.geometry;
        } else if (columns_.contains("geometry")) {
            reading.name = geometry_in(row);
        } else if (!columns_.contains("aspecular_deg") && !columns_.contains("theta_i")) {
            reading.name = hints_.geometry;
        }
        read_colour(row, columns, reading);
        reading.reflectance_factor = spectrum(row, columns, reading.reflectance_unit);
        if (by_angle()) {
            if (!reading.lab && !reading.xyz && reading.reflectance_factor.empty()) return {};
            return reading;
        }
        reading.theta_i_deg = number(row, columns, "theta_i", kMeasuredAngle);
        reading.aspecular_deg = number(row, columns, "aspecular_deg", kMeasuredAngle);
        reading.theta_o_deg = number(row, columns, "theta_o", kMeasuredAngle);
        reading.phi_deg = number(row, columns, "phi", kMeasuredAngle);
        return reading;
    }

    /// A row of angles is a sample; rows of one angle each belong to that which they name.
    std::size_t sample_of_row(std::size_t row, std::vector<std::string>& names) {
        const CsvCell *name = cell(rows_[row], columns_, "sample"),
                      *number = cell(rows_[row], columns_, "sample_id");
        if (!name && !hints_.geometry.empty()) name = number;
        if (by_angle()) {
            if (!name) name = number;
            const bool one = rows_.size() == 2;
            names.push_back(name ? name->text : one ? std::string() : fmt::format("{}", row));
            return names.size() - 1;
        }
        if (!name && !names.empty() && !names.back().empty()) {
            throw InputError(fmt::format("{}sample: is missing here, but is '{}' above",
                                         place(rows_[row][0]), excerpt(names.back())));
        }
        if (name && !names.empty() && names[0].empty()) {
            throw InputError(fmt::format("{}sample = {}: is missing in the rows above",
                                         place(*name), excerpt(name->text)));
        }
        const auto [place_of, is_new] =
            sample_places_.emplace(name ? name->text : std::string(), names.size());
        if (is_new) names.push_back(place_of->first);
        return place_of->second;
    }

    void apply_scale(std::vector<MeasurementRow>& readings, const measure::Conditions& conditions,
                     std::vector<std::string>& notes) const {
        if (says_percent_ && says_factor_) {
            throw InputError(fmt::format(
                "{}the reflectances of some columns are in percent, those of others factors",
                place(rows_[0][0])));
        }
        MeasurementScale scale{says_percent_ || hints_.percent.value_or(false), {}};
        if (!says_percent_ && !says_factor_ && !hints_.percent) {
            scale = measurement_scale(readings, wavelengths_nm_, conditions, filename_);
        }
        if (!scale.note.empty()) notes.push_back(scale.note);
        if (!scale.percent) return;
        for (MeasurementRow& reading : readings) {
            for (double& value : reading.reflectance_factor) value /= 100;
            reading.reflectance_unit /= 100;
        }
    }

    // ------------------------------------------------------------------ what concerns the file

    double half_angle(const std::string& column, double fallback) {
        return same_in_all_rows(column, fallback, [&](const CsvCell& cell) {
            const auto value = numbers_.parse(cell);
            if (!value || !measure::kHalfAngle.contains(*value)) {
                throw InputError(fmt::format("'{}' is no number in {}", excerpt(cell.text),
                                             measure::kHalfAngle.text()));
            }
            return *value;
        });
    }

    template <class Value, class Parse>
    Value same_in_all_rows(const std::string& column, Value fallback, const Parse& parse) const {
        const CsvCell* first = nullptr;
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            const CsvCell* here = cell(rows_[i], columns_, column);
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
                    fmt::format("{}{} = {}: is '{}' above; it must be the same in all rows",
                                place(*here), column, excerpt(here->text), excerpt(first->text)));
            }
            first = here;
        }
        if (!first) return fallback;
        try {
            return parse(*first);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}{}: {}", place(*first), column, error.what()));
        }
    }

    const std::string& filename_;
    const MeasurementTableHints& hints_;
    std::vector<CsvRow> rows_;
    CsvNumbers numbers_;
    std::map<std::string, std::size_t> columns_;  // of a row as a whole
    std::vector<ReadingColumns> readings_;        // one at least
    std::vector<double> wavelengths_nm_;          // of all spectra
    std::map<std::string, std::size_t> sample_places_;
    bool says_percent_ = false, says_factor_ = false;
};

}  // namespace

MeasurementFile read_measurement_table(std::vector<CsvRow> rows, const std::string& filename,
                                       const MeasurementTableHints& hints,
                                       const measure::Conditions& defaults) {
    return MeasurementTable(std::move(rows), filename, hints).samples(defaults);
}

}  // namespace nacre::io
