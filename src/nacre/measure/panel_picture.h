#pragma once

#include <cstddef>
#include <vector>

#include "nacre/core/estimate.h"

namespace nacre::measure {

/// A picture of a flat panel by a distant camera along its normal: X, Y, Z of each pixel relative
/// to the perfect diffuser under the same light, which has Y = 1 (CIE 1931 observer: luminance is
/// defined by it). Row by row from the top left.
struct PanelPicture {
    int width = 0, height = 0;
    double pixel_mm = 0;     ///< side of a pixel on the panel
    std::vector<float> xyz;  ///< three values a pixel

    std::size_t pixel_count() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    double luminance(std::size_t pixel) const { return xyz[3 * pixel + 1]; }
};

/// Y averaged over the pixels; exactly Y if all are equal.
double mean_luminance(const PanelPicture& picture);

/// Y of each pixel, row by row.
struct LuminancePicture {
    int width = 0, height = 0;
    std::vector<double> y;
};

/// Y averaged over the pixels of both, with its error by the jackknife over pieces.
/// @throws DomainError as pixel_contrast()
Estimate mean_luminance(const LuminancePicture& a, const LuminancePicture& b);

/// Standard deviation of the pixels' Y over its mean, from two pictures of the same panel with
/// independent noise: by their covariance, which independent noise does not bias. One picture,
/// given twice, serves where there is no noise. 0 where noise makes the covariance negative, and
/// for a black panel.
/// @throws DomainError unless both have the same size, at least 4 pixels a side
Estimate pixel_contrast(const LuminancePicture& a, const LuminancePicture& b);
Estimate pixel_contrast(const PanelPicture& a, const PanelPicture& b);

}  // namespace nacre::measure
