#include "apps/study/sparkle_series.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::study {
namespace {

// Panels that share no flake, so that their errors are independent.
Estimate seen(FlakeParameter parameter, double value, SparkleMeasure measure,
              double lamp_deg = 15) {
    const bool diffuse = measure == SparkleMeasure::graininess;
    // Fine flakes are many: a smaller panel will do.
    const bool fine = parameter == FlakeParameter::diameter && value < 12;
    measure::SparkleCamera camera{.pixel_um = 25, .field_mm = fine ? 3.0 : 5.0};
    camera.lamps_deg = {};
    if (diffuse) {
        camera.diffuse_samples = 8;
    } else {
        camera.lamps_deg = {lamp_deg};
        camera.diffuse_samples = 0;
    }
    const auto seed = static_cast<std::uint64_t>(1e6 * value);
    return reading(look_at(silver_with(parameter, value), camera, seed).readings, measure, 0);
}

// Each by more than four standard errors: chance does so once in 30000 times.
void expect_trend(FlakeParameter parameter, double from, double to, SparkleMeasure measure,
                  Trend trend, double lamp_deg = 15) {
    const TrendVerdict v = judge(
        {seen(parameter, from, measure, lamp_deg), seen(parameter, to, measure, lamp_deg)}, trend);
    EXPECT_GT(v.change_in_errors, 4) << v.first.value << " +- " << v.first.standard_error << ", "
                                     << v.last.value << " +- " << v.last.standard_error;
    EXPECT_TRUE(v.holds());
}

TEST(SparkleTrend, LargerFlakesSparkleMoreStrongly) {
    expect_trend(FlakeParameter::diameter, 12, 28, SparkleMeasure::intensity, Trend::rises);
}

// At equal volume. Of flat flakes it falls from 18 to 72 um, from 680 to 70 and from 470 to nothing.
//                                                                               [docs/sparkle.md]
TEST(SparkleTrend, LargerFlakesSparkleMore) {
    for (const double lamp_deg : {15.0, 45.0}) {
        for (const double from_um : {9.0, 18.0}) {
            SCOPED_TRACE(testing::Message() << from_um << " um, lamp at " << lamp_deg << " deg");
            expect_trend(FlakeParameter::diameter, from_um, 4 * from_um, SparkleMeasure::sparkle,
                         Trend::rises, lamp_deg);
        }
    }
}

// "The finer grades of metallic coatings do not show sparkle" under an intense spot light: flat
// flakes of 9 um have 400.                                                     [kirchner-2015]
TEST(SparkleTrend, FineFlakesHardlySparkle) {
    EXPECT_LT(seen(FlakeParameter::diameter, 9, SparkleMeasure::sparkle).value, 30);
}

TEST(SparkleTrend, LargerFlakesAreGrainier) {
    expect_trend(FlakeParameter::diameter, 15, 50, SparkleMeasure::graininess, Trend::rises);
}

TEST(SparkleTrend, FewerFlakesMakeFewerSpots) {
    expect_trend(FlakeParameter::volume, 0.0002, 0.02, SparkleMeasure::density, Trend::rises);
}

TEST(SparkleTrend, FewerFlakesAreGrainier) {
    expect_trend(FlakeParameter::volume, 0.004, 0.05, SparkleMeasure::graininess, Trend::falls);
}

TEST(SparkleTrend, DisorderedFlakesSparkleFarFromTheMirrorDirection) {
    expect_trend(FlakeParameter::orientation, 0.1, 0.3, SparkleMeasure::density, Trend::rises, 75);
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
