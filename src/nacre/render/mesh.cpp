#include "nacre/render/mesh.h"

#include <cmath>
#include <numbers>

namespace nacre::render {

Mesh mesh_of_surface(int columns, int rows,
                     const std::function<SurfacePoint(double u, double v)>& surface) {
    Mesh mesh;
    mesh.positions_mm.reserve(static_cast<std::size_t>(columns + 1) * (rows + 1));
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c) {
            const double u = static_cast<double>(c) / columns;
            const double v = static_cast<double>(r) / rows;
            const SurfacePoint p = surface(u, v);
            mesh.positions_mm.push_back(p.position_mm);
            mesh.normals.push_back(p.normal);
            mesh.uv.push_back({static_cast<float>(u), static_cast<float>(v)});
        }
    }
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t r = 0; r < static_cast<std::uint32_t>(rows); ++r) {
        for (std::uint32_t c = 0; c < static_cast<std::uint32_t>(columns); ++c) {
            const std::uint32_t i = r * stride + c;
            mesh.triangles.push_back({i, i + 1, i + stride + 1});
            mesh.triangles.push_back({i, i + stride + 1, i + stride});
        }
    }
    return mesh;
}

AffineMap::AffineMap(const Transform& transform)
    : translation_(transform.translation_mm), scale_(static_cast<float>(transform.scale)) {
    constexpr double kDegree = std::numbers::pi / 180;
    const double cx = std::cos(transform.rotation_deg.x * kDegree);
    const double sx = std::sin(transform.rotation_deg.x * kDegree);
    const double cy = std::cos(transform.rotation_deg.y * kDegree);
    const double sy = std::sin(transform.rotation_deg.y * kDegree);
    const double cz = std::cos(transform.rotation_deg.z * kDegree);
    const double sz = std::sin(transform.rotation_deg.z * kDegree);
    const auto vec = [](double x, double y, double z) {
        return Vec3f{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    };
    // R = Rz Ry Rx: x turns first.
    row_[0] = vec(cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx);
    row_[1] = vec(sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx);
    row_[2] = vec(-sy, cy * sx, cy * cx);
}

void apply(const AffineMap& map, Mesh& mesh) {
    for (Vec3f& p : mesh.positions_mm) p = map.point(p);
    for (Vec3f& n : mesh.normals) n = map.direction(n);
}

}  // namespace nacre::render
