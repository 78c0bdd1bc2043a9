#pragma once

#include <span>

#include "nacre/spectra/observer.h"
#include "nacre/spectra/spectrum.h"

// Tristimulus values.

namespace nacre::spectra {

/// XYZ of a reflectance sampled at `wavelengths_nm` (at least two, increasing in equal steps), as
/// sums over those samples, normalised so that the perfect diffuser has Y = 100:
///   X = 100 sum S x R / sum S y,  and so on.                          [cie-15-2018]
/// With samples every 10 nm the sums err by at most 0.2 (Delta E 2000, smooth reflectances) under
/// A, D50, D65 and E, but by up to 7.5 under FL2 and FL11, whose lines fall between the samples:
/// there, and whenever the reflectance is known as a function, use the overload for a Spectrum.
/// @throws DomainError if the sizes differ, the wavelengths are not as described, a reflectance is
/// not finite, or no sample lies where the illuminant and the observer respond
Vec3d reflectance_to_xyz(std::span<const double> wavelengths_nm,
                         std::span<const double> reflectance, Illuminant illuminant,
                         Observer observer);

/// XYZ of the perfect diffuser by the same sums: the white point for CIELAB.
/// @throws DomainError as reflectance_to_xyz
Vec3d white_point(std::span<const double> wavelengths_nm, Illuminant illuminant, Observer observer);

/// XYZ of a reflectance by sums at 5 nm over 360-780 nm, between and beyond its samples as the
/// Spectrum continues them: the CIE's prescription for reflectances measured on a coarser or a
/// shorter grid. The perfect diffuser has Y = 100.                  [cie-15-2018]
Vec3d reflectance_to_xyz(const Spectrum& reflectance, Illuminant illuminant, Observer observer);

/// XYZ of the perfect diffuser by the same sums.
Vec3d white_point(Illuminant illuminant, Observer observer);

}  // namespace nacre::spectra
