#include "nacre/io/tone_map.h"

#include <cmath>

#include "nacre/spectra/colour.h"

namespace nacre::io {

double soft_shoulder(double light) {
    if (!(light > 0)) return 0;
    if (light <= kShoulderStart) return light;
    constexpr double kRoom = 1 - kShoulderStart;
    return kShoulderStart - kRoom * std::expm1(-(light - kShoulderStart) / kRoom);
}

unsigned char display_byte(double light, double exposure_scale) {
    const double encoded = spectra::srgb_encode(soft_shoulder(light * exposure_scale));
    return static_cast<unsigned char>(std::lround(255 * encoded));
}

}  // namespace nacre::io
