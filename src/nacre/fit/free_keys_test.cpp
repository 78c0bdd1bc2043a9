#include "nacre/fit/free_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/fit.h"

namespace nacre::fit {
namespace {

using nacre::test::message_of;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kDiameter = "layer[0].flakes[0].diameter_um";

std::vector<std::string> skipped_keys(const FreeKeys& free) {
    std::vector<std::string> keys;
    for (const SkippedNumber& skipped : free.skipped) keys.push_back(skipped.key);
    return keys;
}

TEST(FreeKeys, PatternsPassOverWhatCannotBeFree) {
    const paint::Recipe recipe = testing::pearl();
    const FreeKeys all = free_keys(recipe, {"*"}, {}, false);
    EXPECT_THAT(all.keys, Contains("layer[0].flakes[0].coats[0].thickness_nm"));
    EXPECT_THAT(all.keys, Not(Contains(kDiameter)));
    EXPECT_THAT(all.skipped,
                Contains(::testing::AllOf(Field(&SkippedNumber::key, kDiameter),
                                          Field(&SkippedNumber::why, HasSubstr("colours")))));
    EXPECT_EQ(all.keys.size() + all.skipped.size(), paint::recipe_parameters(recipe).size());
    // What is left can be fitted.
    EXPECT_NO_THROW(FreeNumbers(recipe, all.keys, {}));
    // The hot spot sees sizes.
    EXPECT_THAT(free_keys(recipe, {"*"}, {}, true).keys, Contains(kDiameter));
}

TEST(FreeKeys, ZerosAreFreeWhereBoundsAreGiven) {
    paint::Recipe recipe = testing::solid();
    const std::string key = "layer[0].pigment[0].scattering_per_mm";
    paint::set_parameter(recipe, key, 0);
    const FreeKeys free = free_keys(recipe, {"*_per_mm*"}, {}, false);
    ASSERT_THAT(skipped_keys(free), ElementsAre(key));
    EXPECT_THAT(free.skipped[0].why, HasSubstr("has no size"));
    EXPECT_THAT(free_keys(recipe, {"*_per_mm*"}, {{key, 0, 100}}, false).skipped, IsEmpty());
}

TEST(FreeKeys, WhatIsNamedInFullIsTakenAsItIs) {
    const FreeKeys free =
        free_keys(testing::pearl(), {"*diameter*", kDiameter, "alpha"}, {}, false);
    EXPECT_THAT(free.keys, ElementsAre(kDiameter, "layer[0].flakes[0].orientation.alpha"));
    EXPECT_THAT(skipped_keys(free), Not(Contains(kDiameter)));
}

TEST(FreeKeys, NothingThatCanBeFreeIsAnError) {
    EXPECT_THAT(
        message_of<DomainError>([] { free_keys(testing::pearl(), {"*diameter_um"}, {}, false); }),
        HasSubstr("none of the 1 numbers"));
    EXPECT_THAT(message_of<DomainError>([] { free_keys(testing::pearl(), {"alhpa"}, {}, false); }),
                HasSubstr("is not a number of this recipe"));
    EXPECT_THROW(free_keys(testing::pearl(), {"*"}, {}, false, [](double) { return false; }),
                 Error);
}

}  // namespace
}  // namespace nacre::fit
