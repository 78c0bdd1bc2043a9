#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/spectra/observer.h"
#include "nacre/spectra/rgb.h"

// Functions tabulated at a paint's wavelengths, interpolated at the eight that a surface is bound
// to.

namespace nacre::bsdf {

/// Where a wavelength falls between those of the paint: linear between them, and beyond their ends
/// at the end.
struct WavelengthPosition {
    int lower = 0;
    float fraction = 0;
};

/// @param grid  increasing
inline std::array<WavelengthPosition, kLanes> locate_wavelengths(const std::vector<double>& grid,
                                                                 const Wavelengths& wavelengths) {
    std::array<WavelengthPosition, kLanes> out;
    for (int i = 0; i < kLanes; ++i) {
        const auto above = std::upper_bound(grid.begin(), grid.end(), wavelengths[i]);
        if (above == grid.begin()) continue;
        const int lower = static_cast<int>(above - grid.begin()) - 1;
        out[i].lower = lower;
        if (above != grid.end()) {
            out[i].fraction =
                static_cast<float>((wavelengths[i] - grid[lower]) / (*above - grid[lower]));
        }
    }
    return out;
}

/// The eight of a block of the paint's own wavelengths, the last one repeated.
inline std::array<WavelengthPosition, kLanes> wavelengths_of_block(int count, int block) {
    std::array<WavelengthPosition, kLanes> out;
    for (int i = 0; i < kLanes; ++i) out[i].lower = std::min(block * kLanes + i, count - 1);
    return out;
}

/// Lanes of a function of the wavelength index.
template <class F>
FloatLanes at_wavelengths(const std::array<WavelengthPosition, kLanes>& where, F&& f) {
    return make_lanes([&](int i) {
        const float a = static_cast<float>(f(where[i].lower));
        if (where[i].fraction == 0) return a;
        return a + where[i].fraction * (static_cast<float>(f(where[i].lower + 1)) - a);
    });
}

/// Weights, 1 in all, of what is seen at eight wavelengths: where samples should go. All three responses
/// of the eye, as noise in blue is seen too.
inline FloatLanes response_of_eye(const Wavelengths& wavelengths_nm) {
    const FloatLanes response = make_lanes([&](int lane) {
        const Vec3d xyz =
            spectra::colour_matching(spectra::Observer::cie1931_2deg, wavelengths_nm[lane]);
        return static_cast<float>(xyz.x + xyz.y + xyz.z) + 1e-6f;
    });
    return response * (1 / lane_sum(response));
}

/// Linear Rec. 709 as spectra at the eight wavelengths that a surface is bound to, by
/// spectra::linear_rec709_basis(); what the basis makes negative (colours outside the gamut) is cut
/// off at zero.
class RgbLanes {
 public:
    explicit RgbLanes(const Wavelengths& wavelengths_nm) {
        for (int j = 0; j < 3; ++j) {
            basis_[j] = make_lanes([&](int lane) {
                return static_cast<float>(spectra::linear_rec709_basis()[j](wavelengths_nm[lane]));
            });
        }
    }
    FloatLanes operator()(spectra::Rgb rgb) const {
        return max_lanes(rgb[0] * basis_[0] + rgb[1] * basis_[1] + rgb[2] * basis_[2],
                         FloatLanes{});
    }

 private:
    std::array<FloatLanes, 3> basis_;
};

}  // namespace nacre::bsdf
