#include "nacre/fit/halton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"

namespace nacre::fit {
namespace {

// In base 2 any 64 consecutive points fall one each into 64 equal pieces, in base 3 any 81: what a
// shift leaves is that no piece has more than two and gaps are at most two pieces wide.
TEST(Halton, FillsEveryAxisEvenly) {
    const auto points = halton_points(64, 2, 7);
    std::vector<double> along;
    for (const auto& point : points) along.push_back(point[0]);
    std::sort(along.begin(), along.end());
    EXPECT_GE(along.front(), 0);
    EXPECT_LT(along.back(), 1);
    for (std::size_t i = 1; i < along.size(); ++i) EXPECT_LE(along[i] - along[i - 1], 2.0 / 64);
}

TEST(Halton, IsShiftedByTheSeedAndByNothingElse) {
    EXPECT_EQ(halton_points(5, 3, 1), halton_points(5, 3, 1));
    const auto a = halton_points(2, 1, 1), b = halton_points(2, 1, 2);
    EXPECT_NE(a, b);
    // 1/2 and 1/4, shifted.
    const double step = a[0][0] - a[1][0];
    EXPECT_NEAR(step - std::floor(step), 0.25, 1e-15);
}

TEST(Halton, RefusesDimensionsWithoutABase) {
    EXPECT_THROW(halton_points(1, 0, 0), DomainError);
    EXPECT_THROW(halton_points(1, 25, 0), DomainError);
}

}  // namespace
}  // namespace nacre::fit
