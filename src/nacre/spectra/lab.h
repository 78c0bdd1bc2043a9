#pragma once

#include "nacre/spectra/observer.h"

namespace nacre::spectra {

/// CIE 1976 L* a* b* of a colour, relative to the white under the same light; XYZ and white may
/// have any common scale. The linear part near black continues to negative values.
/// [cie-15-2018]
/// @throws DomainError unless every component of the white is positive
Vec3d xyz_to_lab(const Vec3d& xyz, const Vec3d& white);

/// The inverse, in the scale of the white.
/// @throws DomainError unless every component of the white is positive
Vec3d lab_to_xyz(const Vec3d& lab, const Vec3d& white);

/// The same of linear Rec. 709 (spectra/rgb.h), relative to its own white: what pictures and displays
/// show.
Vec3d linear_rec709_to_lab(const Vec3d& rgb);
Vec3d lab_to_linear_rec709(const Vec3d& lab);

/// CIEDE2000 difference of two CIELAB colours with kL = kC = kH = 1; about 1 is just noticeable.
/// Symmetric in its arguments.                                        [sharma-2005, eq. 2-22]
double delta_e_2000(const Vec3d& lab1, const Vec3d& lab2);

/// CMC(l:c) difference of a sample from a standard, which is not symmetric: the standard sets the
/// weights. 2:1 is usual for what people accept, 1:1 for what they perceive.
/// [clarke-1984, as BS 6923:1988 has it]
/// @throws DomainError unless l and c are positive
double delta_e_cmc(const Vec3d& standard, const Vec3d& sample, double l = 2, double c = 1);

/// A vector whose length is delta_e_2000(lab1, lab2), for least squares: the weighted differences
/// of lightness, then along a* and b*, from the first colour to the second. It has no corner where
/// a colour passes grey, unlike chroma and hue, the formula's own coordinates. Where hues are
/// opposite it jumps, as the formula does.
/// [sharma-2005, eq. 22], its cross term R_T removed by completing the square, and the pair of
/// chroma and hue rotated by the angle from (dC', dH') to (da', db'), which keeps the length.
Vec3d delta_e_2000_vector(const Vec3d& lab1, const Vec3d& lab2);

}  // namespace nacre::spectra
