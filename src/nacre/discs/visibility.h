#pragma once

#include <cstdint>

#include "nacre/core/vec.h"
#include "nacre/discs/disc_scene.h"

namespace nacre::discs {

/// How much of a flake is lit and seen: v, the share of its area from which straight ways lead both
/// to the light and to the eye past all other flakes, and its moments over the flakes of a tile.
struct Visibility {
    double lit = 0;             ///< mean share that is lit
    double lit_and_seen = 0;    ///< E[v]
    double mean_square = 0;     ///< E[v^2], which makes the contrast of flakes seen whole
    double standard_error = 0;  ///< of lit_and_seen
};

/// Estimated from two random points on each flake, whose v's have E[v^2] as their mean product.
///
/// @param towards_light, towards_eye  unit vectors inside the paint, z > 0
Visibility flake_visibility(const DiscScene& scene, Vec3f towards_light, Vec3f towards_eye,
                            std::uint64_t seed);

}  // namespace nacre::discs
