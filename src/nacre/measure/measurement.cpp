#include "nacre/measure/measurement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::measure {

double chroma(const spectra::Vec3& lab) { return std::hypot(lab[1], lab[2]); }

double hue_deg(const spectra::Vec3& lab) {
    const double degrees = std::atan2(lab[2], lab[1]) * 180 / std::numbers::pi;
    return degrees < 0 ? degrees + 360 : degrees;
}

}  // namespace nacre::measure
