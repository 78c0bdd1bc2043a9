#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/render/scene.h"

namespace nacre::render {

/// Triangles with smooth shading normals, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vec3f> positions_mm;
    std::vector<Vec3f> normals;  ///< unit, one per position
    std::vector<Vec2f> uv;       ///< one per position; empty: not laid out over the unit square
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A point of a parametrised surface.
struct SurfacePoint {
    Vec3f position_mm;
    Vec3f normal;
};

/// The grid of (columns + 1) x (rows + 1) points of a surface over the unit square. The front side
/// is that to which d/du x d/dv points.
Mesh mesh_of_surface(int columns, int rows,
                     const std::function<SurfacePoint(double u, double v)>& surface);

/// The mesh of a shape generated in code, in the shape's own coordinates.
Mesh make_mesh(const FlatPanel& panel);
Mesh make_mesh(const CurvedPanel& panel);
Mesh make_mesh(const SpeedShape& shape);
Mesh make_mesh(const Backdrop& backdrop);
Mesh make_mesh(const GroundPlane& plane);
/// @throws InputError naming the file, and why it cannot be used: missing, unreadable, without
///         triangles, or with coordinates that are not finite
Mesh make_mesh(const MeshFile& file);

/// Scale, rotation and translation as in scene.h.
///
/// Object space is that of the shape as it is made, in its true size: scaled, and not yet rotated
/// and translated.
class AffineMap {
 public:
    explicit AffineMap(const Transform& transform);

    Vec3f point(Vec3f p) const { return scale_ * rotate(p) + translation_; }
    Vec3f direction(Vec3f d) const { return rotate(d); }
    float scale() const { return scale_; }

    /// From the world back to object space.
    Vec3f point_in_object_space_mm(Vec3f p) const {
        return direction_in_object_space(p - translation_);
    }
    Vec3f direction_in_object_space(Vec3f d) const {
        return d.x * row_[0] + d.y * row_[1] + d.z * row_[2];  // transposed: rows times d
    }

 private:
    Vec3f rotate(Vec3f p) const { return {dot(row_[0], p), dot(row_[1], p), dot(row_[2], p)}; }

    Vec3f row_[3];
    Vec3f translation_;
    float scale_;
};

void apply(const AffineMap& map, Mesh& mesh);

}  // namespace nacre::render
