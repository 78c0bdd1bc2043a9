#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "nacre/measure/measurement.h"

// The CSV of io/measurement_file.h. Internal to this folder.

namespace nacre::io {

measure::Measurement parse_measurement_csv(std::string_view text, const std::string& filename,
                                           const measure::Conditions& defaults);

/// Of a column called "R400", "r400nm", "400" or "400 nm", in small letters; none for other text.
std::optional<double> wavelength_of_heading(const std::string& heading);

/// Whether the first line that is neither empty nor a comment has a column of geometries,
/// aspecular angles or angles of incidence.
bool has_measurement_header(std::string_view text);

}  // namespace nacre::io
