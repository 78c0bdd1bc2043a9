#pragma once

#include <array>

#include "nacre/bsdf/bsdf.h"
#include "nacre/spectra/rgb_basis.h"

namespace nacre::bsdf {

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
    FloatLanes operator()(const std::array<float, 3>& rgb) const {
        return max_lanes(rgb[0] * basis_[0] + rgb[1] * basis_[1] + rgb[2] * basis_[2],
                         FloatLanes{});
    }

 private:
    std::array<FloatLanes, 3> basis_;
};

}  // namespace nacre::bsdf
