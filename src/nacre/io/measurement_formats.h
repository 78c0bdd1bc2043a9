#pragma once

#include <string>
#include <string_view>

#include "nacre/io/measurement_file.h"

// The formats of measured colours that parse_measurement_file() tells apart. What is read of each:
// docs/measure.md. Internal to this folder.

namespace nacre::io {

/// Rows of numbers, as Nacre writes them or a spreadsheet does.
MeasurementFile parse_measurement_csv(std::string_view text, const std::string& filename,
                                      const measure::Conditions& defaults);

/// CGATS [cgats-5-1993; cgats-17-2009], as instruments' software exports it: keywords with values,
/// the names of the fields, a set of values for each sample.
/// @throws InputError as parse_measurement_file(), also if sets have other numbers of values than
///         there are fields, their number is not the stated one, or a second table follows
MeasurementFile parse_measurement_cgats(std::string_view text, const std::string& filename,
                                        const measure::Conditions& defaults);
/// Whether a line of the text's beginning names the fields of a table.
bool looks_like_cgats(std::string_view text);

/// CxF3 [iso-17972-1-2015], the XML in which instruments' software exchanges them: objects with
/// reflectance spectra and L*a*b*, each after a specification that states geometry, light and
/// observer.
/// @throws InputError as parse_measurement_file(), naming the object where one is at fault
MeasurementFile parse_measurement_cxf(std::string_view text, const std::string& filename,
                                      const measure::Conditions& defaults);
/// Whether the text's beginning has the root element of CxF.
bool looks_like_cxf(std::string_view text);

}  // namespace nacre::io
