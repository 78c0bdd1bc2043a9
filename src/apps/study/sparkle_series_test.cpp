#include "apps/study/sparkle_series.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::study {
namespace {

// Panels that share no flake, so that their errors are independent.
Estimate seen(FlakeParameter parameter, double value, SparkleMeasure measure) {
    const bool diffuse = measure == SparkleMeasure::graininess;
    measure::SparkleCamera camera{.pixel_um = 25, .field_mm = 5};
    camera.lamps_deg = {};
    if (diffuse) {
        camera.diffuse_samples = 8;
    } else {
        camera.lamps_deg = {parameter == FlakeParameter::orientation ? 75.0 : 15.0};
        camera.diffuse_samples = 0;
    }
    const auto seed = static_cast<std::uint64_t>(1e6 * value);
    return reading(look_at(silver_with(parameter, value), camera, seed).readings, measure, 0);
}

// Each by more than four standard errors: chance does so once in 30000 times.
void expect_trend(FlakeParameter parameter, double from, double to, SparkleMeasure measure,
                  Trend trend) {
    const TrendVerdict v =
        judge({seen(parameter, from, measure), seen(parameter, to, measure)}, trend);
    EXPECT_GT(v.change_in_errors, 4) << v.first.value << " +- " << v.first.standard_error << ", "
                                     << v.last.value << " +- " << v.last.standard_error;
    EXPECT_TRUE(v.holds());
}

TEST(SparkleTrend, LargerFlakesSparkleMoreStrongly) {
    expect_trend(FlakeParameter::diameter, 12, 28, SparkleMeasure::intensity, Trend::rises);
}

TEST(SparkleTrend, LargerFlakesAreGrainier) {
    expect_trend(FlakeParameter::diameter, 15, 50, SparkleMeasure::graininess, Trend::rises);
}

TEST(SparkleTrend, FewerFlakesMakeFewerSpots) {
    expect_trend(FlakeParameter::volume, 0.002, 0.02, SparkleMeasure::density, Trend::rises);
}

TEST(SparkleTrend, FewerFlakesAreGrainier) {
    expect_trend(FlakeParameter::volume, 0.004, 0.05, SparkleMeasure::graininess, Trend::falls);
}

TEST(SparkleTrend, DisorderedFlakesSparkleFarFromTheMirrorDirection) {
    expect_trend(FlakeParameter::orientation, 0.1, 0.3, SparkleMeasure::density, Trend::rises);
}

TEST(SparkleTrend, IsJudgedByItsErrors) {
    const std::vector<Estimate> rising = {{1, 0.1}, {2, 0.1}, {1.9, 0.1}, {3, 0.1}};
    EXPECT_TRUE(judge(rising, Trend::rises).holds());
    EXPECT_NEAR(judge(rising, Trend::rises).change_in_errors, 2 / std::sqrt(0.02), 1e-12);
    EXPECT_NEAR(judge(rising, Trend::rises).worst_step_in_errors, -0.1 / std::sqrt(0.02), 1e-12);
    EXPECT_FALSE(judge(rising, Trend::falls).holds());
    EXPECT_FALSE(judge({{1, 1}, {2, 1}}, Trend::rises).holds());
    EXPECT_FALSE(judge({{1, 0.1}, {5, 0.1}, {2, 0.1}}, Trend::rises).holds());
    EXPECT_FALSE(judge({{std::nan(""), 1}, {2, 1}}, Trend::rises).holds());
}

}  // namespace
}  // namespace nacre::study
