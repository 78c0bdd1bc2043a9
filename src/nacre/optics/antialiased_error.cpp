#include "nacre/optics/antialiased_error.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/spectra/colour.h"

namespace nacre::optics {

AntialiasingComparison compare_antialiasing(const AiryFilm& film, double cosine,
                                            double thickness_nm, const Antialiasing& how) {
    using namespace spectra;
    static const Vec3 white = linear_rec709_to_xyz({1, 1, 1});
    AntialiasingComparison c{antialiased_rgb(film, cosine, thickness_nm, how),
                             integrated_rgb(film, cosine, thickness_nm), 0, 0};
    c.delta_e = delta_e_2000(xyz_to_lab(linear_rec709_to_xyz(c.rgb), white),
                             xyz_to_lab(linear_rec709_to_xyz(c.integrated_rgb), white));
    for (int i = 0; i < 3; ++i) {
        c.rgb_error = std::max(c.rgb_error, std::abs(c.rgb[i] - c.integrated_rgb[i]));
    }
    return c;
}

AntialiasingError antialiasing_error(const AiryFilm& film, std::span<const double> cosines,
                                     std::span<const double> thicknesses_nm,
                                     const Antialiasing& how) {
    if (cosines.empty() || thicknesses_nm.empty()) {
        throw DomainError("the error of antialiasing needs at least one angle and one thickness");
    }
    AntialiasingError error;
    for (const double cosine : cosines) {
        for (const double thickness_nm : thicknesses_nm) {
            const auto c = compare_antialiasing(film, cosine, thickness_nm, how);
            error.mean_delta_e += c.delta_e;
            error.max_delta_e = std::max(error.max_delta_e, c.delta_e);
            error.mean_rgb += c.rgb_error;
            error.max_rgb = std::max(error.max_rgb, c.rgb_error);
        }
    }
    const auto count = static_cast<double>(cosines.size() * thicknesses_nm.size());
    error.mean_delta_e /= count;
    error.mean_rgb /= count;
    return error;
}

}  // namespace nacre::optics
