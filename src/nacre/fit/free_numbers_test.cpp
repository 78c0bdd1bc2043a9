#include "nacre/fit/free_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/fit.h"

namespace nacre::fit {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

const std::string kCoat = "layer[0].flakes[0].coats[0].";

TEST(FreeNumbers, PlacesBetweenTheBoundsComeBack) {
    const FreeNumber by_ratio{{"x", 20, 180}, 60, true}, by_value{{"x", 0, 50}, 10, true};
    EXPECT_NEAR(by_ratio.to_unit(60), 0.5, 1e-15);  // the geometric mean
    EXPECT_NEAR(by_value.to_unit(10), 0.2, 1e-15);
    for (const FreeNumber& number : {by_ratio, by_value}) {
        EXPECT_EQ(number.from_unit(0), number.bounds.lo);
        EXPECT_EQ(number.from_unit(1), number.bounds.hi);
        for (double x : {0.1, 0.5, 0.93}) {
            EXPECT_NEAR(number.to_unit(number.from_unit(x)), x, 1e-14);
            const double h = 1e-6;
            EXPECT_NEAR(number.slope(x),
                        (number.from_unit(x + h) - number.from_unit(x - h)) / (2 * h),
                        1e-6 * number.slope(x));
        }
    }
}

// From 0 to far above the start: even steps would leave no room for the small values.
TEST(FreeNumbers, LongWaysFromZeroAreSpreadAsLogarithmsAre) {
    const FreeNumber from_start{{"x", 0, 300}, 3, true}, from_nothing{{"x", 0, 300}, 0, true};
    for (const FreeNumber& number : {from_start, from_nothing}) {
        EXPECT_EQ(number.to_unit(0), 0);
        EXPECT_EQ(number.from_unit(0), 0);
        EXPECT_EQ(number.from_unit(1), 300);
        EXPECT_NEAR(number.to_unit(27), std::log(10) / std::log(101), 1e-12);  // size 3
        for (double x : {0.001, 0.1, 0.5, 0.93}) {
            EXPECT_NEAR(number.to_unit(number.from_unit(x)), x, 1e-12);
            const double h = 1e-6;
            EXPECT_NEAR(number.slope(x),
                        (number.from_unit(x + h) - number.from_unit(x - h)) / (2 * h),
                        1e-6 * number.slope(x));
        }
    }
}

TEST(FreeNumbers, DefaultBoundsFollowTheKindOfNumber) {
    const paint::Recipe recipe = testing::pearl(80);
    const auto bounds = [&](const std::string& key) { return default_bounds(recipe, key); };
    EXPECT_NEAR(bounds(kCoat + "thickness_nm").lo, 80 / 3.0, 1e-12);
    EXPECT_NEAR(bounds(kCoat + "thickness_nm").hi, 240, 1e-12);
    EXPECT_EQ(bounds(kCoat + "spread_nm").lo, 0);
    EXPECT_NEAR(bounds(kCoat + "spread_nm").hi, 18, 1e-12);                   // three times 6
    EXPECT_NEAR(bounds("layer[0].flakes[0].core.spread_nm").hi, 240, 1e-12);  // three times 80
    EXPECT_EQ(bounds("substrate.reflectance").lo, 0);
    EXPECT_EQ(bounds("substrate.reflectance").hi, 1);
    EXPECT_NEAR(bounds("ior").hi, 1.65, 1e-12);  // 10 % above 1.5
}

TEST(FreeNumbers, DefaultBoundsStayWithinWhatTheKeyMayBe) {
    paint::Recipe recipe = testing::pearl(80);
    const std::string spread = "layer[0].flakes[0].core.spread_nm";
    paint::set_parameter(recipe, spread, 5e4);
    EXPECT_EQ(default_bounds(recipe, spread).hi, paint::find_parameter(recipe, spread).range.hi);
    EXPECT_NO_THROW(FreeNumbers(recipe, {spread}, {}));
    // A coat is at least three times as thick as its spread.
    recipe.clearcoat = paint::Clearcoat{.thickness_um = 40, .thickness_spread_um = 8};
    EXPECT_NEAR(default_bounds(recipe, "clearcoat.thickness_um").lo, 24, 1e-9);
}

TEST(FreeNumbers, ASizeOfZeroHasNoDefaultBounds) {
    paint::Recipe recipe = testing::solid();
    std::get<paint::PigmentCoefficients>(recipe.layers[0].pigments[0].body).scattering_per_mm = 0.0;
    const std::string key = "layer[0].pigment[0].scattering_per_mm";
    const std::string message = message_of<DomainError>([&] { default_bounds(recipe, key); });
    EXPECT_THAT(message, HasSubstr(key + " = 0: has no size"));
    EXPECT_THAT(message, HasSubstr("[fit]"));
    EXPECT_NO_THROW(FreeNumbers(recipe, {key}, {{key, 0, 100}}));
}

TEST(FreeNumbers, BuildTheRecipeAtAPoint) {
    const std::string film = kCoat + "thickness_nm", alpha = "layer[0].flakes[0].orientation.alpha";
    const FreeNumbers numbers(testing::pearl(80), {film, alpha}, {{film, 60, 140}});
    EXPECT_TRUE(numbers[0].bounds_given);
    EXPECT_FALSE(numbers[1].bounds_given);
    const paint::Recipe recipe = numbers.at(std::vector<double>{1.0, 0.5});
    EXPECT_EQ(paint::find_parameter(recipe, film).value, 140);
    EXPECT_NEAR(paint::find_parameter(recipe, alpha).value, 0.25, 1e-12);
    EXPECT_NEAR(numbers.start_point()[1], 0.5, 1e-12);
}

TEST(FreeNumbers, RefusesWhatCannotBeFree) {
    const paint::Recipe recipe = testing::pearl();
    EXPECT_THROW(FreeNumbers(recipe, {}, {}), DomainError);
    EXPECT_THROW(FreeNumbers(recipe, {"layer[0].thickness_um", "layer[0].thickness_um"}, {}),
                 DomainError);
    EXPECT_THROW(FreeNumbers(recipe, {"layer[7].thickness_um"}, {}), DomainError);
    EXPECT_THROW(FreeNumbers(recipe, std::vector<std::string>(25, "ior"), {}), DomainError);
}

}  // namespace
}  // namespace nacre::fit
