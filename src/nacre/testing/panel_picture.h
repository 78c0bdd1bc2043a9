#pragma once

#include <cmath>
#include <numbers>

#include "nacre/core/random.h"
#include "nacre/measure/panel_picture.h"

// Only for tests: pictures with given pixels.

namespace nacre::measure {

inline PanelPicture uniform_picture(int side, double pixel_mm, double y) {
    PanelPicture picture{side, side, pixel_mm, {}};
    picture.xyz.assign(3 * picture.pixel_count(), static_cast<float>(y));
    return picture;
}

inline void set_y(PanelPicture& picture, int x, int y, double value) {
    picture.xyz[3 * (static_cast<std::size_t>(y) * picture.width + x) + 1] =
        static_cast<float>(value);
}
inline void add_y(PanelPicture& picture, int x, int y, double value) {
    picture.xyz[3 * (static_cast<std::size_t>(y) * picture.width + x) + 1] +=
        static_cast<float>(value);
}

/// Of mean 0 and variance 1.                                        [box-muller-1958]
inline double normal(Rng& rng) {
    const double u = rng.uniform_double(), v = rng.uniform_double();
    return std::sqrt(-2 * std::log1p(-u)) * std::cos(2 * std::numbers::pi * v);
}

}  // namespace nacre::measure
