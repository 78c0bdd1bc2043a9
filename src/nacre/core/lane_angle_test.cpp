#include "nacre/core/lane_angle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/testing/worst.h"

namespace nacre {
namespace {

TEST(LaneAngle, AnglesKeepTheirErrorAllAroundAndAtAnySize) {
    double worst = 0;
    int count = 0;
    for (float size : {1e-20f, 1e-3f, 1.0f, 1e15f}) {
        for (double angle = -3.1415; angle < 3.1415; angle += 1.7e-4, ++count) {
            const float x = size * static_cast<float>(std::cos(angle));
            const float y = size * static_cast<float>(std::sin(angle));
            const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
            worst = test::worse(worst, std::abs(atan2_lanes(splat(y), splat(x))[5] - exact));
        }
    }
    EXPECT_GT(count, 100000);
    EXPECT_GT(worst, 0);
    EXPECT_LT(worst, kAtan2LanesError);
}

TEST(LaneAngle, SmallAnglesKeepTheirDigits) {
    for (float y = 1e-30f; y < 0.1f; y *= 3) {
        const double exact = std::atan2(static_cast<double>(y), 1.0);
        EXPECT_NEAR(atan2_lanes(splat(y), splat(1.0f))[0], exact, kAtan2LanesError * exact);
    }
}

TEST(LaneAngle, AxesAndTheOriginAreExact) {
    const FloatLanes y{0, 1, 0, -1, 0, 0, 0, 0}, x{1, 0, -1, 0, 0, 0, 0, 0};
    const FloatLanes angle = atan2_lanes(y, x);
    for (int i = 0; i < kLanes; ++i) EXPECT_FLOAT_EQ(angle[i], std::atan2(y[i], x[i]));
}

}  // namespace
}  // namespace nacre
