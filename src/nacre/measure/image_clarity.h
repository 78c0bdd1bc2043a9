#pragma once

// How sharp the mirror image in a coat with orange peel is, as the mean over many of its waves.

namespace nacre::measure {

/// Contrast (brightest - darkest) / (brightest + darkest) of the mirror image of a far grille of dark
/// and bright bars, equally wide, that lie across the plane of incidence; 1 in a flat coat.
///
/// The image is averaged over an area of many waves, as by an instrument with a wide beam or an eye too
/// far away to see them. A facet of slope s turns the mirrored ray by 2 s in the plane of incidence,
/// at any angle, and slopes are normal: the grille is blurred by a normal law of deviation 2 sigma.
///
/// Derived here from the law of reflection; a definition of this project, on no scale of the trade, whose
/// instruments have slits and combs. Slopes are normal as those of a sum of many waves are [rice-1945];
/// of higher order in the slope, s^2, nothing is kept, nor diffraction. Two series for the
/// same, each where it converges: the error is that of rounding.
///
/// @param slope       root mean square along a line (paint::OrangePeel::slope), >= 0; facets of Beckmann
///                    roughness alpha have alpha / sqrt(2), and squares of both add up
/// @param period_deg  of the grille, a bright and a dark bar, as the coat's place sees it; > 0
double grille_contrast(double slope, double period_deg);

/// The period of the grille of which half of the contrast is left: the image clarity of the coat, small
/// where it mirrors sharply; 0 for a flat one. 4 pi sigma / sqrt(2 ln(8 / pi)), 1.05 deg for a slope of
/// 0.002, to a relative 1e-3.
double half_contrast_period_deg(double slope);

}  // namespace nacre::measure
