#include "nacre/sparkle/flake_plane.h"

#include <gtest/gtest.h>

#include "nacre/core/random.h"
#include "nacre/testing/statistics.h"

namespace nacre::sparkle {
namespace {

Vec3f direction(Rng& rng) {
    const float z = 2 * rng.uniform_float() - 1, angle = 6.2831853f * rng.uniform_float();
    const float s = std::sqrt(1 - z * z);
    return {s * std::cos(angle), s * std::sin(angle), z};
}

float component(Vec3f n, int axis) { return axis == 0 ? n.x : axis == 1 ? n.y : n.z; }

TEST(Projections, FractionsAddUpToOneAndStretchIsBounded) {
    Rng rng(1);
    float largest = 0;
    for (int trial = 0; trial < 100000; ++trial) {
        const Vec3f n = direction(rng);
        const Projections p = projections_of(n);
        float sum = 0;
        ASSERT_GE(p.count, 1);
        for (int i = 0; i < p.count; ++i) {
            const float c = component(n, p.list[i].side / 2);
            EXPECT_EQ(p.list[i].side % 2, c < 0);
            sum += p.list[i].fraction;
            largest = test::worse(largest, p.list[i].fraction / std::abs(c));
        }
        EXPECT_NEAR(sum, 1, 1e-6);
    }
    EXPECT_LE(largest, kMaxStretch);
    EXPECT_GT(largest, 0.98f * kMaxStretch);
}

TEST(Projections, ChangeContinuously) {
    Rng rng(2);
    for (int trial = 0; trial < 20000; ++trial) {
        const Vec3f n = direction(rng), m = normalize(n + 1e-4f * direction(rng));
        float fraction[2][6] = {};
        int which = 0;
        for (const Vec3f& v : {n, m}) {
            const Projections p = projections_of(v);
            for (int i = 0; i < p.count; ++i) fraction[which][p.list[i].side] = p.list[i].fraction;
            ++which;
        }
        // Weights change by at most 4 |dn| over a sum of at least kProjectionBlend.
        for (int side = 0; side < 6; ++side) {
            EXPECT_NEAR(fraction[0][side], fraction[1][side], 1e-4 * 12 / kProjectionBlend);
        }
    }
}

}  // namespace
}  // namespace nacre::sparkle
