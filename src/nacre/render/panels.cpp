#include <cmath>
#include <numbers>

#include "nacre/render/mesh.h"

namespace nacre::render {
namespace {

constexpr double kPi = std::numbers::pi;

Vec3f vec(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

Mesh rectangle(double width_mm, double height_mm) {
    return mesh_of_surface(1, 1, [&](double u, double v) {
        return SurfacePoint{vec((u - 0.5) * width_mm, (v - 0.5) * height_mm, 0), {0, 0, 1}};
    });
}

}  // namespace

Mesh make_mesh(const FlatPanel& panel) { return rectangle(panel.width_mm, panel.height_mm); }

Mesh make_mesh(const GroundPlane& plane) { return rectangle(plane.size_mm, plane.size_mm); }

Mesh make_mesh(const CurvedPanel& panel) {
    // 256 facets round the bend: their chords lie within 1e-4 of the radius at a half turn.
    return mesh_of_surface(256, 1, [&](double u, double v) {
        const double r = panel.bend_radius_mm;
        const double angle = (u - 0.5) * panel.width_mm / r;
        return SurfacePoint{
            vec(r * std::sin(angle), (v - 0.5) * panel.height_mm, r * (std::cos(angle) - 1)),
            vec(std::sin(angle), 0, std::cos(angle))};
    });
}

Mesh make_mesh(const Backdrop& backdrop) {
    // The profile in the yz plane: floor, quarter circle, wall, each in its own rows so that the
    // straight parts stay exactly flat.
    const double r = backdrop.fillet_radius_mm;
    constexpr int kFilletRows = 64;
    constexpr int kRows = kFilletRows + 2;
    return mesh_of_surface(1, kRows, [&](double u, double v) {
        const double x = (u - 0.5) * backdrop.width_mm;
        const int row = static_cast<int>(std::lround(v * kRows));
        if (row == 0) return SurfacePoint{vec(x, -backdrop.depth_mm, 0), {0, 0, 1}};
        if (row == kRows) {
            return SurfacePoint{vec(x, backdrop.depth_mm, backdrop.height_mm), {0, -1, 0}};
        }
        const double angle = 0.5 * kPi * (row - 1) / kFilletRows;
        return SurfacePoint{
            vec(x, backdrop.depth_mm - r + r * std::sin(angle), r - r * std::cos(angle)),
            vec(0, -std::sin(angle), std::cos(angle))};
    });
}

}  // namespace nacre::render
