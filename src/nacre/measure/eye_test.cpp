#include "nacre/measure/eye.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"

namespace nacre::measure {
namespace {

// colour-science 0.4.7, contrast_sensitivity_function_Barten1999(u, sigma, X_0, E) with sigma and E
// from pupil_diameter_Barten1999(L, X_0), sigma_Barten1999(0.5/60, 0.08/60, d) and
// retinal_illuminance_Barten1999(L, d); all else as it stands there.
TEST(ContrastSensitivity, MatchesAnIndependentImplementation) {
    const struct {
        double luminance, field_deg, frequency, sensitivity;
    } cases[] = {{100, 11.4, 0.5, 243.9532543563694}, {100, 11.4, 4, 674.5861124292278},
                 {100, 11.4, 20, 108.97025452446285}, {100, 11.4, 50, 0.7768302151391533},
                 {0.5, 2, 4, 79.48385929214258},      {0.5, 2, 20, 9.045791983805016},
                 {3e4, 40, 0.5, 329.3604298058985},   {3e4, 40, 20, 173.53129406717028}};
    for (const auto& c : cases) {
        EXPECT_NEAR(contrast_sensitivity(c.frequency, c.luminance, c.field_deg) / c.sensitivity, 1,
                    kContrastSensitivityError)
            << c.luminance << " cd/m^2, " << c.frequency << " per deg";
    }
    EXPECT_NEAR(pupil_diameter_mm(100, 11.4), 3.9541296707276663, 1e-12);
    EXPECT_NEAR(eye_blur_deg(pupil_diameter_mm(0.5, 2)), 0.012980578653167521, 1e-12);
}

TEST(ContrastSensitivity, NothingIsSeenInTheDarkOrWithoutAPattern) {
    EXPECT_EQ(contrast_sensitivity(4, 0, 10), 0);
    EXPECT_EQ(contrast_sensitivity(0, 100, 10), 0);
    EXPECT_NEAR(pupil_diameter_mm(0, 10), 8, 1e-12);
}

// A star of magnitude m gives 2.54e-6 lx 10^(-0.4 m).
double limiting_magnitude(double sky_cd_m2) {
    return -2.5 * std::log10(point_threshold_lx(sky_cd_m2) / 2.54e-6);
}

// What everybody can check: stars of magnitude 6 to 7, less 0.3 for the air, from a dark place,
// whose sky has 60 nL; Venus at magnitude -4.5, and no star, in a bright blue sky.
TEST(PointThreshold, ShowsTheStarsThatAreSeen) {
    const double dark_sky = 60e-5 / 3.14159, blue_sky = 3000;
    EXPECT_GT(limiting_magnitude(dark_sky), 6.3);
    EXPECT_LT(limiting_magnitude(dark_sky), 7.3);
    EXPECT_GT(limiting_magnitude(blue_sky), -4.5);
    EXPECT_LT(limiting_magnitude(blue_sky), -1.5);  // Sirius
}

TEST(PointThreshold, FollowsWebersLawInBrightLight) {
    const double ratio = point_threshold_lx(2e6) / point_threshold_lx(1e6);
    EXPECT_NEAR(ratio, 2, 0.005);
    EXPECT_LT(point_threshold_lx(2) / point_threshold_lx(1), 1.6);
}

TEST(PointThreshold, RisesWithTheBackground) {
    double before = point_threshold_lx(0);
    EXPECT_GT(before, 0);
    for (double background = 1e-6; background < 1e5; background *= 1.1) {
        const double now = point_threshold_lx(background);
        EXPECT_GT(now, before) << background;
        EXPECT_LT(now, 1.2 * before) << background;  // where cones take over it rises at once
        before = now;
    }
}

TEST(Viewing, OutsideItsRangeIsRefused) {
    EXPECT_THROW(check({.distance_mm = 10}), DomainError);
    EXPECT_THROW(check({.illuminance_lx = 0}), DomainError);
    EXPECT_THROW(check({.distance_mm = std::nan("")}), DomainError);
}

}  // namespace
}  // namespace nacre::measure
