#pragma once

#include "nacre/spectra/observer.h"

namespace nacre::spectra {

/// CIE 1976 L* a* b* of a colour, relative to the white under the same light; XYZ and white may
/// have any common scale. The linear part near black continues to negative values.
/// [cie-15-2018]
/// @throws DomainError unless every component of the white is positive
Vec3 xyz_to_lab(const Vec3& xyz, const Vec3& white);

/// The inverse, in the scale of the white.
/// @throws DomainError unless every component of the white is positive
Vec3 lab_to_xyz(const Vec3& lab, const Vec3& white);

}  // namespace nacre::spectra
