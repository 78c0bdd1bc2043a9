#include "apps/report/plot_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace nacre::report {
namespace {

std::vector<std::string> numbers(const std::vector<Tick>& ticks) {
    std::vector<std::string> texts;
    for (const Tick& tick : ticks) {
        if (!tick.text.empty()) texts.push_back(tick.text);
    }
    return texts;
}

TEST(Ticks, StandAtMultiplesOfOneTwoOrFive) {
    using testing::ElementsAre;
    EXPECT_THAT(numbers(linear_ticks(0, 10, 5)), ElementsAre("0", "2", "4", "6", "8", "10"));
    EXPECT_THAT(numbers(linear_ticks(400, 700, 6)),
                ElementsAre("400", "450", "500", "550", "600", "650", "700"));
    EXPECT_THAT(numbers(linear_ticks(-1, 1, 4)), ElementsAre("−1.0", "−0.5", "0.0", "0.5", "1.0"));
    EXPECT_THAT(numbers(linear_ticks(-15, 110, 5)),
                ElementsAre("0", "20", "40", "60", "80", "100"));
}

TEST(Ticks, LargeAndSmallNumbersHavePowersOfTen) {
    using testing::ElementsAre;
    EXPECT_THAT(numbers(linear_ticks(0, 3e6, 3)), ElementsAre("0", "10⁶", "2·10⁶", "3·10⁶"));
    EXPECT_THAT(numbers(linear_ticks(0, 2e-7, 2)), ElementsAre("0", "10⁻⁷", "2·10⁻⁷"));
    EXPECT_THAT(numbers(linear_ticks(-1.5e150, 0, 3)),
                ElementsAre("−1.5·10¹⁵⁰", "−10¹⁵⁰", "−5·10¹⁴⁹", "0"));
    // Enough digits to tell them apart.
    EXPECT_THAT(numbers(linear_ticks(1e9, 1e9 + 2, 2)),
                ElementsAre("10⁹", "1.000000001·10⁹", "1.000000002·10⁹"));
}

TEST(Ticks, OfALogarithmicAxisAreThePowersOfTen) {
    using testing::ElementsAre;
    EXPECT_THAT(numbers(logarithmic_ticks(1, 1000, 4)), ElementsAre("1", "10", "100", "1000"));
    EXPECT_EQ(logarithmic_ticks(1, 1000, 4).size(), 28u);  // lines at all other digits
    EXPECT_THAT(numbers(logarithmic_ticks(1e-3, 1000, 4)),
                ElementsAre("0.001", "0.01", "0.1", "1", "10", "100", "1000"));
    EXPECT_THAT(numbers(logarithmic_ticks(0.1, 10, 8)),
                ElementsAre("0.1", "0.2", "0.5", "1", "2", "5", "10"));
    // Within a decade those of a linear axis; over many only some.
    EXPECT_THAT(numbers(logarithmic_ticks(2, 6, 4)), ElementsAre("2", "3", "4", "5", "6"));
    EXPECT_THAT(numbers(logarithmic_ticks(1e-100, 1e100, 4)),
                ElementsAre("10⁻¹⁰⁰", "10⁻⁵⁰", "1", "10⁵⁰", "10¹⁰⁰"));
}

TEST(Ticks, AreFewDistinctAndOnTheAxisWhateverItsEnds) {
    int axes = 0;
    for (const double lo : {-1e150, -1e6, -3.0, 0.0, 1e-300, 1e-9, 0.1, 7.0, 1e15, 1e149}) {
        for (const double length : {1e-301, 1e-10, 1e-3, 1.0, 47.0, 1e5, 1e150}) {
            const double hi = lo + length;
            if (!(lo < hi)) continue;
            ++axes;
            for (const bool logarithmic : {false, true}) {
                if (logarithmic && lo <= 0) continue;
                const auto ticks =
                    logarithmic ? logarithmic_ticks(lo, hi, 6) : linear_ticks(lo, hi, 6);
                EXPECT_LE(ticks.size(), 100u) << lo << " " << hi;
                std::set<std::string> texts;
                for (const Tick& tick : ticks) {
                    EXPECT_GE(tick.value, lo - 1e-8 * length) << lo << " " << hi;
                    EXPECT_LE(tick.value, hi + 1e-8 * length) << lo << " " << hi;
                    if (!tick.text.empty()) {
                        EXPECT_TRUE(texts.insert(tick.text).second) << tick.text;
                    }
                }
            }
        }
    }
    EXPECT_GT(axes, 40);
}

TEST(Ticks, RoundedEndsAreTicks) {
    const Extent extent = rounded({0.3, 9.7, true}, 5);
    EXPECT_EQ(extent.lo, 0);
    EXPECT_EQ(extent.hi, 10);
    const Extent kept = rounded({0.3, 9.7, false}, 5);
    EXPECT_EQ(kept.lo, 0.3);
    EXPECT_EQ(kept.hi, 9.7);
}

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

}  // namespace
}  // namespace nacre::report
