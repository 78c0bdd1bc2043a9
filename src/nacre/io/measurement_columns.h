#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/csv.h"

// What the columns of a table of measured colours mean, by their headings, as instruments and
// spreadsheets write them in English and German: docs/measure.md. Internal to this folder.

namespace nacre::io {

/// Nineteen angles with 400 wavelengths each are less.
inline constexpr std::size_t kMaxMeasuredColumns = 20'000;

struct MeasurementHeading {
    /// "geometry", "theta_i", "aspecular_deg", "theta_o", "phi", "l", "a", "b", "c", "h", "x", "y",
    /// "z", "lamp_half_angle_deg", "detector_half_angle_deg", "illuminant", "observer", "sample"
    /// (its name), "sample_id" (its number), "chip", or "r" (a reflectance).
    std::string column;
    double wavelength_nm = 0;  ///< of a reflectance
    bool percent = false;      ///< said to be
    bool factor = false;       ///< said to be a factor, of which 1 is the perfect diffuser
    std::string geometry;      ///< the name, where a colour is at one angle: "L -15"; else empty
};

/// Of "L*", "Helligkeit", "R400", "400 nm [%]", "SPECTRAL_NM400", "L* (-15)", "as15_L" and their
/// like; none for other text.
std::optional<MeasurementHeading> heading_of(std::string_view text);

/// The wavelength where it is that of a reflectance at no angle, such as "R400" or "400 nm".
std::optional<double> wavelength_of_heading(std::string_view text);

/// The name of a geometry as it is read back: "45as-15" for "-15", "as-15", "45/-15" and "-15°", a
/// lamp at 45 deg being meant where none is named; none for other text.
std::optional<std::string> geometry_name_of(std::string_view text);

/// Whether a row names columns of measured colours: their geometries, colours by angle, L, a and b,
/// or wavelengths. Those of a drawdown are none.
bool is_measurement_header(const CsvRow& row);

/// The names that are known, one for each column, for messages.
std::vector<std::string> known_headings();

/// Whether a line begins like one of TOML, with a table in brackets or with "key =".
bool is_toml_line(std::string_view line);

/// The row among the first lines of a text that names columns. Lines above it, such as the name of
/// the instrument, are no part of the table.
struct MeasurementHeader {
    std::size_t line = 1;  ///< counted from 1
    char separator = ',';
};
std::optional<MeasurementHeader> find_measurement_header(std::string_view text);

}  // namespace nacre::io
