#include "nacre/core/lane_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nacre/core/rng.h"

namespace nacre {
namespace {

TEST(LaneMath, ExponentialKeepsItsErrorBoundOverItsRange) {
    double worst = 0;
    int tried = 0;
    for (float x = -86.9f; x < 87.9f; x += 0.0371f, ++tried) {
        const FloatLanes found =
            exp_lanes(make_lanes([&](int i) { return x + 0.001f * static_cast<float>(i); }));
        for (int i = 0; i < kLanes; ++i) {
            // The argument as a float, so that its own rounding does not count.
            const float argument = x + 0.001f * static_cast<float>(i);
            const double exact = std::exp(static_cast<double>(argument));
            worst = std::max(worst, std::abs(found[i] - exact) / exact);
        }
    }
    EXPECT_GT(tried, 4000);
    EXPECT_LT(worst, kExpLanesError);
}

TEST(LaneMath, ExponentialIsClampedAndFiniteOutsideItsRange) {
    EXPECT_FLOAT_EQ(exp_lanes(splat(-1000.0f))[0], std::exp(-87.0f));
    EXPECT_TRUE(std::isfinite(exp_lanes(splat(1000.0f))[0]));
    EXPECT_FLOAT_EQ(exp_lanes(splat(0.0f))[7], 1.0f);
}

TEST(LaneMath, OneMinusExponentialKeepsItsDigitsWhereItVanishes) {
    double worst = 0;
    for (float x = 1e-20f; x < 80.0f; x *= 1.07f) {
        const double exact = -std::expm1(-static_cast<double>(x));
        const double found = one_minus_exp_lanes(splat(x))[3];
        worst = std::max(worst, std::abs(found - exact) / exact);
    }
    EXPECT_GT(worst, 0);
    EXPECT_LT(worst, kOneMinusExpLanesError);
}

TEST(Lanes, LargerSmallerAndRootActOnEachLane) {
    const FloatLanes rising = make_lanes([](int i) { return static_cast<float>(i); });
    const FloatLanes falling = make_lanes([](int i) { return static_cast<float>(7 - i); });
    for (int i = 0; i < kLanes; ++i) {
        EXPECT_EQ(max_lanes(rising, falling)[i], std::max(i, 7 - i));
        EXPECT_EQ(min_lanes(rising, falling)[i], std::min(i, 7 - i));
        EXPECT_FLOAT_EQ(sqrt_lanes(rising)[i], std::sqrt(static_cast<float>(i)));
    }
    EXPECT_EQ(lane_sum(rising), 28);
    EXPECT_EQ(lane_max(rising), 7);
    EXPECT_EQ(lane_mean(rising), 3.5f);
    const FloatLanes nan = splat(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(max_lanes(nan, splat(2.0f))[0], 2);
}

TEST(LaneMath, LogarithmKeepsItsBound) {
    Rng rng(1);
    for (int i = 0; i < 20000; ++i) {
        const float x = std::exp(170 * (rng.uniform_float() - 0.5f));
        const float near_one = 1 - 0.001f * rng.uniform_float();
        const FloatLanes found = log_lanes(FloatLanes{x, near_one, 1, 1, 1, 1, 1, 1});
        EXPECT_NEAR(found[0], std::log(static_cast<double>(x)),
                    kLogLanesError * (1 + std::abs(std::log(x))));
        EXPECT_NEAR(found[1], std::log(static_cast<double>(near_one)), kLogLanesError * 1e-3);
        EXPECT_EQ(found[2], 0);
    }
}

}  // namespace
}  // namespace nacre
