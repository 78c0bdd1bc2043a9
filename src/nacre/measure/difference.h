#pragma once

#include <map>
#include <string>
#include <vector>

#include "nacre/measure/measurement.h"

namespace nacre::measure {

struct AngleDifference {
    Geometry geometry;
    Vec3d delta_lab{};  ///< sample less standard
    double delta_e_2000 = 0;
    double weight = 1;
    Vec3d lab_standard{}, lab_sample{};  ///< under Difference::conditions

    double delta_chroma() const;  ///< Delta C*, sample less standard
    /// Delta H* = 2 sqrt(C*1 C*2) sin(Delta h / 2), positive for a sample whose hue angle is
    /// greater.                                                           [cie-15-2018]
    double delta_hue() const;
};

/// Colour difference of a sample from a standard, at the geometries that both have (to 0.1 deg).
struct Difference {
    std::vector<AngleDifference> angles;
    double mean_delta_e_2000 = 0;  ///< weighted
    double max_delta_e_2000 = 0;
    Conditions conditions;  ///< of the comparison: the standard's if possible
};

/// Both colours of a pair on a display, "#rrggbb" of encoded sRGB, what is outside its gamut clipped.
struct DisplayPair {
    std::string standard, sample;
    /// By which both were divided, so that the brighter one fits and a difference of brightness shows:
    /// 1 where none is brighter than the display.
    double dimmed = 1;
};
/// Of colours under D65 for the 2 degree observer.
DisplayPair display_pair(const AngleDifference& angle);

/// Where illuminants or observers differ, the sample is converted to those of the standard if it
/// has spectra, else the standard to those of the sample.
///
/// @param weights  by the geometry's name, >= 0; those not named weigh 1
/// @throws DomainError if the two have no geometry in common, their illuminants or observers
///         differ while neither has spectra to be converted, a weight is negative or names
///         no geometry in common, or all weights are 0
Difference difference(const Measurement& standard, const Measurement& sample,
                      const std::map<std::string, double>& weights = {});

}  // namespace nacre::measure
