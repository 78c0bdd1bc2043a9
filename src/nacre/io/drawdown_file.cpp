#include "nacre/io/drawdown_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/io/measurement_columns.h"
#include "nacre/io/measurement_file.h"
#include "nacre/optics/particles.h"
#include "nacre/paint/recipe.h"

namespace nacre::io {

namespace {

constexpr Range kDrawdownMass{0, 1, "", true, true};
constexpr Range kDrawdownDensity{0.1, 25, "g/cm^3"};

const std::vector<std::string>& drawdown_columns() {
    static const std::vector<std::string> names = {
        "ground",        "thickness_um",      "volume_fraction",
        "mass_fraction", "density_g_per_cm3", "binder_density_g_per_cm3"};
    return names;
}

class DrawdownTable {
 public:
    DrawdownTable(std::string_view text, const std::string& filename)
        : filename_(filename), rows_(parse_csv(text, filename)) {
        if (rows_.empty()) throw InputError(filename + ": is empty: there is no header");
        if (rows_.size() == 1) throw InputError(filename + ": has a header, but no reading");
        if (rows_.size() - 1 > measure::kMaxDrawdownReadings) {
            throw InputError(fmt::format("{}: has {} rows; at most {} are allowed", filename,
                                         rows_.size() - 1, measure::kMaxDrawdownReadings));
        }
        read_header(rows_[0]);
    }

    measure::Drawdown drawdown() const {
        measure::Drawdown drawdown;
        for (const auto& [wavelength, column] : spectrum_) {
            drawdown.wavelengths_nm.push_back(wavelength);
        }
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            if (rows_[i].size() != rows_[0].size()) {
                throw InputError(fmt::format("{}has {} cells; the header has {}",
                                             place(rows_[i][0]), rows_[i].size(), rows_[0].size()));
            }
            drawdown.readings.push_back(reading(rows_[i]));
        }
        return drawdown;
    }

 private:
    std::string place(const CsvCell& cell) const {
        return fmt::format("{}:{}:{}: ", filename_, cell.line, cell.column);
    }

    void read_header(const CsvRow& header) {
        for (std::size_t i = 0; i < header.size(); ++i) {
            const std::string heading = lowercase(header[i].text);
            if (const auto wavelength = wavelength_of_heading(heading)) {
                if (!kMeasuredWavelength.contains(*wavelength)) {
                    throw InputError(fmt::format("{}wavelength = {}: must be in {}",
                                                 place(header[i]), *wavelength,
                                                 kMeasuredWavelength.text()));
                }
                if (spectrum_.size() == kMaxMeasuredWavelengths) {
                    throw InputError(fmt::format("{}more than {} wavelengths", place(header[i]),
                                                 kMaxMeasuredWavelengths));
                }
                if (!spectrum_.emplace(*wavelength, i).second) {
                    throw InputError(fmt::format("{}wavelength = {} nm: appears twice",
                                                 place(header[i]), *wavelength));
                }
                continue;
            }
            const auto& names = drawdown_columns();
            if (std::find(names.begin(), names.end(), heading) == names.end()) {
                throw InputError(fmt::format(
                    "{}unknown column '{}'{}; a drawdown has the columns {}, and one for each "
                    "wavelength in nm",
                    place(header[i]), excerpt(header[i].text), did_you_mean(heading, names),
                    fmt::join(names, ", ")));
            }
            if (!columns_.emplace(heading, i).second) {
                throw InputError(fmt::format("{}column '{}' appears twice", place(header[i]),
                                             excerpt(header[i].text)));
            }
        }
        for (const char* needed : {"ground", "thickness_um"}) {
            if (!columns_.contains(needed)) {
                throw InputError(fmt::format("{}column '{}' is missing", place(header[0]), needed));
            }
        }
        if (columns_.contains("volume_fraction") == columns_.contains("mass_fraction")) {
            throw InputError(
                fmt::format("{}needs the column volume_fraction or mass_fraction, one of them",
                            place(header[0])));
        }
        if (spectrum_.empty()) {
            throw InputError(
                fmt::format("{}no column is called by a wavelength in nm, such as 400 or R400",
                            place(header[0])));
        }
    }

    const CsvCell& cell(const CsvRow& row, const std::string& column) const {
        return row[columns_.at(column)];
    }

    double number(const CsvCell& cell, const std::string& what, const Range& range) const {
        const auto value = parse_number(cell.text);
        if (value && range.contains(*value)) return *value;
        const bool percent = value && *value > range.hi && *value <= 120 && range.hi < 2;
        throw InputError(fmt::format(
            "{}{} = {}: must be a number in {}{}", place(cell), what, excerpt(cell.text),
            range.text(),
            percent ? fmt::format(" (in percent? {} % is {})", excerpt(cell.text), *value / 100)
                    : std::string()));
    }
    double number(const CsvRow& row, const std::string& column, const Range& range) const {
        return number(cell(row, column), column, range);
    }

    double volume_fraction(const CsvRow& row) const {
        const Range& allowed = optics::kParticleVolumeRange;
        if (columns_.contains("volume_fraction")) return number(row, "volume_fraction", allowed);
        paint::PigmentMass mass;
        mass.fraction = number(row, "mass_fraction", kDrawdownMass);
        if (!columns_.contains("density_g_per_cm3")) {
            throw InputError(place(rows_[0][0]) +
                             "mass_fraction needs the column density_g_per_cm3");
        }
        mass.density_g_per_cm3 = number(row, "density_g_per_cm3", kDrawdownDensity);
        if (columns_.contains("binder_density_g_per_cm3")) {
            mass.binder_density_g_per_cm3 =
                number(row, "binder_density_g_per_cm3", kDrawdownDensity);
        }
        const double volume = mass.volume_fraction();
        if (!allowed.contains(volume)) {
            throw InputError(fmt::format(
                "{}mass_fraction = {}: with these densities the pigment fills {:.4g} of the paint, "
                "which must be in {}",
                place(cell(row, "mass_fraction")), mass.fraction, volume, allowed.text()));
        }
        return volume;
    }

    measure::DrawdownReading reading(const CsvRow& row) const {
        measure::DrawdownReading out;
        out.ground = cell(row, "ground").text;
        if (out.ground.empty()) {
            throw InputError(place(cell(row, "ground")) + "ground: is missing");
        }
        out.thickness_um = number(row, "thickness_um", measure::kDrawdownThickness);
        if (out.thickness_um > 0) out.volume_fraction = volume_fraction(row);
        for (const auto& [wavelength, column] : spectrum_) {
            out.reflectance.push_back(
                number(row[column], fmt::format("R{}", wavelength), measure::kDrawdownReflectance));
        }
        return out;
    }

    const std::string& filename_;
    std::vector<CsvRow> rows_;
    std::map<std::string, std::size_t> columns_;
    std::map<double, std::size_t> spectrum_;
};

}  // namespace

measure::Drawdown parse_drawdown(std::string_view text, const std::string& filename) {
    return DrawdownTable(text, filename).drawdown();
}

measure::Drawdown read_drawdown(const std::filesystem::path& path) {
    return parse_drawdown(read_file(path, kMaxTextFileBytes), path.string());
}

std::string drawdown_csv(const measure::Drawdown& drawdown) {
    std::string csv = "ground,thickness_um,volume_fraction";
    const auto out = std::back_inserter(csv);
    for (const double wavelength : drawdown.wavelengths_nm) fmt::format_to(out, ",{}", wavelength);
    csv += '\n';
    for (const measure::DrawdownReading& reading : drawdown.readings) {
        fmt::format_to(
            out, "{},{},{}", csv_cell(reading.ground), reading.thickness_um,
            reading.thickness_um > 0 ? fmt::format("{}", reading.volume_fraction) : std::string());
        for (const double value : reading.reflectance) fmt::format_to(out, ",{:.6g}", value);
        csv += '\n';
    }
    return csv;
}

}  // namespace nacre::io
