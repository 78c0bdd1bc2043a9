#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "nacre/api/paint_test_support.h"
#include "nacre/testing/errors.h"

namespace nacre {
namespace {

using test::message_of;
using ::testing::HasSubstr;

TEST(Fit, FindsThePaintThatTheStandardWasMeasuredOn) {
    const Measurement standard = fit::testing::read(fit::testing::pearl(110));
    const Paint start(fit::testing::pearl(90),
                      {{"layer[0].flakes[0].coats[0].thickness_nm", 60, 160}});
    FitSettings settings;
    settings.starts = 1;
    const Match match = start.fit(standard, {}, settings);
    ASSERT_EQ(match.parameters.size(), 1u);
    EXPECT_NEAR(match.parameters[0].value, 110, 0.1);
    EXPECT_EQ(match.paint.recipe(), match.recipe);
    EXPECT_EQ(match.paint.bounds(), start.bounds());
    EXPECT_EQ(start.free_keys({"*thickness_nm"}).keys.size(), 2u);
    EXPECT_THAT(message_of<SettingError>([] { Paint(fit::testing::pearl()).free_keys({}); }),
                HasSubstr("[fit]"));
}

TEST(Fit, StopsWhenAskedTo) {
    const Measurement standard = fit::testing::read(fit::testing::pearl(110));
    EXPECT_THROW(Paint(fit::testing::pearl())
                     .fit(standard, {"coats[0].thickness_nm"}, {}, [](double) { return false; }),
                 Stopped);
}

TEST(Fit, SeesTheHotSpotOfTheModelThatHasOne) {
    EXPECT_TRUE(Model(NacreModel{.specimen = 2}).shows_hot_spot());
    EXPECT_FALSE(Model(NacreModel{.hot_spot = false}).shows_hot_spot());
    EXPECT_FALSE(Model(MicroflakeModel{}).shows_hot_spot());
}

TEST(Fit, RefusesAModelThatHasNoPartInIt) {
    const Paint pearl(fit::testing::pearl());
    const Paint colours = open_text(pearl.measure(geometries("45as15")).csv(), "a.csv");
    EXPECT_EQ(message_of<SettingError>([&] { require_part_in_fit(WalkModel{}, colours); }),
              "model = walk: a.csv is measured, and the paint that is sought is seen by nacre or "
              "microflake");
    require_part_in_fit(NacreModel{}, colours);
    require_part_in_fit(MicroflakeModel{}, colours);
    require_part_in_fit(WalkModel{}, pearl);  // sees the standard
}

}  // namespace
}  // namespace nacre
