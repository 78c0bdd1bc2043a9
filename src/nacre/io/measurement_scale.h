#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/io/measurement_file.h"
#include "nacre/measure/measurement.h"

// Whether a table whose headings do not say so holds reflectances in percent. Internal to this
// folder.

namespace nacre::io {

struct MeasurementScale {
    bool percent = false;
    std::string note;  ///< what was decided and why, where it was; else empty
};

/// Decides by the colours beside the spectra, where there are any: both scales are tried, and the one
/// that is nearer by far is taken. Else by the values of the whole file. Far from the gloss, at aspecular angles of 45 deg and more, no paint
/// has a reflectance factor above kMaxFactorFarFromGloss; near it metallic paints reach a few, but not
/// kMaxFactor. Between the two, values below kMinPercent tell a factor: a dark paint still
/// reflects more than so many percent.
/// @param rows  with the values as they stand
/// @throws InputError if neither tells, saying how to write what is meant
MeasurementScale measurement_scale(const std::vector<MeasurementRow>& rows,
                                   const std::vector<double>& wavelengths_nm,
                                   const measure::Conditions& conditions,
                                   const std::string& filename);

inline constexpr double kMaxFactorFarFromGloss = 2, kMaxFactor = 20, kMinPercent = 0.05;

}  // namespace nacre::io
