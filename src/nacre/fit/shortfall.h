#pragma once

#include <vector>

#include "nacre/measure/difference.h"

// In which respect a colour misses a standard, and at which angles.

namespace nacre::fit {

enum class Attribute { lightness, chroma, hue };

struct Shortfall {
    Attribute attribute = Attribute::lightness;
    /// Its part in the weighted sum of squares of the three attributes' Delta E 2000, [0, 1].
    double fraction = 0;
    struct AtAngle {
        const measure::AngleDifference* angle;  ///< of the difference that was asked about
        /// Sample less standard: of L*, C*, or Delta H* (measure::AngleDifference::delta_hue()).
        double delta = 0;
        double delta_e_2000 = 0;  ///< were this attribute alone different
    };
    std::vector<AtAngle> angles;  ///< where it is 0.5 Delta E or more, the largest first
};

/// Attributes with a fraction of a tenth or more that show at some angle, the largest first. What an
/// attribute does alone is the Delta E 2000 of the standard's colour from the one that differs from
/// it in this attribute as the sample does; of hue, both having the geometric mean of their chromas.
/// @param difference  outlives what is returned
std::vector<Shortfall> shortfalls(const measure::Difference& difference);

}  // namespace nacre::fit
