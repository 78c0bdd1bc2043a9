#include "nacre/fit/shortfall.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::fit {
namespace {

measure::AngleDifference angle(const Vec3d& standard, const Vec3d& sample, double weight = 1) {
    measure::AngleDifference one;
    one.lab_standard = standard;
    one.lab_sample = sample;
    for (int c = 0; c < 3; ++c) one.delta_lab[c] = sample[c] - standard[c];
    one.weight = weight;
    return one;
}

TEST(Shortfall, NamesTheAttributeThatDiffersWithItsSign) {
    const Vec3d red{40, 30, 40};  // C* = 50
    const struct {
        Vec3d sample;
        Attribute attribute;
        double delta;
    } cases[] = {
        {{30, 30, 40}, Attribute::lightness, -10},
        {{44, 30, 40}, Attribute::lightness, 4},
        {{40, 15, 20}, Attribute::chroma, -25},
        // Turned by the angle of 3-4-5: Delta H* = 2 * 50 sin(h / 2), cos h = 24/25.
        {{40, 40, 30}, Attribute::hue, -100 * std::sqrt((1 - 24.0 / 25) / 2)},
    };
    for (const auto& [sample, attribute, delta] : cases) {
        measure::Difference difference;
        difference.angles = {angle(red, red), angle(red, sample)};
        const std::vector<Shortfall> found = shortfalls(difference);
        ASSERT_EQ(found.size(), 1u) << delta;
        EXPECT_EQ(found[0].attribute, attribute);
        EXPECT_NEAR(found[0].fraction, 1, 1e-9);
        ASSERT_EQ(found[0].angles.size(), 1u);
        EXPECT_EQ(found[0].angles[0].angle, &difference.angles[1]);
        EXPECT_NEAR(found[0].angles[0].delta, delta, 1e-9);
    }
}

TEST(Shortfall, TheLargestComesFirst) {
    measure::Difference difference;
    difference.angles = {angle({40, 30, 40}, {37, 12, 16}), angle({40, 30, 40}, {50, 30, 40}),
                         angle({40, 30, 40}, {90, 30, 40}, 0)};
    const std::vector<Shortfall> found = shortfalls(difference);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].attribute, Attribute::chroma);
    EXPECT_NEAR(found[0].fraction + found[1].fraction, 1, 1e-9);
    ASSERT_EQ(found[1].angles.size(), 2u);  // not that of weight 0
    EXPECT_NEAR(found[1].angles[0].delta, 10, 1e-12);
    EXPECT_NEAR(found[1].angles[1].delta, -3, 1e-12);
}

TEST(Shortfall, GreyAndEqualColoursAreNoDifficulty) {
    measure::Difference difference;
    EXPECT_TRUE(shortfalls(difference).empty());
    difference.angles = {angle({40, 0, 0}, {40, 0, 0})};
    EXPECT_TRUE(shortfalls(difference).empty());
    difference.angles = {angle({40, 0, 0}, {40, 20, 0}), angle({40, 20, 0}, {40, 0, 0})};
    ASSERT_EQ(shortfalls(difference).size(), 1u);
    EXPECT_EQ(shortfalls(difference)[0].attribute, Attribute::chroma);
    // What rounding leaves of a grey has no hue.
    difference.angles = {angle({40, 20, 0}, {40, -1e-13, 1e-13})};
    ASSERT_EQ(shortfalls(difference).size(), 1u);
    EXPECT_EQ(shortfalls(difference)[0].attribute, Attribute::chroma);
}

}  // namespace
}  // namespace nacre::fit
