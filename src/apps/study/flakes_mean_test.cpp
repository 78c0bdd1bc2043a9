#include "apps/study/flakes_mean.h"

#include <gtest/gtest.h>

namespace nacre::study {
namespace {

// Dense opaque flakes as wide as the layer is thick: 2 to 3 % of standard error in each direction
// here, of which four would be 12 %. What is compared is the mean over the six directions, whose
// errors share walks but hardly any flakes.
TEST(MeanOfDiscs, IsThatOfTheHotSpotWithItsLightTakenFromMultipleScattering) {
    double transfer = 0, gain_only = 0, nacre = 0, variance = 0;
    const auto exits = compare_means({}, 20, 400000, 1);
    const auto count = static_cast<double>(exits.size());
    for (const MeanRatios& exit : exits) {
        transfer += exit.transfer.value / count;
        gain_only += exit.gain_only.value / count;
        nacre += exit.nacre.value / count;
        variance += exit.nacre.standard_error * exit.nacre.standard_error / (count * count);
    }
    const double error = std::sqrt(variance);
    EXPECT_LT(error, 0.012);
    EXPECT_NEAR(nacre, 1, 0.02 + 3 * error);
    EXPECT_GT(gain_only, 1.06 + 3 * error);
    EXPECT_LT(transfer, 0.8);
    // In the mirror direction, where nearly all light has met one flake.
    EXPECT_NEAR(exits[0].nacre.value, 1, 0.02 + 3 * exits[0].nacre.standard_error);
    EXPECT_LT(exits[0].transfer.value, 0.75);
}

// With the lobe of the interface left out of both.
TEST(MeanOfDiscs, UnderARoughClearcoatIsThatOfTheHotSpotToo) {
    const auto exits = compare_means({.roughness = 0.2}, 45, 300000, 3);
    // The mirror direction, beyond it, before it, and beside it.
    for (std::size_t e = 0; e < 4; ++e) {
        const MeanRatios& exit = exits[e];
        EXPECT_LT(exit.nacre.standard_error, 0.03);
        EXPECT_NEAR(exit.nacre.value, 1, 0.04 + 3 * exit.nacre.standard_error)
            << exit.theta_deg << ", " << exit.phi_deg;
        EXPECT_LT(exit.transfer.value, 0.85);
    }
}

TEST(MeanOfDiscs, OfTranslucentFlakesOverABrightGroundIsThatOfTheHotSpot) {
    const MeanCase paint{.depth = 1,
                         .diameter_um = 30,
                         .alpha = 0.2,
                         .reflectance = 0.4,
                         .transmittance = 0.5,
                         .ground = 0.8};
    for (const MeanRatios& exit : compare_means(paint, 45, 300000, 2)) {
        EXPECT_NEAR(exit.nacre.value, 1, 0.03 + 4 * exit.nacre.standard_error)
            << exit.theta_deg << ", " << exit.phi_deg;
    }
}

}  // namespace
}  // namespace nacre::study
