#include "nacre/render/polygon_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/testing/statistics.h"

namespace nacre::render {
namespace {

/// Triangles of a sphere of radius 1 about the origin, cut by longitude and latitude.
std::vector<Vec3f> sphere(int around, int down) {
    const auto point = [&](int i, int j) {
        const double u = 2 * std::numbers::pi * (i % around) / around,
                     v = std::numbers::pi * j / down;
        const double s = j == 0 || j == down ? 0 : std::sin(v);
        return Vec3f{static_cast<float>(s * std::cos(u)), static_cast<float>(s * std::sin(u)),
                     static_cast<float>(std::cos(v))};
    };
    std::vector<Vec3f> corners;
    for (int j = 0; j < down; ++j) {
        for (int i = 0; i < around; ++i) {
            const Vec3f a = point(i, j), b = point(i, j + 1), c = point(i + 1, j + 1),
                        d = point(i + 1, j);
            if (j + 1 < down) corners.insert(corners.end(), {a, b, c});
            if (j > 0) corners.insert(corners.end(), {a, c, d});
        }
    }
    return corners;
}

double worst_of_sphere(int around, int down) {
    const std::vector<Vec3f> corners = sphere(around, down);
    const std::vector<Vec3f> normals = smooth_normals(corners, 40);
    double worst = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        worst = test::worse(worst, double{length(normals[i] - corners[i])});
    }
    return worst;
}

// The normal of a sphere is its radius; the error goes with the square of the triangles' size.
TEST(SmoothNormals, AreThoseOfASphere) {
    const double coarse = worst_of_sphere(32, 16), fine = worst_of_sphere(64, 32);
    EXPECT_LT(coarse, 0.04);
    EXPECT_LT(fine, 0.3 * coarse);
    // More triangles at a pole than are looked at for creases.
    EXPECT_LT(worst_of_sphere(2000, 100), 0.002);
}

// Cut in three or in two, a face of a cube counts by its angle.         [thurmer-1998]
TEST(SmoothNormals, CountTrianglesByTheirAngle) {
    const Vec3f o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, xy{1, 1, 0}, yz{0, 1, 1},
        zx{1, 0, 1};
    const std::vector<Vec3f> corners{o, y, xy, o, xy, x,  // below, in two
                                     o, z, yz, o, yz, y, o, x, zx, o, zx, z};
    const float third = -1 / std::sqrt(3.0f);
    const std::vector<Vec3f> normals = smooth_normals(corners, 180);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (!(corners[i] == o)) continue;
        EXPECT_LT(length(normals[i] - Vec3f{third, third, third}), 1e-6f) << i;
    }
}

TEST(SmoothNormals, EndAtCreases) {
    const Vec3f a{0, 0, 0}, b{0, 1, 0};
    const auto folded = [&](double degrees) {
        const double turn = degrees * std::numbers::pi / 180;
        const Vec3f down{static_cast<float>(std::cos(turn)), 0,
                         static_cast<float>(-std::sin(turn))};
        const std::vector<Vec3f> corners{a, b, {-1, 0, 0}, b, a, down};
        const std::vector<Vec3f> normals = smooth_normals(corners, 40);
        return dot(normals[0], normals[4]);  // both in a
    };
    EXPECT_NEAR(folded(39.9), 1, 1e-6);
    EXPECT_NEAR(folded(40.1), std::cos(40.1 * std::numbers::pi / 180), 1e-6);
    // Planes are creased where any angle is one, and not by rounding.
    const std::vector<Vec3f> flat{a, {1, 0.1f, 0.3f}, {1, 1.1f, 0.3f}, a, {1, 1.1f, 0.3f}, b};
    const std::vector<Vec3f> normals = smooth_normals(flat, 0);
    EXPECT_EQ(normals[0], normals[3]);
}

TEST(SmoothNormals, OfNoAreaAreThoseOfWhatTheyMeet) {
    const Vec3f a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, far{5, 5, 5};
    const std::vector<Vec3f> normals =
        smooth_normals(std::vector<Vec3f>{a, c, b, a, b, b, far, far, far}, 40);
    EXPECT_EQ(normals[3], (Vec3f{0, 0, -1}));
    EXPECT_EQ(normals[6], (Vec3f{0, 0, 1}));
}

// ------------------------------------------------------------------------------------ polygons

/// Area by the triangles that a polygon is cut into; each must be turned as the polygon is.
double area_of(const std::vector<Vec3f>& polygon) {
    double steps = 1e9, area = 0;
    const auto triangles = cut_into_triangles(polygon, steps);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    Vec3d normal{0, 0, 0};
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        normal += to_double(cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]));
    }
    for (const auto& [a, b, c] : triangles) {
        const Vec3d twice = to_double(cross(polygon[b] - polygon[a], polygon[c] - polygon[a]));
        EXPECT_GE(dot(twice, normal), 0);
        area += 0.5 * length(twice);
    }
    return area;
}

/// A star of 2n corners on circles of radius 1 and 0.2, in a plane across `normal`.
std::vector<Vec3f> star(int n, Vec3f normal, bool turned) {
    const Vec3f u = normalize(cross(normal, Vec3f{0.3f, 0.5f, 0.1f})), v = cross(normal, u);
    std::vector<Vec3f> corners;
    for (int i = 0; i < 2 * n; ++i) {
        const double angle = (turned ? -1 : 1) * std::numbers::pi * i / n;
        const double radius = i % 2 == 0 ? 1 : 0.2;
        corners.push_back(static_cast<float>(radius * std::cos(angle)) * u +
                          static_cast<float>(radius * std::sin(angle)) * v);
    }
    return corners;
}

TEST(Polygons, AreCutIntoTrianglesThatCoverThem) {
    for (const Vec3f normal : {Vec3f{0, 0, 1}, Vec3f{0, -1, 0}, normalize(Vec3f{1, 2, -3})}) {
        for (const int n : {2, 3, 5, 17, 400}) {
            const double expected = n * 0.2 * std::sin(std::numbers::pi / n);
            EXPECT_NEAR(area_of(star(n, normal, false)), expected, 1e-5) << n;
            EXPECT_NEAR(area_of(star(n, normal, true)), expected, 1e-5) << n;
        }
    }
    // An L, begun at its inner corner; corners in the middle of sides.
    EXPECT_NEAR(area_of({{1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}}), 3,
                1e-6);
    EXPECT_NEAR(area_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}}), 4,
                1e-6);
}

// What has no ears, as it has no area or crosses itself, is cut as well.
TEST(Polygons, WithoutEarsAreCutInTheirOrder) {
    double steps = 1e9;
    EXPECT_EQ(cut_into_triangles(std::vector<Vec3f>(7, Vec3f{1, 2, 3}), steps).size(), 5u);
    EXPECT_EQ(
        cut_into_triangles(std::vector<Vec3f>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, steps)
            .size(),
        2u);
    steps = 10;
    EXPECT_THROW(cut_into_triangles(star(50, {0, 0, 1}, false), steps), Error);
}

TEST(EqualVertices, AreJoined) {
    Mesh mesh;
    mesh.positions_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0},
                         {1, 1, 0}, {0, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(7, Vec3f{0, 0, 1});
    mesh.normals[6] = {0, 1, 0};  // a vertex of its own
    mesh.uv = {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {0, 4, 6}};
    const Mesh before = mesh;
    join_equal_vertices(mesh);
    EXPECT_EQ(mesh.positions_mm.size(), 5u);
    EXPECT_EQ(mesh.triangles[1][0], mesh.triangles[0][1]);
    EXPECT_NE(mesh.triangles[2][2], mesh.triangles[0][2]);
    for (std::size_t t = 0; t < 3; ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t now = mesh.triangles[t][k], then = before.triangles[t][k];
            EXPECT_EQ(mesh.positions_mm[now], before.positions_mm[then]);
            EXPECT_EQ(mesh.normals[now], before.normals[then]);
            EXPECT_EQ(mesh.uv[now].x, before.uv[then].x);
            EXPECT_EQ(mesh.uv[now].y, before.uv[then].y);
        }
    }
}

}  // namespace
}  // namespace nacre::render
