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
/// In the place of a thickness.
constexpr const char* kOpaque = "opaque";

const std::vector<std::string>& drawdown_columns() {
    static const std::vector<std::string> names = {"ground",
                                                   "thickness_um",
                                                   "volume_fraction",
                                                   "mass_fraction",
                                                   "density_g_per_cm3",
                                                   "binder_density_g_per_cm3",
                                                   "white_volume_fraction",
                                                   "white_mass_fraction",
                                                   "white_density_g_per_cm3"};
    return names;
}

class DrawdownTable {
 public:
    DrawdownTable(std::string_view text, const std::string& filename)
        : filename_(filename),
          rows_(parse_csv(text, filename)),
          numbers_(filename, csv_separator(first_csv_line(text))) {
        if (rows_.empty()) throw InputError(filename + ": is empty: there is no header");
        if (rows_.size() == 1) throw InputError(filename + ": has a header, but no reading");
        if (rows_.size() - 1 > measure::kMaxDrawdownReadings) {
            throw InputError(fmt::format("{}: has {} rows; at most {} are allowed", filename,
                                         rows_.size() - 1, measure::kMaxDrawdownReadings));
        }
        read_header(rows_[0]);
    }

    measure::Drawdown drawdown() {
        measure::Drawdown drawdown;
        for (const auto& [wavelength, column] : spectrum_) {
            drawdown.wavelengths_nm.push_back(wavelength);
        }
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            if (rows_[i].size() != rows_[0].size()) {
                throw InputError(fmt::format("{}has {} cells; the header has {}{}",
                                             place(rows_[i][0]), rows_[i].size(), rows_[0].size(),
                                             numbers_.advice(rows_[i], rows_[0].size())));
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
        if (columns_.contains(columns_.contains("mass_fraction") ? "white_volume_fraction"
                                                                 : "white_mass_fraction")) {
            throw InputError(place(header[0]) +
                             "white and pigment must be given both by volume or both by mass: "
                             "white_volume_fraction stands beside volume_fraction, "
                             "white_mass_fraction beside mass_fraction");
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

    double number(const CsvCell& cell, const std::string& what, const Range& range,
                  const char* or_else = "") {
        const auto value = numbers_.parse(cell);
        if (value && range.contains(*value)) return *value;
        const bool percent = value && *value > range.hi && *value <= 120 && range.hi < 2;
        throw InputError(fmt::format(
            "{}{} = {}: must be a number in {}{}{}", place(cell), what, excerpt(cell.text),
            range.text(), or_else,
            percent ? fmt::format(" (in percent? {} % is {})", excerpt(cell.text), *value / 100)
            : value ? std::string()
                    : numbers_.advice(cell)));
    }
    double number(const CsvRow& row, const std::string& column, const Range& range) {
        return number(cell(row, column), column, range);
    }

    bool is_empty(const CsvRow& row, const std::string& column) const {
        return !columns_.contains(column) || trimmed(cell(row, column).text).empty();
    }

    /// A fraction of a pigment that may be absent from a row.
    double fraction_or_none(const CsvRow& row, const std::string& column, Range allowed) {
        if (is_empty(row, column)) return 0;
        allowed.lo_open = false;  // 0 says the same
        return number(row, column, allowed);
    }

    double density(const CsvRow& row, const std::string& column, const char* needed_by) {
        if (!columns_.contains(column)) {
            throw InputError(
                fmt::format("{}{} needs the column {}", place(rows_[0][0]), needed_by, column));
        }
        return number(row, column, kDrawdownDensity);
    }

    struct Fractions {
        double pigment = 0, white = 0;
    };

    /// Volumes from masses over densities; what is neither pigment nor white is binder.
    Fractions by_volume(const CsvRow& row, double pigment_mass, double white_mass) {
        if (pigment_mass + white_mass >= 1) {
            throw InputError(fmt::format(
                "{}white_mass_fraction = {}: with a mass_fraction of {} nothing is left "
                "for the binder; the sum must be in [0, 1)",
                place(cell(row, "white_mass_fraction")), white_mass, pigment_mass));
        }
        const double binder = columns_.contains("binder_density_g_per_cm3")
                                  ? number(row, "binder_density_g_per_cm3", kDrawdownDensity)
                                  : paint::PigmentMass{}.binder_density_g_per_cm3;
        Fractions out;
        if (pigment_mass > 0) {
            out.pigment = pigment_mass / density(row, "density_g_per_cm3", "mass_fraction");
        }
        if (white_mass > 0) {
            out.white = white_mass / density(row, "white_density_g_per_cm3", "white_mass_fraction");
        }
        const double all = out.pigment + out.white + (1 - pigment_mass - white_mass) / binder;
        out.pigment /= all;
        out.white /= all;
        const Range& allowed = optics::kParticleVolumeRange;
        for (const auto& [column, volume] : {std::pair{"mass_fraction", out.pigment},
                                             std::pair{"white_mass_fraction", out.white}}) {
            if (volume == 0 || allowed.contains(volume)) continue;
            throw InputError(fmt::format(
                "{}{} = {}: with these densities it fills {:.4g} of the paint, which must be in {}",
                place(cell(row, column)), column, cell(row, column).text, volume, allowed.text()));
        }
        return out;
    }

    Fractions fractions(const CsvRow& row) {
        const Range& allowed = optics::kParticleVolumeRange;
        const bool by_mass = columns_.contains("mass_fraction");
        const char* pigment = by_mass ? "mass_fraction" : "volume_fraction";
        const Range range = by_mass ? kDrawdownMass : allowed;
        const double white = by_mass ? fraction_or_none(row, "white_mass_fraction", kDrawdownMass)
                                     : fraction_or_none(row, "white_volume_fraction", allowed);
        // White alone is a tint too, of none of the pigment.
        const double amount =
            white > 0 ? fraction_or_none(row, pigment, range) : number(row, pigment, range);
        return by_mass ? by_volume(row, amount, white) : Fractions{amount, white};
    }

    measure::DrawdownReading reading(const CsvRow& row) {
        measure::DrawdownReading out;
        out.ground = cell(row, "ground").text;
        out.opaque = lowercase(trimmed(cell(row, "thickness_um").text)) == kOpaque;
        if (out.ground.empty() && !out.opaque) {
            throw InputError(place(cell(row, "ground")) +
                             "ground: is missing; only `opaque` paint needs none");
        }
        if (!out.opaque) {
            out.thickness_um = number(cell(row, "thickness_um"), "thickness_um",
                                      measure::kDrawdownThickness, ", or opaque");
        }
        if (!out.is_bare()) {
            const Fractions filled = fractions(row);
            out.volume_fraction = filled.pigment;
            out.white_volume_fraction = filled.white;
        }
        for (const auto& [wavelength, column] : spectrum_) {
            out.reflectance.push_back(
                number(row[column], fmt::format("R{}", wavelength), measure::kDrawdownReflectance));
        }
        return out;
    }

    const std::string& filename_;
    std::vector<CsvRow> rows_;
    CsvNumbers numbers_;
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
    const bool tints = std::any_of(drawdown.readings.begin(), drawdown.readings.end(),
                                   [](const auto& r) { return r.white_volume_fraction > 0; });
    std::string csv = "ground,thickness_um,volume_fraction";
    if (tints) csv += ",white_volume_fraction";
    for (const double wavelength : drawdown.wavelengths_nm) csv += fmt::format(",{}", wavelength);
    csv += '\n';
    for (const measure::DrawdownReading& reading : drawdown.readings) {
        const auto fraction = [&](double value) {
            return reading.is_bare() ? std::string() : fmt::format("{}", value);
        };
        csv += fmt::format("{},{},{}", csv_cell(reading.ground),
                           reading.opaque ? kOpaque : fmt::format("{}", reading.thickness_um),
                           fraction(reading.volume_fraction));
        if (tints) csv += "," + fraction(reading.white_volume_fraction);
        for (const double value : reading.reflectance) csv += fmt::format(",{:.6g}", value);
        csv += '\n';
    }
    return csv;
}

}  // namespace nacre::io
