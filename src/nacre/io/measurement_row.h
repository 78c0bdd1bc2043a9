#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/core/range.h"
#include "nacre/measure/measurement.h"

// What CSV and JSON have in common: one reading as a file states it, which may be more or less than
// is needed. Internal to this folder.

namespace nacre::io {

inline constexpr std::size_t kMostMeasuredWavelengths = 2000;
inline constexpr Range kMeasuredReflectance{-1, 1e9};
inline constexpr Range kMeasuredColour{-1e6, 1e6};  // L*, a*, b*
inline constexpr Range kMeasuredTristimulus{-1e15, 1e15};
inline constexpr Range kMeasuredAngle{-360, 360, "deg"};
inline constexpr Range kMeasuredWavelength{100, 10000, "nm"};

struct MeasurementRow {
    std::string place;  ///< "file.csv:3:1: ", for messages
    std::string name;   ///< of the geometry; empty: not stated
    std::optional<double> theta_i_deg, aspecular_deg, theta_o_deg, phi_deg;
    std::vector<double> reflectance_factor;
    std::optional<spectra::Vec3> xyz, lab;
};

/// Completes rows to a measurement.
/// @throws InputError as parse_measurement()
measure::Measurement assemble_measurement(std::string name, const measure::Conditions& conditions,
                                          std::vector<double> wavelengths_nm,
                                          const std::vector<MeasurementRow>& rows);

}  // namespace nacre::io
