#pragma once

#include <string>
#include <string_view>

#include "nacre/io/measurement_file.h"

// The CSV of io/measurement_file.h. Internal to this folder.

namespace nacre::io {

MeasurementFile parse_measurement_csv(std::string_view text, const std::string& filename,
                                      const measure::Conditions& defaults);

}  // namespace nacre::io
