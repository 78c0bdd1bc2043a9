#include "nacre/render/mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/render/compiled_scene.h"
#include "nacre/testing/render.h"

namespace nacre::render {
namespace {

/// Smallest cosine between a triangle's own normal and the shading normals at its corners.
double worst_normal(const Mesh& mesh) {
    double worst = 1;
    for (const auto& t : mesh.triangles) {
        const Vec3f n = cross(mesh.positions_mm[t[1]] - mesh.positions_mm[t[0]],
                              mesh.positions_mm[t[2]] - mesh.positions_mm[t[0]]);
        if (length(n) < 1e-7f) continue;  // the triangles at a tip have no area
        for (auto i : t) worst = std::min<double>(worst, dot(normalize(n), mesh.normals[i]));
    }
    return worst;
}

TEST(Mesh, PanelsHaveTheirSizeAndFaceUp) {
    EXPECT_NEAR(testing::area_mm2(make_mesh(FlatPanel{150, 100})), 15000, 1e-2);
    EXPECT_EQ(make_mesh(FlatPanel{150, 100}).normals[0], (Vec3f{0, 0, 1}));
    EXPECT_EQ(worst_normal(make_mesh(FlatPanel{150, 100})), 1);
    EXPECT_NEAR(testing::area_mm2(make_mesh(GroundPlane{200})), 40000, 1e-2);
}

TEST(Mesh, CurvedPanelKeepsItsArcLengthAndLiesOnItsCylinder) {
    const Mesh mesh = make_mesh(CurvedPanel{170, 110, 62});
    // Chords fall short of the arc by (angle per facet)^2 / 24, below 1e-5.
    EXPECT_NEAR(testing::area_mm2(mesh), 170.0 * 110, 170 * 110 * 1e-5);
    for (const Vec3f& p : mesh.positions_mm) EXPECT_NEAR(std::hypot(p.x, p.z + 62), 62, 1e-4);
    EXPECT_GT(worst_normal(mesh), 0.9999);
}

TEST(Mesh, BackdropIsSmoothFromFloorToWall) {
    const Mesh mesh = make_mesh(Backdrop{});
    EXPECT_GT(worst_normal(mesh), 0.999);
    EXPECT_EQ(mesh.normals.front(), (Vec3f{0, 0, 1}));
    EXPECT_EQ(mesh.normals.back(), (Vec3f{0, -1, 0}));
}

// Its normals look outwards, are of unit length and turn gently from facet to facet, or else the
// reflections would show the mesh.
TEST(Mesh, SpeedShapeIsSmoothSymmetricAndOnTheGround) {
    const Mesh mesh = make_mesh(SpeedShape{400});
    EXPECT_GT(worst_normal(mesh), 0.95);
    float low = 1e9f, left = 0, right = 0, nose = 0, tail = 0;
    for (const Vec3f& n : mesh.normals) EXPECT_NEAR(length(n), 1, 1e-5);
    for (const Vec3f& p : mesh.positions_mm) {
        low = std::min(low, p.z);
        left = std::max(left, p.y);
        right = std::min(right, p.y);
        nose = std::max(nose, p.x);
        tail = std::min(tail, p.x);
    }
    EXPECT_EQ(low, 0);
    EXPECT_NEAR(left, -right, 1e-3);
    EXPECT_NEAR(nose - tail, 400, 1e-3);
}

TEST(Mesh, TransformScalesThenRotatesAboutXThenYThenZThenMoves) {
    const AffineMap map({.scale = 2, .rotation_deg = {90, 0, 90}, .translation_mm = {1, 2, 3}});
    const Vec3f p = map.point({0, 1, 0});  // about x: to z; about z: stays
    EXPECT_NEAR(p.x, 1, 1e-6);
    EXPECT_NEAR(p.y, 2, 1e-6);
    EXPECT_NEAR(p.z, 5, 1e-6);
    const Vec3f d = map.direction({1, 0, 0});  // about z: to y
    EXPECT_NEAR(d.y, 1, 1e-6);
}

TEST(CompiledSceneRays, HitAndAreOccludedByAScaledAndMovedSphere) {
    SceneDescription description;
    description.materials["m"] = DiffuseMaterial{};
    description.shapes.push_back(
        {Sphere{.radius_mm = 20}, "m", {.scale = 2, .translation_mm = {5, 0, 0}}});
    const Scene scene(description, {});
    const auto hit = scene.compiled().intersect({{5, -1000, 10}, {0, 1, 0}}, false);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->position_mm.y, -std::sqrt(40.0 * 40 - 100), 1e-3);
    EXPECT_NEAR(hit->shading_normal.z, 0.25, 1e-5);
    EXPECT_FALSE(scene.compiled().intersect({{5, -1000, 41}, {0, 1, 0}}, false).has_value());
    EXPECT_TRUE(scene.compiled().occluded({{5, -1000, 10}, {0, 1, 0}}, 2000));
    EXPECT_FALSE(scene.compiled().occluded({{5, -1000, 10}, {0, 1, 0}}, 900));
    EXPECT_FALSE(scene.compiled().occluded({hit->origin(), {0, -1, 0}}, 900));
}

}  // namespace
}  // namespace nacre::render
