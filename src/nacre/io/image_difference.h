#pragma once

#include "nacre/io/image.h"

namespace nacre::io {

/// How much picture A differs from a reference B, over R, G and B in linear light. Colour
/// differences are taken between CIELAB values under D65, the perfect diffuser being white.
struct ImageDifference {
    double mean_square_error = 0;
    /// 10 log10(1 / mean square error): the peak is the perfect diffuser. Infinite if equal.
    double psnr_db = 0;
    /// Mean of |a - b| / (|b| + kDarkest): relative in the light, absolute in the dark.
    double relative_error = 0;
    double delta_e_mean = 0, delta_e_95th = 0, delta_e_max = 0;  ///< CIEDE2000 [sharma-2005]

    /// R, G, B: A - B, signed; deltaE2000: the colour difference of each pixel.
    Image picture;

    static constexpr double kDarkest = 0.01;
};

/// @param name_a, name_b  for messages
/// @throws InputError if sizes differ, colours are missing or a value is not finite
ImageDifference image_difference(const Image& a, const Image& b, const std::string& name_a,
                                 const std::string& name_b);

/// The colour difference of each pixel as a picture for the eye: black where there is none, over
/// red and yellow to white at `full_scale`.
Image difference_heat_map(const ImageDifference& difference, double full_scale);

}  // namespace nacre::io
