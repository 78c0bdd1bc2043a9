#pragma once

#include "nacre/render/environment.h"

namespace nacre::render {

/// Angular radius of the sun seen from the earth (mean).
inline constexpr double kSunRadiusDeg = 0.2666;

/// The clear-to-hazy sky of Preetham et al., as radiance in units of 10 000 cd/m^2 times scale,
/// with the sun as a disk. Valid for turbidity 1.7 to 10; the fit is at its best from 2 to 6, and
/// near the horizon opposite the sun it is known to be too dark.
///   - luminance and chromaticity: Perez formula          [preetham-1999, eq. 3-4, appendix A.2]
///   - spectrum: phase of daylight of that chromaticity    [preetham-1999, appendix A.5]
///   - sun: black body of 5778 K, 1.88e9 cd/m^2 outside the atmosphere, attenuated by Rayleigh
///     and aerosol scattering                              [preetham-1999, appendix A.1]; ozone
///     and water, a few percent, are neglected
///   - ground: Lambertian, reflectance 0.2, under that sky and sun
CompiledEnvironment compile_sky(const SkyEnvironment& sky, EmissionBasis& basis);

}  // namespace nacre::render
