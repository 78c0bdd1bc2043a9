#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/render/mesh.h"

namespace nacre::render {

/// Normals for meshes that have none: at each corner of a triangle the mean over the triangles that meet
/// in its position, weighted by their angles there [thurmer-1998], of those whose planes lie within the
/// crease angle of its own. Where more than 1024 meet, of all: the time goes with the square of that.
///
/// Positions are the same where they are equal to the last digit, as in a file that says a vertex once or
/// writes it anew for each triangle.
///
/// @param corners  positions of triangles, three each, counter-clockwise seen from outside
/// @return one a corner, of length 1; {0, 0, 1} where a triangle without area meets no other
std::vector<Vec3f> smooth_normals(std::span<const Vec3f> corners, double crease_angle_deg);

/// Makes one vertex of those that are equal to the last digit, in the order in which they are met.
void join_equal_vertices(Mesh& mesh);

}  // namespace nacre::render
