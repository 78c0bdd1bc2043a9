#include "nacre/volume/radial_ray.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace nacre::volume {
namespace {

// A ray on a small sphere, by plain vectors.
constexpr double kRadius = 7;

Eigen::Vector3d at(double cosine, double t) {
    return Eigen::Vector3d(0, 0, kRadius) +
           t * Eigen::Vector3d(std::sqrt(1 - cosine * cosine), 0, cosine);
}

TEST(RadialRay, HeightAndCosineAreThoseOfVectors) {
    for (const double cosine : {-1.0, -0.7, -0.01, 0.0, 0.3, 1.0}) {
        const RadialRay ray{1 / kRadius, cosine};
        for (const double t : {0.0, 0.5, 3.0, 6.0, 20.0}) {
            const Eigen::Vector3d p = at(cosine, t), way = at(cosine, 1) - at(cosine, 0);
            EXPECT_NEAR(ray.rise(t), p.norm() - kRadius, 1e-13);
            EXPECT_NEAR(ray.cosine_at(t), p.normalized().dot(way), 1e-13);
        }
    }
}

TEST(RadialRay, ReachesTheSpheresItIsSentTo) {
    int reached = 0;
    for (const double cosine : {-1.0, -0.7, -0.3, -0.01, 0.0, 0.3, 1.0}) {
        const RadialRay ray{1 / kRadius, cosine};
        for (const double height : {0.0, 1e-9, 0.5, 4.0}) {
            const double out = ray.distance_outwards(height);
            EXPECT_NEAR(ray.rise(out), height, 1e-13);
            EXPECT_GE(ray.cosine_at(out), -1e-13) << "outwards";
            const double in = ray.distance_inwards(height);
            const double nearest = kRadius * (1 - std::sqrt(1 - cosine * cosine));
            const bool hits = cosine < 0 && height <= nearest;
            EXPECT_EQ(std::isfinite(in), hits) << cosine << ' ' << height;
            if (!hits) continue;
            EXPECT_NEAR(ray.rise(in), -height, 1e-13);
            EXPECT_LE(ray.cosine_at(in), 0);
            ++reached;
        }
    }
    EXPECT_GE(reached, 10);
}

TEST(RadialRay, CurvatureZeroIsAFlatLayer) {
    const RadialRay up{0, 0.5}, down{0, -0.5}, level{0, 0};
    EXPECT_EQ(up.distance_outwards(3), 6);
    EXPECT_EQ(down.distance_inwards(3), 6);
    EXPECT_TRUE(std::isinf(down.distance_outwards(3)));
    EXPECT_TRUE(std::isinf(up.distance_inwards(3)));
    EXPECT_TRUE(std::isinf(level.distance_inwards(3)));
    EXPECT_EQ(up.rise(4), 2);
    EXPECT_EQ(up.cosine_at(1e9), 0.5);
}

TEST(RadialRay, ThinLayersOnLargeSpheresKeepTheirDigits) {
    // 15 um on 1 km: a difference of radii would keep 7 digits of the height, and these are flat
    // layers but for a share of 15 um / 1 km / cosine^2.
    const RadialRay ray{1e-9, -0.6};
    EXPECT_NEAR(ray.distance_inwards(15) / 25, 1, 1e-7);
    EXPECT_NEAR(ray.rise(ray.distance_inwards(15)), -15, 1e-13);
    const RadialRay chord{1e-9, -1e-3};
    EXPECT_NEAR(chord.distance_outwards(0), 2e6, 1e-6) << "2 r cos";
}

}  // namespace
}  // namespace nacre::volume
