#pragma once

#include <span>

#include "nacre/optics/antialiased.h"

namespace nacre::optics {

/// How far colours by spectral antialiasing are from integration at 1 nm: differences of CIEDE2000
/// relative to D65, and of the largest component of linear Rec. 709.
struct AntialiasingError {
    double mean_delta_e = 0, max_delta_e = 0;
    double mean_rgb = 0, max_rgb = 0;
};

/// One film, thickness and angle.
struct AntialiasingComparison {
    spectra::Vec3 rgb, integrated_rgb;
    double delta_e, rgb_error;
};
AntialiasingComparison compare_antialiasing(const AiryFilm& film, double cosine,
                                            double thickness_nm, const Antialiasing& how);

/// Over all pairs of thickness and cosine.
/// @throws DomainError if there are none
AntialiasingError antialiasing_error(const AiryFilm& film, std::span<const double> cosines,
                                     std::span<const double> thicknesses_nm,
                                     const Antialiasing& how);

}  // namespace nacre::optics
