#include "nacre/measure/image_clarity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/math.h"

namespace nacre::measure {
namespace {

// Against the blur itself: the brightness at the middle of a bright and of a dark bar by a sum over
// the law of the slopes.
TEST(ImageClarity, TheContrastOfAGrilleIsThatOfItsBlurredImage) {
    int cases = 0;
    for (const double blur : {0.02, 0.1, 0.25, 0.299, 0.301, 0.5}) {  // in periods
        const double period_deg = 2, slope = 0.5 * blur * period_deg * kDegree;
        double bright = 0, all = 0;
        constexpr int kSteps = 400'000;
        for (int i = 0; i < kSteps; ++i) {
            const double z = 16 * (i + 0.5) / kSteps - 8, weight = std::exp(-0.5 * z * z);
            const double phase = std::abs(std::remainder(z * blur, 1));
            all += weight;
            if (phase < 0.25) bright += weight;
        }
        EXPECT_NEAR(grille_contrast(slope, period_deg), 2 * bright / all - 1, 1e-4) << blur;
        ++cases;
    }
    EXPECT_EQ(cases, 6);
}

TEST(ImageClarity, AFlatCoatKeepsAllContrastAndARoughOneNone) {
    EXPECT_EQ(grille_contrast(0, 0.01), 1);
    EXPECT_NEAR(grille_contrast(1e-5, 1), 1, 1e-12);
    EXPECT_NEAR(grille_contrast(0.1, 0.1), 0, 1e-12);
    EXPECT_EQ(half_contrast_period_deg(0), 0);
}

TEST(ImageClarity, HalfTheContrastIsLeftAtItsPeriod) {
    for (const double slope : {1e-4, 2e-3, 0.05}) {
        EXPECT_NEAR(grille_contrast(slope, half_contrast_period_deg(slope)), 0.5, 5e-4);
    }
    EXPECT_NEAR(half_contrast_period_deg(0.002), 1.05, 0.01);
}

}  // namespace
}  // namespace nacre::measure
