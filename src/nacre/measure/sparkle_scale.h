#pragma once

#include <optional>
#include <vector>

#include "nacre/measure/eye.h"
#include "nacre/measure/jackknife.h"
#include "nacre/measure/panel_picture.h"

// How much a panel sparkles under a lamp: definitions, sources and limits in docs/sparkle.md.

namespace nacre::measure {

/// The picture on the retina: what the camera saw, blurred by the eye, without the margin into
/// which what lies beyond the picture would be blurred.
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
RetinalPicture retinal_picture(const PanelPicture& picture, const Viewing& viewing);

/// A spot of light that stands out: a local maximum of the retinal picture.
struct Spot {
    int x = 0, y = 0;       ///< pixel of the retinal picture
    double excess = 0;      ///< of Y over the background
    double visibility = 0;  ///< thresholds; 1 and above are seen
};

/// What the eye makes of the panel between its spots.
struct Background {
    double y = 0;          ///< median of the retinal picture
    double threshold = 0;  ///< least excess of Y in the retinal picture that is seen
};

Background background(const RetinalPicture& picture, const Viewing& viewing);
/// The spots that are seen. Two nearer than twice the eye's blur are one.
std::vector<Spot> visible_spots(const RetinalPicture& picture, const Background& background);

struct Sparkle {
    double mean_y = 0;        ///< luminance factor of the panel
    Estimate pixel_contrast;  ///< what the camera saw, without the eye: measure::pixel_contrast()
    Background background;
    double blur_mm = 0;        ///< as in RetinalPicture
    double area_mm2 = 0;       ///< of the panel in which spots are looked for
    Estimate density_per_cm2;  ///< visible spots per area
    /// Geometric mean of their visibility, in thresholds: the eye tells ratios. None: no spots.
    std::optional<Estimate> intensity;
    /// The same as Weber contrast on the retina; none: no spots, or a black background.
    std::optional<Estimate> contrast;
    Estimate area_share;  ///< of the panel that is above threshold on the retina
    /// Sum of log10(visibility) over the spots, per area: density times log10(intensity).
    Estimate sparkle_per_cm2;
};

/// @throws DomainError as check(const Viewing&) and retinal_picture()
Sparkle sparkle(const PanelPicture& picture, const Viewing& viewing = {});

}  // namespace nacre::measure
