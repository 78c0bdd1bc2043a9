#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/measurement_columns.h"
#include "nacre/io/measurement_formats.h"
#include "nacre/io/measurement_table.h"
#include "nacre/measure/measurement.h"
#include "nacre/spectra/observer.h"
#include "nacre/spectra/rgb.h"

namespace nacre::io {

namespace {

/// Says which lines below the header are comments and would have as many cells as it: names that begin
/// with the mark of comments are usual, and their rows must not vanish in silence.
std::vector<std::string> rows_in_comments(std::string_view text, const std::string& filename,
                                          const MeasurementHeader& header) {
    std::size_t line = 0, first = 0, count = 0;
    std::ptrdiff_t marks = 0;  // between the cells of the header
    for (const std::string_view content : split(text, '\n')) {
        ++line;
        const auto here = std::count(content.begin(), content.end(), header.separator);
        if (line == header.line) marks = here;
        if (line <= header.line || !content.starts_with('#') || here != marks) continue;
        if (count++ == 0) first = line;
    }
    if (count == 0) return {};
    return {
        fmt::format("{}:{}: begins with # as comments do, and is passed over{}; a name that begins "
                    "so stands in quotes",
                    filename, first,
                    count == 1   ? ""
                    : count == 2 ? ", as is one line more"
                                 : fmt::format(", as are {} lines more", count - 1))};
}

}  // namespace

MeasurementFile parse_measurement_csv(std::string_view text, const std::string& filename,
                                      const measure::Conditions& defaults) {
    const auto header = find_measurement_header(text);
    std::vector<CsvRow> rows =
        parse_csv(text, filename, header ? std::optional(header->separator) : std::nullopt);
    std::erase_if(rows, [&](const CsvRow& row) {
        const bool empty = std::all_of(row.begin(), row.end(),
                                       [](const CsvCell& cell) { return cell.text.empty(); });
        return empty || (header && row[0].line < header->line);
    });
    if (!header && !rows.empty()) {
        throw InputError(
            fmt::format("{}:{}:{}: '{}' is in no header that is known; measured colours have "
                        "columns such as {}",
                        filename, rows[0][0].line, rows[0][0].column, excerpt(rows[0][0].text),
                        fmt::join(known_headings(), "; ")));
    }
    const MeasurementTableHints hints{.decimal_commas = header && header->separator != ','};
    MeasurementFile file = read_measurement_table(std::move(rows), filename, hints, defaults);
    if (header) {
        for (std::string& note : rows_in_comments(text, filename, *header)) {
            file.notes.push_back(std::move(note));
        }
    }
    return file;
}

std::string measurement_csv(const measure::Measurement& measurement,
                            const std::vector<std::vector<double>>& standard_error,
                            const std::vector<MeasurementColumn>& more) {
    std::string csv = "geometry,theta_i,aspecular_deg,L,a,b,C,h,X,Y,Z";
    for (double wavelength : measurement.wavelengths_nm) csv += fmt::format(",R{}", wavelength);
    csv +=
        ",theta_o,phi,lamp_half_angle_deg,detector_half_angle_deg,illuminant,observer,chip,sample";
    if (!standard_error.empty()) {
        for (double wavelength : measurement.wavelengths_nm) {
            csv += fmt::format(",SE{}", wavelength);
        }
    }
    for (const MeasurementColumn& column : more) csv += "," + csv_cell(column.name);
    csv += '\n';
    const measure::Conditions& conditions = measurement.conditions;
    for (std::size_t row = 0; row < measurement.readings.size(); ++row) {
        const measure::Reading& reading = measurement.readings[row];
        const measure::Geometry& g = reading.geometry;
        csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}", csv_cell(g.name), g.theta_i_deg,
                           g.aspecular_deg, reading.lab[0], reading.lab[1], reading.lab[2],
                           measure::chroma(reading.lab), measure::hue_deg(reading.lab),
                           reading.xyz[0], reading.xyz[1], reading.xyz[2]);
        for (std::size_t i = 0; i < measurement.wavelengths_nm.size(); ++i) {
            csv += ',';
            if (!reading.reflectance_factor.empty()) {
                csv += fmt::format("{}", reading.reflectance_factor[i]);
            }
        }
        csv += fmt::format(
            ",{},{},{},{},{},{},{},{}", g.theta_o_deg, g.phi_deg,
            conditions.aperture.lamp_half_angle_deg, conditions.aperture.detector_half_angle_deg,
            spectra::name(conditions.illuminant), spectra::name(conditions.observer),
            spectra::css_colour(measure::srgb_chip(reading.lab)), csv_cell(measurement.name));
        if (!standard_error.empty()) {
            for (double error : standard_error.at(row)) csv += fmt::format(",{}", error);
        }
        for (const MeasurementColumn& column : more) csv += "," + csv_cell(column.cells.at(row));
        csv += '\n';
    }
    return csv;
}

}  // namespace nacre::io
