#pragma once

#include "nacre/core/vec.h"

namespace nacre::sparkle {

/// The piece of a surface that one look at it takes in, in the millimetres of the shape at rest:
/// before it is turned and moved, so that what lies on the shape turns and moves with it. A
/// parallelogram about a point, tangent to the surface there.
struct RestPatch {
    Vec3f position_mm;
    Vec3f normal{0, 0, 1};   ///< unit; of the frame in which directions are told (shading normal)
    Vec3f tangent{1, 0, 0};  ///< unit; where the x axis of that frame points
    Vec3f edge_mm[2];        ///< perpendicular to the normal; both zero: the point alone
};

}  // namespace nacre::sparkle
