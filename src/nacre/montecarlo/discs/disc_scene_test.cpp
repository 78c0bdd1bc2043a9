#include "nacre/montecarlo/discs/disc_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/testing/discs.h"

namespace nacre::montecarlo {
namespace {

constexpr Tile kTile{100, 60};
constexpr Vec3f kDown{0, 0, -1};

Disc disc(Vec3f centre_um, float radius_um, Vec3f slopes = {0, 0, 1}) {
    return {centre_um, radius_um, normalize(slopes), 0, 0};
}

TEST(DiscScene, RaysMeetTheNearestDiscWhereItIs) {
    const DiscScene scene({disc({50, 30, -10}, 8), disc({50, 30, -20}, 12, {0.1f, 0, 1})}, kTile);
    const auto upper = scene.intersect({56, 30, 0}, kDown, 100, DiscScene::kNone);
    ASSERT_TRUE(upper);
    EXPECT_EQ(upper->disc, 0u);
    EXPECT_NEAR(upper->distance_um, 10, 1e-5);
    const auto lower = scene.intersect({59, 30, 0}, kDown, 100, DiscScene::kNone);
    ASSERT_TRUE(lower);
    EXPECT_EQ(lower->disc, 1u);
    // Its plane: 0.1 (x - 50) + (z + 20) = 0.
    EXPECT_NEAR(lower->distance_um, 20.9, 1e-5);
    EXPECT_FALSE(scene.intersect({62.1f, 30, 0}, kDown, 100, DiscScene::kNone));
    EXPECT_FALSE(scene.intersect({50, 30, 0}, kDown, 9.9f, DiscScene::kNone));
    EXPECT_EQ(scene.intersect({50, 30, -10}, kDown, 100, 0)->disc, 1u);
    EXPECT_EQ(scene.intersect({50, 30, -9.999f}, kDown, 100, 0)->disc, 1u) << "by rounding only";
}

TEST(DiscScene, FlakesReachOverTheEdgesOfTheTile) {
    const DiscScene scene({disc({99, 59, -10}, 8)}, kTile);
    EXPECT_EQ(scene.count(), 1u);
    for (const Vec3f& p : {Vec3f{95, 55, 0}, Vec3f{3, 55, 0}, Vec3f{95, 3, 0}, Vec3f{3, 3, 0}}) {
        EXPECT_TRUE(scene.intersect(p, kDown, 100, DiscScene::kNone)) << p.x << ", " << p.y;
    }
    EXPECT_FALSE(scene.intersect({8, 8, 0}, kDown, 100, DiscScene::kNone));
    // Wider than the tile: covers all of it, more than once.
    const DiscScene wide({disc({50, 30, -10}, 150)}, kTile);
    for (float x = 1; x < 100; x += 10)
        EXPECT_TRUE(wide.intersect({x, 59, 0}, kDown, 100, DiscScene::kNone));
}

TEST(DiscScene, RaysLeaveWhereDiscsCross) {
    // At the same position, so that each is in front of the other.
    const DiscScene scene(
        {disc({50, 30, -10}, 8, {0.1f, 0, 1}), disc({50, 30, -10}, 8, {-0.1f, 0, 1})}, kTile);
    EXPECT_TRUE(scene.intersect({50, 30, -5}, kDown, 100, DiscScene::kNone));
    EXPECT_FALSE(scene.intersect({50, 30, -10}, kDown, 100, 0));
    EXPECT_FALSE(scene.intersect({50, 30, -10}, kDown, 100, 1));
}

TEST(DiscScene, NoFlakesNoHits) {
    const DiscScene scene({}, kTile);
    EXPECT_FALSE(scene.intersect({50, 30, 0}, kDown, 1e6f, DiscScene::kNone));
}

DiscScene scene_of(const paint::Recipe& recipe, double side_um, std::uint64_t seed) {
    const Tile tile{side_um, side_um};
    return {draw_discs(recipe, tile, {1}, seed), tile};
}

/// s(mu) / mu (paint/beckmann.h) at alpha = 0.1, nearly the same at all angles: s(1).
const double kAcross = 0.995073;

TEST(Visibility, OneWayFollowsTheLawOfTheTransferEquation) {
    // Whatever the size of the flakes, one straight path meets a Poisson number of them.
    for (const double diameter : {4.0, 20.0}) {
        const double side = 250 * diameter;
        const auto v = flake_visibility(scene_of(test::opaque(2, 15, diameter), side, 1),
                                        test::direction(20, 0), test::direction(20, 180), 5);
        const double tau = 2 * kAcross;
        // 160000 flakes with shared shadows: 1 % is more than 5 standard errors.
        EXPECT_NEAR(v.lit, (1 - std::exp(-tau)) / tau, 0.01 * v.lit) << diameter;
    }
}

/// V(z) = exp(-beta [q_i z + q_o z - q Int_0^z O(delta / d)]), averaged over z in [0, 1]; O is the
/// overlap of two discs, delta the distance between the two paths.
double hot_spot(double depth, double spread_over_diameter) {
    constexpr int kSteps = 4000;
    double shared = 0, sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = (i + 0.5) / kSteps, x = std::min(1.0, z * spread_over_diameter);
        const double overlap = 2 / M_PI * (std::acos(x) - x * std::sqrt(1 - x * x));
        shared += 0.5 * overlap / kSteps;
        sum += std::exp(-depth * kAcross * (2 * z - shared)) / kSteps;
        shared += 0.5 * overlap / kSteps;
    }
    return sum;
}

TEST(Visibility, HotSpotFollowsTheOverlapOfTheTwoPaths) {
    // The hot spot of docs/explicit-flakes.md: 20 um flakes in 15 um, beta 2, specular at 20 deg
    // outside: 0.397 against 0.247 by the transfer equation, for flakes of any size.
    const double inside = std::asin(std::sin(test::degrees(20)) / 1.5) / test::degrees(1);
    const auto scene = scene_of(test::opaque(2, 15, 20), 4000, 3);
    const auto v =
        flake_visibility(scene, test::direction(inside, 0), test::direction(inside, 180), 7);
    EXPECT_NEAR(v.bidirectional, 0.397, 0.01);
    const double tau = 4 * kAcross;
    EXPECT_GT(v.bidirectional, 1.5 * (1 - std::exp(-tau)) / tau);
    EXPECT_NEAR((1 - std::exp(-tau)) / tau, 0.247, 1e-3);
    for (const double diameter : {4.0, 20.0, 60.0}) {
        const auto s = scene_of(test::opaque(2, 15, diameter), 150 * diameter, 4);
        const auto found = flake_visibility(s, test::direction(20, 0), test::direction(20, 180), 8);
        EXPECT_NEAR(found.bidirectional,
                    hot_spot(2, 2 * 15 * std::tan(test::degrees(20)) / diameter),
                    0.02 * found.bidirectional)
            << diameter;
    }
}

TEST(Visibility, FlakesArePartlyHidden) {
    // E[v^2] lies between that of flakes each dimmed by the mean v at its depth, and that of flakes
    // wholly visible or hidden.
    const auto v = flake_visibility(scene_of(test::opaque(2, 15, 2), 300, 1), test::direction(0, 0),
                                    test::direction(50, 0), 5);
    const double tau = 4 * kAcross;
    const double dimmed = (1 - std::exp(-2 * tau)) / (2 * tau), mean = (1 - std::exp(-tau)) / tau;
    EXPECT_GT(v.mean_square, 1.15 * dimmed);
    EXPECT_LT(v.mean_square, 0.8 * mean);
}

TEST(DiscScene, StopsWhileItIsBuilt) {
    const Progress always = [](double) { return true; }, never = [](double) { return false; };
    SharedProgress going(always, 1), stopped(never, 1);
    stopped.add(0);
    const std::vector<Disc> one = {disc({50, 30, -10}, 8)};
    EXPECT_THROW(DiscScene(one, kTile, &stopped), Stopped);
    EXPECT_THROW(DiscScene({}, kTile, &stopped), Stopped);
    const DiscScene scene(one, kTile, &going);
    EXPECT_TRUE(scene.intersect({50, 30, 0}, kDown, 100, DiscScene::kNone));
}

}  // namespace
}  // namespace nacre::montecarlo
