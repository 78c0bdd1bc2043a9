#include "nacre/render/surface_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/random.h"
#include "nacre/render/camera.h"

namespace nacre::render {
namespace {

Vec3f uniform_direction(Rng& rng) {
    const float z = 1 - 2 * rng.uniform_float();
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
    return {r * std::cos(phi), r * std::sin(phi), z};
}

TEST(OctahedralSquare, EqualAreasFillEqualAreas) {
    // Chi-square over 64 cells of 64 000 directions: the 99.9 % quantile for 63 degrees of freedom
    // is 103.4.
    constexpr int kSide = 8, kCount = 64000;
    std::vector<int> counts(kSide * kSide);
    Rng rng(7, 1);
    for (int i = 0; i < kCount; ++i) {
        const auto [u, v] = octahedral_square(uniform_direction(rng));
        ASSERT_GE(u, 0);
        ASSERT_LE(u, 1);
        ASSERT_GE(v, 0);
        ASSERT_LE(v, 1);
        const int c = std::min(static_cast<int>(u * kSide), kSide - 1);
        const int r = std::min(static_cast<int>(v * kSide), kSide - 1);
        ++counts[r * kSide + c];
    }
    const double expected = static_cast<double>(kCount) / counts.size();
    double chi2 = 0;
    for (int count : counts) chi2 += (count - expected) * (count - expected) / expected;
    EXPECT_LT(chi2, 103.4);
}

TEST(OctahedralSquare, IsContinuousOnTheUpperHalfAndAcrossTheEquator) {
    Rng rng(7, 2);
    constexpr float kStep = 1e-3f;
    for (int i = 0; i < 2000; ++i) {
        Vec3f n = uniform_direction(rng);
        if (n.z < -0.1f) n.z = -n.z;
        const auto p = octahedral_square(n);
        const auto q = octahedral_square(normalize(n + kStep * uniform_direction(rng)));
        // Areas are kept, lengths are stretched by less than 2.
        EXPECT_LT(std::hypot(p[0] - q[0], p[1] - q[1]), 2 * kStep)
            << n.x << ' ' << n.y << ' ' << n.z;
    }
}

TEST(OctahedralSquare, PolesAndAxesLieWhereTheyShould) {
    EXPECT_EQ(octahedral_square({0, 0, 1}), (std::array{0.5, 0.5}));
    EXPECT_EQ(octahedral_square({1, 0, 0}), (std::array{1.0, 0.5}));
    EXPECT_EQ(octahedral_square({0, -1, 0}), (std::array{0.5, 0.0}));
    EXPECT_EQ(octahedral_square({0, 0, -1}), (std::array{1.0, 1.0}));
}

double area(const bsdf::Patch& p) {
    return std::abs(double{p.edge_1.x} * p.edge_2.y - double{p.edge_1.y} * p.edge_2.x);
}

TEST(SurfacePatch, KeepsTheFractionOfASpheresArea) {
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
            const double fraction =
                area(sphere_patch(n, kEdge * frame.s, kEdge * frame.t)) * 4 * std::numbers::pi;
            EXPECT_NEAR(fraction / (kEdge * kEdge), 1, 0.02) << theta << ' ' << phi;
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

TEST(SurfacePatch, InObjectSpaceKeepsItsAreaAndLiesAcrossTheShadingNormal) {
    const AffineMap map({.scale = 3, .rotation_deg = {40, 50, -60}, .translation_mm = {7, 8, 9}});
    const Vec3f geometric = normalize(Vec3f{0.2f, -0.7f, 0.6f});
    const Frame facet = Frame::around(geometric);
    const Vec3f edge_1 = 0.3f * facet.s, edge_2 = 0.1f * facet.s + 0.2f * facet.t;
    int checked = 0;
    for (float tilt : {0.0f, 0.1f, 0.5f, 1.5f}) {
        const Vec3f shading =
            normalize(geometric + std::tan(tilt) * facet.to_world(Vec3f{0.6f, 0.8f, 0}));
        const Vec3f in_object_space{0.5f, 2, -1};
        const sparkle::ObjectSpaceFootprint p = object_space_footprint(
            map, map.point((1 / 3.0f) * in_object_space), geometric, shading, edge_1, edge_2);
        EXPECT_LT(length(p.position_mm - in_object_space),
                  4e-6f);  // object space has the scaled lengths
        EXPECT_NEAR(length(cross(p.edge_mm[0], p.edge_mm[1])), 0.06, 1e-6);
        for (Vec3f v : {p.edge_mm[0], p.edge_mm[1], p.tangent})
            EXPECT_NEAR(dot(v, p.normal), 0, 1e-6);
        EXPECT_LT(length(map.direction(p.normal) - shading), 1e-6f);
        EXPECT_LT(length(map.direction(p.tangent) - Frame::around(shading).s), 1e-6f);
        // Turned about the axis across both normals, by no more than what lies between these.
        EXPECT_LE(length(map.direction(p.edge_mm[1]) - edge_2), tilt * length(edge_2) + 1e-6f);
        ++checked;
    }
    EXPECT_EQ(checked, 4);
}

TEST(RayDifferential, FootprintOnAPlaneIsWhereTheNeighbouringRaysHit) {
    const Vec3f to_x{0.01f, 0, 0}, direction = normalize(Vec3f{0, 0.6f, -0.8f});
    const RayDifferential d{{}, {to_x, 0.01f * normalize(Vec3f{0, 0.8f, 0.6f})}};
    const auto edges = d.at(direction, 100, {0, 0, 1});
    EXPECT_NEAR(edges.edge_mm[0].x, 1, 1e-5);
    EXPECT_NEAR(edges.edge_mm[0].y, 0, 1e-5);
    EXPECT_NEAR(edges.edge_mm[1].y, 1 / 0.8, 1e-5);  // stretched by 1 / cos(theta)
    EXPECT_NEAR(edges.edge_mm[1].z, 0, 1e-5);
}

TEST(RayDifferential, IsThatOfTheImageBehindAFlatMirror) {
    // By way of a mirror in z = 0 to a plane at z = 50 is as far as straight on to z = -50.
    const Vec3f direction = normalize(Vec3f{0.3f, 0.6f, -0.8f});
    const RayDifferential d{{}, {{0.01f, 0, 0}, {0, 0.01f, 0}}};
    const float to_mirror = -30 / direction.z, onward = -50 / direction.z;
    const auto on_mirror = d.at(direction, to_mirror, {0, 0, 1});
    const Vec3f reflected{direction.x, direction.y, -direction.z};
    const auto through =
        d.reflected(direction, on_mirror, {0, 0, 1}, {}).at(reflected, onward, {0, 0, -1});
    const auto straight = d.at(direction, to_mirror + onward, {0, 0, 1});
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(length(through.edge_mm[i] - straight.edge_mm[i]), 0, 1e-5);
    }
}

// A convex mirror spreads neighbouring rays: against rays that are reflected one by one.
TEST(RayDifferential, IsThatOfRaysReflectedByASphere) {
    constexpr double kRadius_mm = 40, kStep = 1e-4;
    const auto reflect = [&](double x, double y) {
        const Vec3d direction = normalize(Vec3d{x, y, -1});  // from (0, 0, 200) to the sphere at 0
        const Vec3d origin{0, 0, 200};
        const double along = -dot(origin, direction);
        const double distance =
            along - std::sqrt(along * along - dot(origin, origin) + kRadius_mm * kRadius_mm);
        const Vec3d at = origin + distance * direction, n = normalize(at);
        return std::array{direction, at, direction - 2 * dot(direction, n) * n};
    };
    const double x = 0.12, y = -0.05;
    const auto [direction, at, out] = reflect(x, y);
    RayDifferential d{};
    std::array<Vec3f, 2> turned;
    for (int i = 0; i < 2; ++i) {
        const double dx = i == 0 ? kStep : 0, dy = i == 1 ? kStep : 0;
        const auto ahead = reflect(x + dx, y + dy), behind = reflect(x - dx, y - dy);
        d.direction[i] = to_float((0.5 / kStep) * (ahead[0] - behind[0]));
        turned[i] = to_float((0.5 / kStep) * (ahead[2] - behind[2]));
    }
    const Vec3f n = to_float(normalize(at)), ray = to_float(direction);
    const auto edges = d.at(ray, static_cast<float>(length(at - Vec3d{0, 0, 200})), n);
    constexpr float kPerRadius = 1 / static_cast<float>(kRadius_mm);
    const RayDifferential after =
        d.reflected(ray, edges, n, {kPerRadius * edges.edge_mm[0], kPerRadius * edges.edge_mm[1]});
    for (int i = 0; i < 2; ++i) {
        EXPECT_LT(length(after.direction[i] - turned[i]), 1e-4f * length(turned[i]));
    }
    EXPECT_NEAR(after.solid_angle(), length(cross(turned[0], turned[1])),
                1e-4 * after.solid_angle());
    EXPECT_GT(after.solid_angle(), 20 * d.solid_angle());
}

}  // namespace
}  // namespace nacre::render
