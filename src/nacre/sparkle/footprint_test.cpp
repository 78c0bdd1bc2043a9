#include "nacre/sparkle/footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nacre/core/random.h"

namespace nacre::sparkle {
namespace {

Footprint random_footprint(Rng& rng, double size) {
    const auto edge = [&] {
        return Vec2f{static_cast<float>(size * (rng.uniform_double() - 0.5)),
                     static_cast<float>(size * (rng.uniform_double() - 0.5))};
    };
    const double u = rng.uniform_double(), v = rng.uniform_double();
    const Vec2f a = edge();
    return Footprint(u, v, a, edge());
}

TEST(Footprint, AreaIsThatOfThePointsItHolds) {
    Rng rng(1);
    constexpr int kPoints = 20000;
    for (int i = 0; i < 20; ++i) {
        const Footprint footprint = random_footprint(rng, 1.5);
        int held = 0;
        for (int k = 0; k < kPoints; ++k) {
            const double u = rng.uniform_double();
            held += footprint.contains(u, rng.uniform_double());
        }
        const double a = footprint.area();
        EXPECT_NEAR(held, kPoints * a, 5 * std::sqrt(kPoints * a) + 5);
    }
}

TEST(Footprint, BoxesShareItsWholeArea) {
    Rng rng(2);
    for (int i = 0; i < 50; ++i) {
        const Footprint footprint = random_footprint(rng, 0.8);
        double sum = 0;
        for (int x = 0; x < 8; ++x) {
            for (int y = 0; y < 8; ++y) {
                const Box box{x / 8.0, y / 8.0, (x + 1) / 8.0, (y + 1) / 8.0};
                const double shared = footprint.shared_area(box);
                const Overlap overlap = footprint.overlap(box);
                if (overlap == Overlap::none) {
                    EXPECT_NEAR(shared, 0, 1e-12);
                } else if (overlap == Overlap::full) {
                    EXPECT_NEAR(shared, 1.0 / 64, 1e-12);
                }
                sum += shared;
            }
        }
        EXPECT_NEAR(sum, footprint.area(), 1e-12);
    }
}

TEST(Footprint, IsCutAtTheBorderOfTheSquare) {
    EXPECT_DOUBLE_EQ(Footprint(0, 0.5, {0.5f, 0}, {0, 0.25f}).area(), 0.0625);
    EXPECT_DOUBLE_EQ(Footprint(1, 1, {0.5f, 0}, {0, 0.5f}).area(), 0.0625);
    EXPECT_DOUBLE_EQ(Footprint(0.5, 0.5, {4, 0}, {0, 4}).area(), 1);
    EXPECT_EQ(Footprint(3, 0.5, {0.5f, 0}, {0, 0.5f}).area(), 0);
}

TEST(Footprint, WithoutAreaOrNotFiniteHoldsNothing) {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Footprint& f :
         {Footprint(0.5, 0.5, {0, 0}, {0, 0}), Footprint(0.5, 0.5, {0.1f, 0}, {0.2f, 0}),
          Footprint(0.5, 0.5, {inf, 0}, {0, 0.1f}), Footprint(nan, 0.5, {0.1f, 0}, {0, 0.1f}),
          Footprint(0.5, 0.5, {0.1f, nan}, {0, 0.1f}),
          Footprint(1e300, 0.5, {0.1f, 0}, {0, 0.1f})}) {
        EXPECT_EQ(f.area(), 0);
        EXPECT_FALSE(f.contains(0.5, 0.5) && f.area() > 0);
    }
}

}  // namespace
}  // namespace nacre::sparkle
