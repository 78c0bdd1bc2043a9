#include "nacre/measure/flop.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::measure {
namespace {

Measurement read_as(std::initializer_list<std::pair<double, spectra::Vec3>> labs) {
    Measurement m;
    for (const auto& [aspecular, lab] : labs) {
        Reading reading;
        reading.geometry = in_plane(45, aspecular);
        reading.lab = lab;
        m.readings.push_back(reading);
    }
    return m;
}

TEST(FlopIndex, IsTheFormula) {
    // By hand: 2.69 * 100^1.11 / 50^0.86 = 2.69 * 165.959 / 28.913.
    const auto m = read_as({{15, {120, 0, 0}}, {45, {50, 0, 0}}, {110, {20, 0, 0}}});
    EXPECT_NEAR(flop_index(m).value(), 15.44, 0.005);
}

TEST(FlopIndex, OfASolidColourIsZero) {
    EXPECT_EQ(flop_index(read_as({{15, {40, 9, 9}}, {45, {40, 9, 9}}, {110, {40, 9, 9}}})), 0);
}

TEST(FlopIndex, IsEmptyWhereItHasNoValue) {
    EXPECT_FALSE(flop_index({}));
    EXPECT_FALSE(flop_index(read_as({{15, {40, 0, 0}}, {45, {40, 0, 0}}})));
    EXPECT_FALSE(flop_index(read_as({{15, {30, 0, 0}}, {45, {40, 0, 0}}, {110, {40, 0, 0}}})));
    EXPECT_FALSE(flop_index(read_as({{15, {40, 0, 0}}, {45, {0, 0, 0}}, {110, {30, 0, 0}}})));
}

TEST(ColourTravel, AddsStepsInOrderOfTheAngleWhateverTheOrderOfTheFile) {
    auto m = read_as({{110, {0, 3, 4}}, {-15, {0, 0, 0}}, {45, {9, 3, 0}}});
    Reading other;
    other.geometry = in_plane(15, 15);
    other.lab = {0, 99, 99};
    m.readings.push_back(other);
    other.geometry = off_plane(45, 25, 90);
    m.readings.push_back(other);
    const ColourTravel travel = colour_travel(m);
    ASSERT_EQ(travel.path.size(), 3u);
    EXPECT_EQ(travel.path[0]->geometry.name, "45as-15");
    EXPECT_EQ(travel.path[2]->geometry.name, "45as110");
    EXPECT_DOUBLE_EQ(travel.length, 3 + 4);
    EXPECT_EQ(colour_travel(m, 15).path.size(), 1u);
    EXPECT_EQ(colour_travel(m, 15).length, 0);
    EXPECT_TRUE(colour_travel(m, 65).path.empty());
}

}  // namespace
}  // namespace nacre::measure
