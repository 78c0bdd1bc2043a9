#include "nacre/montecarlo/discs/airy_disc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::montecarlo {
namespace {

TEST(AiryDisc, DarkRingsEnclosePublishedFractions) {
    // [born-wolf-1999, section 8.5.2, table 8.2]: the first three dark rings and what lies within.
    EXPECT_NEAR(encircled_power(1.220 * M_PI), 0.838, 5e-4);
    EXPECT_NEAR(encircled_power(2.233 * M_PI), 0.910, 5e-4);
    EXPECT_NEAR(encircled_power(3.238 * M_PI), 0.938, 5e-4);
}

TEST(AiryDisc, EncircledPowerIsTheIntegralOfThePattern) {
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double x = 10 * (i + 0.5) / kSteps, amplitude = 2 * ::j1(x) / x;
        // The pattern's integral over the plane is 4 pi.
        sum += amplitude * amplitude * x / 2 * (10.0 / kSteps);
    }
    EXPECT_NEAR(sum, encircled_power(10), 1e-7);
}

TEST(AiryDisc, RadiusInvertsTheEncircledPower) {
    for (double fraction = 0; fraction < 0.996; fraction += 0.00037) {
        const double x = AiryDisc::radius_of_fraction(fraction);
        // Compared as fractions: at dark rings x is ill-conditioned.
        EXPECT_NEAR(encircled_power(x), fraction,
                    kAiryDiscError * std::fmin(fraction, 1 - fraction) + 1e-12)
            << fraction;
    }
}

TEST(AiryDisc, RadiusGrowsForEverAndStaysFinite) {
    double last = -1;
    for (double rest = 0.1; rest > 1e-17; rest *= 0.7) {
        const double x = AiryDisc::radius_of_fraction(1 - rest);
        EXPECT_GE(x, last);
        EXPECT_TRUE(std::isfinite(x) || 1 - rest == 1);
        last = x;
    }
    EXPECT_EQ(AiryDisc::radius_of_fraction(0), 0);
}

}  // namespace
}  // namespace nacre::montecarlo
