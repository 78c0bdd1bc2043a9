#pragma once

// What the eye resolves, and what it needs to notice something: published models of vision, so that
// sparkle and graininess can be stated in thresholds of seeing.

namespace nacre::measure {

/// How a panel is looked at.
struct Viewing {
    double distance_mm = 500;      ///< from the eye to the panel, [50, 1e5]
    double illuminance_lx = 1000;  ///< on the panel, [1, 2e5]
};

/// Side of the panel that an observer is taken to look at: what contrast sensitivity depends on
/// weakly, however small the piece that a camera has looked at.
inline constexpr double kPanelSide_mm = 100;

/// @throws DomainError naming the number and its range
void check(const Viewing& viewing);

/// Luminance in cd/m^2 of a surface with the luminance factor `y` (1: the perfect diffuser).
double luminance_cd_m2(const Viewing& viewing, double y);
/// Millimetres of the panel under a degree of visual angle.
double mm_per_degree(const Viewing& viewing);

/// Natural pupil that has adapted to a square field.              [barten-1999, chapter 3]
/// @param luminance_cd_m2  >= 0
/// @param field_deg        side of the field
double pupil_diameter_mm(double luminance_cd_m2, double field_deg);

/// Standard deviation of the eye's line spread, taken as Gaussian: optics, stray light in the
/// retina and the discrete receptors together.                     [barten-1999, chapter 3]
double eye_blur_deg(double pupil_mm);

/// Contrast sensitivity of the average observer with both eyes, in photopic light: the reciprocal
/// of the modulation (L_max - L_min)/(L_max + L_min) at which a sinusoidal grating is noticed half
/// of the times.                                                   [barten-1999, chapter 3]
/// 0 at a frequency or a luminance of 0.
/// @param cycles_per_deg   spatial frequency, >= 0
/// @param field_deg        side of the square over which the grating extends
double contrast_sensitivity(double cycles_per_deg, double luminance_cd_m2, double field_deg);

/// Agreement of contrast_sensitivity() with an independent implementation (eye_test.cpp).
inline constexpr double kContrastSensitivityError = 1e-9;

/// Illuminance at the eye, in lx, that a steady point of light must add to be noticed on an even
/// background: C (1 + sqrt(K B))^2, with one pair of constants for vision by the rods and one for
/// vision by the cones.         [knoll-1946; hecht-1947, eq. 3; schaefer-1990, eq. 2]
/// Where the one takes over from the other, at 0.005 cd/m^2, the threshold rises by 7 % at once.
double point_threshold_lx(double background_cd_m2);

}  // namespace nacre::measure
