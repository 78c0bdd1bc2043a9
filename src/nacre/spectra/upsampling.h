#pragma once

#include "nacre/spectra/observer.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::spectra {

/// A smooth reflectance in [0, 1] whose colour under D65 for the 2 degree observer is the given
/// linear Rec. 709, relative to the white of that illuminant. Of all such reflectances it is the
/// one whose image under artanh(2 rho - 1) changes least from sample to sample (least slope
/// squared): samples every 10 nm from 360 to 780 nm. Greys, black and white included, give a
/// constant.                                                     [burns-2020, method LHTSS]
///
/// Error of the colour: kUpsamplingError in each component, by the sums over 360-780 nm at 5 nm,
/// everywhere in the cube; Delta E 2000 below 0.25 by sums over 400-700 nm at 10 nm. Takes some
/// 0.02 ms.
/// @throws DomainError if a component is outside [0, 1]
Spectrum reflectance_from_rec709(const Vec3d& linear_rgb);

inline constexpr double kUpsamplingError = 1e-10;

}  // namespace nacre::spectra
