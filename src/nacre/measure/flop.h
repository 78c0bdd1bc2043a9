#pragma once

#include <optional>
#include <vector>

#include "nacre/measure/measurement.h"

// How much a paint changes with the angle, in one number or two.

namespace nacre::measure {

/// 2.69 (L*15 - L*110)^1.11 / (L*45)^0.86, lit from 45 deg: 0 for a solid colour, some 15 to 20 for
/// a strong metallic.                                      [alman-1987, by way of docs/measure.md]
/// Empty if one of the three angles was not read, or the formula has no value (L*15 < L*110, or
/// L*45 = 0).
std::optional<double> flop_index(const Measurement& measurement);

/// The path that a paint takes through a* and b* as the view leaves the mirror direction.
struct ColourTravel {
    std::vector<const Reading*>
        path;           ///< readings in the plane lit from one angle, by aspecular angle
    double length = 0;  ///< sum of the steps in a*b*
};

/// @param theta_i_deg  the lamp; readings lit from elsewhere, or off the plane, are left out
ColourTravel colour_travel(const Measurement& measurement, double theta_i_deg = 45);

}  // namespace nacre::measure
