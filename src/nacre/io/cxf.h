#pragma once

#include <string>
#include <string_view>

#include "nacre/io/measurement_file.h"

// Measured colours as CxF3 [iso-17972-1-2015], the XML in which instruments' software exchanges them:
// objects with reflectance spectra and L*a*b*, each after a specification that states geometry,
// light and observer. What is read of it: docs/measure.md. Internal to this folder.

namespace nacre::io {

/// Whether the text's beginning has the root element of CxF.
bool looks_like_cxf(std::string_view text);

/// @throws InputError as parse_measurement_file(), naming the object where one is at fault
MeasurementFile parse_measurement_cxf(std::string_view text, const std::string& filename,
                                      const measure::Conditions& defaults);

}  // namespace nacre::io
