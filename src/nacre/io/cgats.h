#pragma once

#include <string>
#include <string_view>

#include "nacre/io/measurement_file.h"

// Measured colours as CGATS text [cgats-5-1993; cgats-17-2009], as instruments' software exports
// them: keywords with values, the names of the fields, a set of values for each sample. What is read
// of it: docs/measure.md. Internal to this folder.

namespace nacre::io {

/// Whether a line of the text's beginning names the fields of a table.
bool looks_like_cgats(std::string_view text);

/// @throws InputError as parse_measurement_file(), also if sets have other numbers of values than
///         there are fields, their number is not the stated one, or a second table follows
MeasurementFile parse_measurement_cgats(std::string_view text, const std::string& filename,
                                        const measure::Conditions& defaults);

}  // namespace nacre::io
