#pragma once

#include <optional>
#include <vector>

#include "nacre/core/estimate.h"
#include "nacre/measure/panel_picture.h"
#include "nacre/measure/sparkle_camera.h"

// Published models of the resolution and the thresholds of the eye, and sparkle and graininess as
// multiples of these thresholds.

namespace nacre::measure {

/// The viewing conditions of a panel.
struct Viewing {
    double distance_mm = 500;      ///< from the eye to the panel, [50, 1e5]
    double illuminance_lx = 1000;  ///< on the panel, [1, 2e5]
};

/// Side of the panel that an observer is assumed to see, whatever the field of the camera. Contrast
/// sensitivity depends on it weakly.
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

/// Agreement of contrast_sensitivity() with an independent implementation (colour-science).
inline constexpr double kContrastSensitivityError = 1e-9;

/// Illuminance at the eye, in lx, that a steady point of light must add to be noticed on an even
/// background: C (1 + sqrt(K B))^2, with one pair of constants for scotopic and one for photopic
/// vision.                      [knoll-1946; hecht-1947, eq. 3; schaefer-1990, eq. 2]
/// At the change from one to the other, at 0.005 cd/m^2, the threshold jumps up by 7 %.
double point_threshold_lx(double background_cd_m2);

// Sparkle of a panel under a lamp: definitions, sources and limits in docs/sparkle.md.

/// The picture on the retina: that of the camera, blurred by the eye, without the margin that
/// depends on what lies beyond the picture.
struct RetinalPicture {
    int width = 0, height = 0;
    double pixel_mm = 0;
    std::vector<double> y;  ///< luminance factor, row by row
    double blur_mm = 0;     ///< standard deviation of the eye's blur on the panel
    /// Excess of Y times area, in mm^2, that a point of light needs to raise its own pixel by 1.
    double point_area_mm2 = 0;
};

/// @throws DomainError if the eye's blur is narrower than a pixel or the picture is so small that
///         fewer than 16 pixels a side are left
/// @throws Stopped if `work`, which may be null, asks to stop
RetinalPicture retinal_picture(const PanelPicture& picture, const Viewing& viewing,
                               SharedProgress* work = nullptr);

/// A visible spot of light: a local maximum of the retinal picture.
struct Spot {
    int x = 0, y = 0;       ///< pixel of the retinal picture
    double excess = 0;      ///< of Y over the background
    double visibility = 0;  ///< thresholds; 1 and above are seen
};

/// The panel between its spots.
struct Background {
    double y = 0;          ///< median of the retinal picture
    double threshold = 0;  ///< least excess of Y in the retinal picture that is seen
};

Background background(const RetinalPicture& picture, const Viewing& viewing);
/// The spots that are seen. Two nearer than twice the eye's blur are one.
std::vector<Spot> visible_spots(const RetinalPicture& picture, const Background& background);

struct Sparkle {
    double mean_y = 0;             ///< luminance factor of the panel
    Estimate pixel_contrast = {};  ///< of the camera's picture, without the eye: pixel_contrast()
    Background background = {};
    double blur_mm = 0;             ///< as in RetinalPicture
    double area_mm2 = 0;            ///< of the panel in which spots are looked for
    Estimate density_per_cm2 = {};  ///< visible spots per area
    /// Geometric mean of their visibility, in thresholds: the eye tells ratios. None: no spots.
    std::optional<Estimate> intensity = {};
    /// The same as Weber contrast on the retina; none: no spots, or a black background.
    std::optional<Estimate> contrast = {};
    Estimate area_fraction = {};  ///< of the panel that is above threshold on the retina
    /// Sum of log10(visibility) over the spots, per area: density times log10(intensity).
    Estimate sparkle_per_cm2 = {};
};

/// @throws DomainError as check(const Viewing&) and retinal_picture(); Stopped as the latter
Sparkle sparkle(const PanelPicture& picture, const Viewing& viewing = {},
                SharedProgress* work = nullptr);

// Graininess of a panel in diffuse light: definition, sources and limits in docs/sparkle.md.

struct Graininess {
    double mean_y = 0;        ///< luminance factor of the panel
    Estimate graininess;      ///< in thresholds: 1 is a sinusoidal grating that is just noticed
    Estimate pixel_contrast;  ///< of the pictures, without the eye: pixel_contrast()
};

/// The contrast of a picture, frequency by frequency, weighted with the eye's contrast sensitivity
/// S [barten-1999, chapter 3]:
///   G^2 = 2  Int S(|u|)^2 P(u) d^2u,     P: power spectrum of Y / mean - 1.
/// A sinusoidal grating of modulation m has G = m S(u): 1 at the threshold.
///
/// From two pictures of the same flakes with independent noise: P is their cross spectrum, which
/// independent noise does not bias. Where a side has prime factors above 7, rows or columns are
/// left out down to the next length without. 0 where noise makes the sum negative, and for a black
/// picture.
/// @throws DomainError unless both have the same size, at least 16 pixels a side; as check()
/// @throws Stopped if `work`, which may be null, asks to stop
Graininess graininess(const PanelPicture& a, const PanelPicture& b, const Viewing& viewing = {},
                      SharedProgress* work = nullptr);

/// Sparkle and graininess of a panel.
struct SparkleMeasurement {
    std::vector<double> lamps_deg;
    std::vector<Sparkle> by_lamp;
    std::optional<Graininess> diffuse = {};  ///< none: no picture in diffuse light was taken
};

/// Evaluates the pictures of take_pictures().
/// @throws DomainError as sparkle() and graininess(); Stopped if `progress` asks to stop
SparkleMeasurement measure_pictures(const SparkleCamera& camera, const PanelPictures& pictures,
                                    const Viewing& viewing = {}, const Progress& progress = {});

}  // namespace nacre::measure
