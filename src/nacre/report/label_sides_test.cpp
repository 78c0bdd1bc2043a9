#include "nacre/report/label_sides.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace nacre::report {
namespace {

using testing::ElementsAre;

// Sides: 0 right, 2 below, 4 left, 6 above.
TEST(LabelSides, AreOnTheOuterSideOfACurve) {
    // A hill, y downwards on the screen: labels above and beside it, whichever way one walks.
    const std::vector<Pixel> hill = {{0, 100}, {50, 0}, {100, 100}};
    EXPECT_THAT(label_sides(hill), ElementsAre(5, 6, 7));
    const std::vector<Pixel> back(hill.rbegin(), hill.rend());
    EXPECT_THAT(label_sides(back), ElementsAre(7, 6, 5));
    const std::vector<Pixel> valley = {{0, 0}, {50, 100}, {100, 0}};
    EXPECT_THAT(label_sides(valley), ElementsAre(3, 2, 1));
}

TEST(LabelSides, OfStraightLinesAndSinglePointsAreAbove) {
    EXPECT_THAT(label_sides(std::vector<Pixel>{{0, 0}, {10, 0}, {20, 0}}), ElementsAre(6, 6, 6));
    EXPECT_THAT(label_sides(std::vector<Pixel>{{5, 5}}), ElementsAre(7));
    EXPECT_TRUE(label_sides(std::vector<Pixel>{}).empty());
}

TEST(LabelSides, PointsThatCannotBeShownHaveNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Plot plot{
        .series = {{.x = {0, 1, 2}, .y = {0, nan, 0}, .point_labels = {"a", "b", "c"}}}};
    const std::vector<int> sides = label_sides(plot, extents(plot), plot.series[0]);
    EXPECT_EQ(sides[1], -1);
    EXPECT_GE(sides[0], 0);
    EXPECT_LT(sides[2], 8);
}

TEST(LabelSides, TheNameOfALineStandsRightOfItsEnd) {
    Plot plot{.series = {{.x = {0, 1, 2}, .y = {0, 3, 9}, .point_labels = {"", "", "c"}}}};
    EXPECT_EQ(label_sides(plot, extents(plot), plot.series[0])[2], 0);
    plot.series[0].point_labels[0] = "a";
    EXPECT_NE(label_sides(plot, extents(plot), plot.series[0])[2], 0);
}

}  // namespace
}  // namespace nacre::report
