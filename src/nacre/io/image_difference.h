#pragma once

#include <optional>
#include <string>
#include <vector>

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

// Pictures with standard errors: the channel "stderr.NAME" holds that of the channel NAME, estimated
// from as many independent batches as the metadata tell.

inline constexpr const char* kBatchesKey = "nacre:batches";
/// "stderr.R" of "R".
std::string standard_error_channel(const std::string& name);

/// Differences in standard errors: z = (a - b) / sqrt(e_a^2 + e_b^2), the error of a picture that
/// does not tell it being taken as 0.
struct ImageZScores {
    std::vector<std::string> channels;  ///< that were compared: in both, with an error in either
    bool has_error_a = false, has_error_b = false;
    std::size_t values =
        0;  ///< pixels times channels that have an error above 0 and below infinity
    double mean_square = 0;       ///< of z
    double fraction_above_3 = 0;  ///< of |z|
    /// Where both pictures have the same mean and tell their errors, or one is exact; of Student's t
    /// for the fewest batches of either, of the normal law if their number is not told.
    double expected_mean_square = 1, expected_fraction_above_3 = 0;
    /// The difference summed over all values of the first three of the channels, in its standard
    /// errors; pixels are independent of each other.
    double of_mean = 0;
    /// Values that differ by more than kRounding although neither picture has an error there.
    std::size_t unexplained = 0;

    /// Relative. Where the batches agree to a tenth of it, as on a plain background, there is no noise
    /// to measure by.
    static constexpr double kRounding = 1e-4;
};

/// Empty if neither picture tells standard errors of channels that both have.
/// @throws InputError if sizes differ, or a number of batches is no whole number of at least 2
std::optional<ImageZScores> image_z_scores(const Image& a, const Image& b,
                                           const std::string& name_a, const std::string& name_b);

/// The colour difference of each pixel as a picture for the eye: black where there is none, over
/// red and yellow to white at `full_scale`.
Image difference_heat_map(const ImageDifference& difference, double full_scale);

}  // namespace nacre::io
