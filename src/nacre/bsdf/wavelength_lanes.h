#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "nacre/bsdf/bsdf.h"

// Functions that are known at a paint's wavelengths, at the eight that a surface is bound to.

namespace nacre::bsdf {

/// Where a wavelength falls between those of the paint: linear between them, and beyond their ends
/// at the end.
struct Between {
    int lower = 0;
    float fraction = 0;
};

/// @param grid  increasing
inline std::array<Between, kLanes> locate_wavelengths(const std::vector<double>& grid,
                                                      const Wavelengths& wavelengths) {
    std::array<Between, kLanes> out;
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

/// Lanes of a function of the wavelength index.
template <class F>
FloatLanes at_wavelengths(const std::array<Between, kLanes>& where, F&& f) {
    return make_lanes([&](int i) {
        const float a = static_cast<float>(f(where[i].lower));
        if (where[i].fraction == 0) return a;
        return a + where[i].fraction * (static_cast<float>(f(where[i].lower + 1)) - a);
    });
}

}  // namespace nacre::bsdf
