#include "nacre/render/surface_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nacre::render {

std::array<double, 2> octahedral_square(Vec3f n) {
    const double x = std::abs(double{n.x}), y = std::abs(double{n.y}), z = std::abs(double{n.z});
    // Distance from the pole such that areas are kept; of the two equal forms of 1 - z the one that
    // does not cancel.
    const double r = std::sqrt((x * x + y * y) / (1 + z));
    const double turn = x + y > 0 ? std::atan2(y, x) * (2 * std::numbers::inv_pi) : 0;
    double a = r * (1 - turn), b = r * turn;
    if (n.z < 0) {
        const double unfolded = 1 - b;
        b = 1 - a;
        a = unfolded;
    }
    const double u = 0.5 + 0.5 * std::copysign(a, double{n.x});
    const double v = 0.5 + 0.5 * std::copysign(b, double{n.y});
    return {std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0)};  // r may exceed 1 by rounding
}

namespace {

std::array<double, 2> place(Vec3f n) { return octahedral_square({n.x, n.z, -n.y}); }

/// The change of place over an edge centred on n; twice that over its shorter half where the other
/// half crosses a fold of the map.
Vec2f change(Vec3f n, const std::array<double, 2>& here, Vec3f edge) {
    const Vec3f half = 0.5f * edge;
    const auto ahead = place(normalize(n + half)), behind = place(normalize(n - half));
    const auto step = [&](const std::array<double, 2>& to, double scale) {
        return std::array{scale * (to[0] - here[0]), scale * (to[1] - here[1])};
    };
    const auto a = step(ahead, 2), b = step(behind, -2);
    const double size_a = std::hypot(a[0], a[1]), size_b = std::hypot(b[0], b[1]);
    // On either side of a smooth place both agree to first order; a fold sends one of them far off.
    constexpr double kFolded = 4;
    double weight_a = 0.5;
    if (size_a > kFolded * size_b) weight_a = 0;
    if (size_b > kFolded * size_a) weight_a = 1;
    return {static_cast<float>(weight_a * a[0] + (1 - weight_a) * b[0]),
            static_cast<float>(weight_a * a[1] + (1 - weight_a) * b[1])};
}

double fraction(double x) { return x - std::floor(x); }

}  // namespace

bsdf::Patch sphere_patch(Vec3f n, Vec3f edge_1, Vec3f edge_2) {
    const auto here = place(n);
    return {here[0], here[1], change(n, here, edge_1), change(n, here, edge_2)};
}

BarycentricChange::BarycentricChange(const Mesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    side_1_ = mesh.positions_mm[b] - mesh.positions_mm[a];
    side_2_ = mesh.positions_mm[c] - mesh.positions_mm[a];
    d11_ = dot(side_1_, side_1_);
    d12_ = dot(side_1_, side_2_);
    d22_ = dot(side_2_, side_2_);
    determinant_ = d11_ * d22_ - d12_ * d12_;
}

std::array<double, 2> BarycentricChange::along(Vec3f edge_mm) const {
    const double e1 = dot(edge_mm, side_1_), e2 = dot(edge_mm, side_2_);
    return {(d22_ * e1 - d12_ * e2) / determinant_, (d11_ * e2 - d12_ * e1) / determinant_};
}

bsdf::Patch triangle_patch(const Mesh& mesh, std::size_t triangle, Vec2f barycentric,
                           Vec3f edge_1_mm, Vec3f edge_2_mm) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec2f uv_a = mesh.uv[a], uv_b = mesh.uv[b], uv_c = mesh.uv[c];
    const double u1 = double{uv_b.x} - uv_a.x, v1 = double{uv_b.y} - uv_a.y;
    const double u2 = double{uv_c.x} - uv_a.x, v2 = double{uv_c.y} - uv_a.y;
    bsdf::Patch patch;
    patch.u = fraction(uv_a.x + barycentric.x * u1 + barycentric.y * u2);
    patch.v = fraction(uv_a.y + barycentric.x * v1 + barycentric.y * v2);

    const BarycentricChange weights(mesh, triangle);
    if (!weights.exists()) return patch;
    const auto change = [&](Vec3f edge) {
        const auto [w1, w2] = weights.along(edge);
        return Vec2f{static_cast<float>(w1 * u1 + w2 * u2), static_cast<float>(w1 * v1 + w2 * v2)};
    };
    patch.edge_1 = change(edge_1_mm);
    patch.edge_2 = change(edge_2_mm);
    return patch;
}

sparkle::ObjectSpaceFootprint object_space_footprint(const AffineMap& map, Vec3f position_mm,
                                                     Vec3f geometric_normal, Vec3f shading_normal,
                                                     Vec3f edge_1_mm, Vec3f edge_2_mm) {
    // The rotation that takes one normal to the other, applied to what is perpendicular to the
    // first.
    const Vec3f sum = geometric_normal + shading_normal;
    const float scale = 1 / (1 + dot(geometric_normal, shading_normal));
    const auto turned = [&](Vec3f edge) {
        return map.direction_in_object_space(edge - scale * dot(edge, shading_normal) * sum);
    };
    return {map.point_in_object_space_mm(position_mm),
            map.direction_in_object_space(shading_normal),
            map.direction_in_object_space(Frame::around(shading_normal).s),
            {turned(edge_1_mm), turned(edge_2_mm)}};
}

}  // namespace nacre::render
