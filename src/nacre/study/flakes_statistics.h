#pragma once

#include <array>
#include <vector>

#include "nacre/spectra/observer.h"

// Numbers that say how a picture of flakes looks.

namespace nacre::study {

/// A picture as it comes from a renderer: linear Rec. 709, three values a pixel.
struct Pixels {
    int width = 0, height = 0;
    std::vector<float> rgb;
};

/// Luminance Y by pixel.
std::vector<double> luminance(const Pixels& picture);

struct Measured {
    double value = 0, standard_error = 0;
};

/// Mean luminance. Error: by the jackknife over 16 pieces of the picture, each left out in turn, so
/// that neighbours which share a flake do not count as independent.   [efron-stein-1981]
Measured mean_luminance(const Pixels& a, const Pixels& b);

/// Standard deviation of luminance over its mean, from two pictures of the same flakes with
/// independent noise: the root of their covariance over the product of their means, which noise
/// does not raise. 0 where noise makes the covariance negative. Error as above.
/// @throws DomainError unless both have the same size, at least 4 x 4
Measured contrast(const Pixels& a, const Pixels& b);

/// Share of the pixels by luminance over the mean luminance, in equal steps of its logarithm; the
/// first and the last hold what lies beyond.
struct Histogram {
    std::vector<double> centre;  ///< of the steps, as a ratio
    std::vector<double> share;
};
Histogram histogram(const Pixels& picture);

/// Colours in CIELAB after scaling the picture so that `mean_luminance` becomes 0.3.
struct ColourSpread {
    spectra::Vec3 mean_lab{};                 ///< of the mean colour
    double a_deviation = 0, b_deviation = 0;  ///< over the pixels
    std::vector<std::array<double, 2>> ab;    ///< by pixel
};
ColourSpread colour_spread(const Pixels& picture, double mean_luminance);

}  // namespace nacre::study
