#pragma once

#include <string>
#include <string_view>

#include "nacre/measure/measurement.h"

// The JSON of io/measurement_file.h. Internal to this folder.

namespace nacre::io {

measure::Measurement parse_measurement_json(std::string_view text, const std::string& filename,
                                            const measure::Conditions& defaults);

}  // namespace nacre::io
