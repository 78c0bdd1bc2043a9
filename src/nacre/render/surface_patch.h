#pragma once

#include <array>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/vec.h"
#include "nacre/render/mesh.h"

namespace nacre::render {

/// The unit sphere onto the unit square, equal areas to equal areas, continuous: the half about +z
/// fills the diamond in the middle, the other half is folded out into the corners, its pole at all
/// four of them.                                                          [clarberg-2008, sec. 3]
///
/// @param n  a unit vector
/// @return   (u, v) in [0, 1]
std::array<double, 2> octahedral_square(Vec3f n);

/// How the weights of the second and third corner of a triangle in space change along an edge: by
/// least squares on the two sides of the triangle. None where it is degenerate.
class BarycentricChange {
 public:
    BarycentricChange(const Mesh& mesh, std::size_t triangle);
    bool exists() const { return determinant_ > 0; }
    /// @param edge_mm  in the plane of the triangle
    std::array<double, 2> along(Vec3f edge_mm) const;

 private:
    Vec3f side_1_, side_2_;
    double d11_, d12_, d22_, determinant_;
};

// Where a point of a shape, and a small parallelogram about it, lie in the unit square over which
// the shape is laid out or in the shape's object space.

/// On a sphere of radius 1, by octahedral_square() with its pole towards -y, where cameras stand.
///
/// @param n            the point, a unit vector
/// @param edge_1, edge_2  of the parallelogram, tangent to the sphere there, in radii
bsdf::Patch sphere_patch(Vec3f n, Vec3f edge_1, Vec3f edge_2);

/// On a triangle of a mesh that has coordinates (uv), linearly. Coordinates repeat with period 1.
///
/// @param barycentric  weights of the second and third corner
/// @param edge_1_mm, edge_2_mm  in the plane of the triangle
/// @return  a patch without edges where the triangle is degenerate
bsdf::Patch triangle_patch(const Mesh& mesh, std::size_t triangle, Vec2f barycentric,
                           Vec3f edge_1_mm, Vec3f edge_2_mm);

/// A piece of a surface in object space, from the world.
///
/// A surface is evaluated in the frame of its shading normal, which on a mesh is not that of the
/// facet on which the parallelogram lies. The parallelogram is turned from one to the other
/// the shortest way and so keeps its area, that of the true surface: seen along either normal
/// instead, it would shrink or grow by the cosine between them, and with it the number of flakes.
///
/// @param position_mm       in the world, like all that follows
/// @param geometric_normal, shading_normal  unit vectors, not opposite
/// @param edge_1_mm, edge_2_mm  perpendicular to the geometric normal
sparkle::ObjectSpaceFootprint object_space_footprint(const AffineMap& map, Vec3f position_mm,
                                                     Vec3f geometric_normal, Vec3f shading_normal,
                                                     Vec3f edge_1_mm, Vec3f edge_2_mm);

}  // namespace nacre::render
