#pragma once

#include <cmath>

#include "nacre/core/angles.h"
#include "nacre/core/vec.h"

namespace nacre {

/// The unit vector of a polar angle from z and an azimuth about it from x.
inline Vec3d polar_direction(double theta_deg, double phi_deg) {
    const double sine = std::sin(theta_deg * kDegree);
    return {sine * std::cos(phi_deg * kDegree), sine * std::sin(phi_deg * kDegree),
            std::cos(theta_deg * kDegree)};
}

}  // namespace nacre
