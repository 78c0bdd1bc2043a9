#include "nacre/sparkle/patch_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/random.h"

namespace nacre::sparkle {
namespace {

float overlap(double x, double y, double r, Vec2f a, Vec2f b) {
    return disc_overlap(splat(static_cast<float>(x)), splat(static_cast<float>(y)),
                        splat(static_cast<float>(r)), Parallelogram(a, b))[0];
}

TEST(DiscOverlap, IsTheDiscWithinAndTheParallelogramWithin) {
    const double error = kDiscOverlapError * std::numbers::pi;
    EXPECT_NEAR(overlap(0.3, -0.2, 1, {9, 1}, {-2, 7}), std::numbers::pi, error);
    EXPECT_NEAR(overlap(0.1, 0.1, 1, {0.5, 0.1}, {-0.1, 0.4}), 0.21, error);
    EXPECT_NEAR(overlap(30, 5, 1, {9, 1}, {-2, 7}), 0, error);
    EXPECT_NEAR(overlap(0, 3, 1, {4, 0}, {0, 6}), std::numbers::pi / 2, error);  // halved by a side
    // About a corner: a quarter less two slices, but for their square.
    EXPECT_NEAR(overlap(2.001, 3.001, 1, {4, 0}, {0, 6}), std::numbers::pi / 4 - 0.002 + 1e-6,
                error);
    EXPECT_NEAR(overlap(0, 3.5, 1, {4, 0}, {0, 6}),  // a segment
                std::acos(0.5) - 0.5 * std::sqrt(0.75), error);
}

TEST(DiscOverlap, AgreesWithCountingPoints) {
    Rng rng(3);
    for (int trial = 0; trial < 200; ++trial) {
        const auto coordinate = [&] { return 3 * rng.uniform_double() - 1.5; };
        Vec2f a = {static_cast<float>(coordinate()), static_cast<float>(coordinate())};
        Vec2f b = {static_cast<float>(coordinate()), static_cast<float>(coordinate())};
        const double area = double{a.x} * b.y - double{a.y} * b.x;
        if (area < 0) std::swap(a, b);
        const double x = coordinate(), y = coordinate();
        constexpr int kSide = 200;
        int inside = 0;
        for (int i = 0; i < kSide; ++i) {
            for (int j = 0; j < kSide; ++j) {
                const double s = (i + 0.5) / kSide - 0.5, t = (j + 0.5) / kSide - 0.5;
                inside += std::hypot(s * a.x + t * b.x - x, s * a.y + t * b.y - y) < 1;
            }
        }
        // The rim passes through some 4 x 200 of the 40 000 points' cells.
        EXPECT_NEAR(overlap(x, y, 1, a, b), std::abs(area) * inside / (kSide * kSide),
                    2e-3 * std::abs(area) + kDiscOverlapError * std::numbers::pi)
            << trial;
    }
}

TEST(DiscOverlap, OfPartsAddsUp) {
    const Vec2f a = {0.7f, 0.2f}, b = {-0.1f, 0.9f};
    for (double x = -1.5; x <= 1.5; x += 0.25) {
        double parts = 0;
        for (double s : {-0.25, 0.25}) {
            for (double t : {-0.25, 0.25}) {
                parts += overlap(x - (s * a.x + t * b.x), 0.3 - (s * a.y + t * b.y), 1,
                                 {0.5f * a.x, 0.5f * a.y}, {0.5f * b.x, 0.5f * b.y});
            }
        }
        EXPECT_NEAR(parts, overlap(x, 0.3, 1, a, b), 4 * kDiscOverlapError * std::numbers::pi) << x;
    }
}

}  // namespace
}  // namespace nacre::sparkle
