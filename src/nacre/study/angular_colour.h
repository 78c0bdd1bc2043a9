#pragma once

#include <string>
#include <vector>

#include "nacre/models/spectral_brdf.h"

// The colour of a surface against the angle of view, as a paint maker's instrument sees it.

namespace nacre::study {

struct AngularColour {
    double aspecular_deg;       ///< from the mirror direction towards the normal
    std::array<double, 3> lab;  ///< CIELAB, D65, 2 degree observer; the perfect diffuser is white
    std::string css;            ///< of the same colour on a display, "#rrggbb"
};

/// Lit from 45 deg, seen in the plane of incidence at each aspecular angle, -40 to 130 deg.
/// @param surface  at 400 to 700 nm, in equal steps
std::vector<AngularColour> angular_colours(const models::SpectralBrdf& surface,
                                           const std::vector<double>& aspecular_deg);

}  // namespace nacre::study
