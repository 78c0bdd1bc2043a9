#pragma once

#include <vector>

#include "nacre/io/image.h"

// Whether two estimates of a picture have the same mean, from batches with independent random
// numbers.

namespace nacre::study {

/// Student's two-sample test at each pixel that both pictures light.
struct PictureAgreement {
    int pixels = 0;  ///< tested: those with noise in either
    double mean_square_z =
        0;  ///< 1 for known standard errors, expected_mean_square_z for estimated
    double expected_mean_square_z = 0;  ///< of Student's t with the same number of batches
    double fraction_above_3 = 0;        ///< fraction of the pixels with |z| > 3
    double expected_fraction_above_3 = 0;
    /// Difference of the pictures' mean luminance over that luminance, and its standard error.
    double relative_difference = 0, relative_standard_error = 0;
};

/// @param a, b  batches of the same picture, at least 4 each, as many in both, all of one size
/// @throws DomainError otherwise
PictureAgreement picture_agreement(const std::vector<io::Image>& a,
                                   const std::vector<io::Image>& b);

}  // namespace nacre::study
