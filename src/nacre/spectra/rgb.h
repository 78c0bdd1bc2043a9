#pragma once

#include "nacre/spectra/observer.h"

// RGB with the primaries of Rec. 709 and the white D65, x = 0.3127, y = 0.3290, as in sRGB.
// XYZ here has Y = 1 at white: divide what reflectance_to_xyz gives by 100.

namespace nacre::spectra {

/// Chromaticities x, y.                                              [iec-61966-2-1-1999]
inline constexpr double kRec709Primaries[3][2] = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
inline constexpr double kRec709White[2] = {0.3127, 0.3290};

/// The matrices follow from the chromaticities above in double precision; those printed in the
/// standard are rounded to four digits and are no inverses of each other. Nothing is clamped:
/// colours outside the gamut have negative components.
Vec3 xyz_to_linear_rec709(const Vec3& xyz);
Vec3 linear_rec709_to_xyz(const Vec3& rgb);

/// Transfer function of sRGB, [0, 1] -> [0, 1], odd for negative values.
/// [iec-61966-2-1-1999]
/// The standard's rounded constants leave a step of 3e-8 where its two branches meet.
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace nacre::spectra
