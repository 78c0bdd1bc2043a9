#include "nacre/paint/parameter_deviation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/paints.h"

namespace nacre::paint {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

TEST(ParameterDeviation, TextIsReadBackToTheSameNumber) {
    for (const char* text : {"0.002", "5 %", "0.1 %", "7 %", "100 %", "0 %", "12.5 %", "1e-09"}) {
        const ParameterDeviation deviation = parse_deviation("x", text);
        EXPECT_EQ(deviation_text(deviation), text);
        EXPECT_EQ(parse_deviation("x", deviation_text(deviation)), deviation);
    }
    EXPECT_EQ(parse_deviation("x", " 5% "), (ParameterDeviation{"x", 0.05, true}));
    const ParameterDeviation third{"x", 1.0 / 3, true};
    EXPECT_NEAR(parse_deviation("x", deviation_text(third)).amount, 1.0 / 3, 1e-16);
    for (const char* wrong : {"", "%", "five", "5 %%", "nan", "inf", "5 um"}) {
        EXPECT_THAT(message_of<DomainError>([&] { parse_deviation("x", wrong); }),
                    HasSubstr("x = "))
            << wrong;
    }
}

TEST(ParameterDeviation, RelativeOnesAreOfTheRecipesOwnNumber) {
    const Recipe recipe = test::paint_of(1.5, {test::pigment_layer(0.5, 1, -0.2)}, 0.0);
    const std::string thickness = "layer[0].thickness_um";
    EXPECT_DOUBLE_EQ(standard_deviation(recipe, {thickness, 0.05, true}), 5);
    EXPECT_DOUBLE_EQ(standard_deviation(recipe, {thickness, 2, false}), 2);
    EXPECT_DOUBLE_EQ(standard_deviation(recipe, {"layer[0].pigment[0].anisotropy", 0.1, true}),
                     0.02);
    EXPECT_THAT(message_of<DomainError>([&] {
                    check_deviation(recipe, {"substrate.reflectance", 0.1, true});
                }),
                HasSubstr("substrate.reflectance = 10 %: the recipe's own number is 0"));
    EXPECT_NO_THROW(check_deviation(recipe, {"substrate.reflectance", 1}));
    EXPECT_THROW(check_deviation(recipe, {"substrate.reflectance", 1.1}), DomainError);
    EXPECT_THROW(check_deviation(recipe, {thickness, -1}), DomainError);
    EXPECT_THROW(check_deviation(recipe, {"layer[1].thickness_um", 1}), DomainError);
}

TEST(ParameterDeviation, ChangesReplaceThoseOfTheSameNumber) {
    const std::vector<ParameterDeviation> known = {{"a", 1}, {"b", 2}};
    EXPECT_EQ(with_deviations(known, {{"c", 3}, {"a", 0.1, true}}),
              (std::vector<ParameterDeviation>{{"a", 0.1, true}, {"b", 2}, {"c", 3}}));
}

}  // namespace
}  // namespace nacre::paint
