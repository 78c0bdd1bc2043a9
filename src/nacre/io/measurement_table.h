#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/io/measurement_file.h"
#include "nacre/measure/measurement.h"

// Rows and columns of measured colours, from whatever text: a row a geometry, or a row a sample with
// columns by angle. Internal to this folder.

namespace nacre::io {

/// What a format says of its table as a whole.
struct MeasurementTableHints {
    bool decimal_commas = false;       ///< numbers may have one
    std::optional<bool> percent = {};  ///< reflectances are in percent; none: not said
    std::string geometry = {};         ///< of all readings; empty: not said
    bool light_is_noted = false;       ///< note_of_light() has been
};

/// @param rows  the first names the columns
/// @throws InputError as parse_measurement_file()
MeasurementFile read_measurement_table(std::vector<CsvRow> rows, const std::string& filename,
                                       const MeasurementTableHints& hints,
                                       const measure::Conditions& defaults);

}  // namespace nacre::io
