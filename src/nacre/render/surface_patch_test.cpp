#include "nacre/render/surface_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/render/ray_differential.h"

namespace nacre::render {
namespace {

double area(const bsdf::Patch& p) {
    return std::abs(double{p.edge_1.x} * p.edge_2.y - double{p.edge_1.y} * p.edge_2.x);
}

TEST(SurfacePatch, KeepsTheShareOfASpheresArea) {
    // Also on the folds of the map and at the pole behind: 4 pi of area to 1 of the square, to
    // first order in the edges.
    constexpr float kEdge = 1e-3f;
    int checked = 0;
    for (int i = 0; i < 40; ++i) {
        for (int j = 1; j < 40; ++j) {
            const float theta = j * std::numbers::pi_v<float> / 40;
            const float phi = i * std::numbers::pi_v<float> / 20 + 0.003f;
            const Vec3f n{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                          std::cos(theta)};
            const Frame frame = Frame::around(n);
            const double share =
                area(sphere_patch(n, kEdge * frame.s, kEdge * frame.t)) * 4 * std::numbers::pi;
            EXPECT_NEAR(share / (kEdge * kEdge), 1, 0.02) << theta << ' ' << phi;
            ++checked;
        }
    }
    EXPECT_EQ(checked, 1560);
}

TEST(SurfacePatch, IsLinearOnATriangle) {
    const Mesh mesh = make_mesh(FlatPanel{.width_mm = 200, .height_mm = 50});
    const bsdf::Patch patch = triangle_patch(mesh, 0, {0.25f, 0.5f}, {2, 0, 0}, {0, 1, 0});
    // The first triangle's corners are (0, 0), (1, 0), (1, 1) of the square.
    EXPECT_NEAR(patch.u, 0.75, 1e-6);
    EXPECT_NEAR(patch.v, 0.5, 1e-6);
    EXPECT_NEAR(patch.edge_1.x, 0.01, 1e-8);
    EXPECT_NEAR(patch.edge_1.y, 0, 1e-8);
    EXPECT_NEAR(patch.edge_2.x, 0, 1e-8);
    EXPECT_NEAR(patch.edge_2.y, 0.02, 1e-8);
}

TEST(RayDifferential, FootprintOnAPlaneIsWhereTheNeighbouringRaysHit) {
    const Vec3f to_x{0.01f, 0, 0}, direction = normalize({0, 0.6f, -0.8f});
    const RayDifferential d{{}, {to_x, 0.01f * normalize({0, 0.8f, 0.6f})}};
    const auto edges = d.at(direction, 100, {0, 0, 1});
    EXPECT_NEAR(edges.edge_mm[0].x, 1, 1e-5);
    EXPECT_NEAR(edges.edge_mm[0].y, 0, 1e-5);
    EXPECT_NEAR(edges.edge_mm[1].y, 1 / 0.8, 1e-5);  // stretched by 1 / cos(theta)
    EXPECT_NEAR(edges.edge_mm[1].z, 0, 1e-5);
}

TEST(RayDifferential, AFlatMirrorIsAWindow) {
    // By way of a mirror in z = 0 to a plane at z = 50 is as far as straight on to z = -50.
    const Vec3f direction = normalize({0.3f, 0.6f, -0.8f});
    const RayDifferential d{{}, {{0.01f, 0, 0}, {0, 0.01f, 0}}};
    const float to_mirror = -30 / direction.z, onward = -50 / direction.z;
    const auto on_mirror = d.at(direction, to_mirror, {0, 0, 1});
    const Vec3f reflected{direction.x, direction.y, -direction.z};
    const auto through = d.mirrored(on_mirror, {0, 0, 1}).at(reflected, onward, {0, 0, -1});
    const auto straight = d.at(direction, to_mirror + onward, {0, 0, 1});
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(length(through.edge_mm[i] - straight.edge_mm[i]), 0, 1e-5);
    }
}

}  // namespace
}  // namespace nacre::render
