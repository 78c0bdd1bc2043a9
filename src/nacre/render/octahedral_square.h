#pragma once

#include <array>

#include "nacre/core/vec.h"

namespace nacre::render {

/// The unit sphere onto the unit square, equal areas to equal areas, continuous: the half about +z
/// fills the diamond in the middle, the other half is folded out into the corners, its pole at all
/// four of them.                                                          [clarberg-2008, sec. 3]
///
/// @param n  a unit vector
/// @return   (u, v) in [0, 1]
std::array<double, 2> octahedral_square(Vec3f n);

}  // namespace nacre::render
