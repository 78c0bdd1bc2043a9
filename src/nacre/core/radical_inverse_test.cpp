#include "nacre/core/radical_inverse.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

TEST(RadicalInverse, MirrorsDigitsAtThePoint) {
    EXPECT_EQ(radical_inverse(0, 2), 0);
    EXPECT_EQ(radical_inverse(1, 2), 0.5);
    EXPECT_EQ(radical_inverse(6, 2), 0.375);                       // 110 -> 0.011
    EXPECT_NEAR(radical_inverse(7, 3), 1 / 3.0 + 2 / 9.0, 1e-15);  // 21 -> 0.12
}

// Any b^k indices in a row from a multiple of b^k on fall into different intervals of b^-k.
TEST(RadicalInverse, FillsTheIntervalEvenly) {
    constexpr unsigned kBase = 5, kCount = 125;
    bool taken[kCount] = {};
    for (unsigned i = 0; i < kCount; ++i) {
        // 3/5^4 above the interval's lower end: rounding does not reach it.
        const auto cell = static_cast<unsigned>(radical_inverse(3 * kCount + i, kBase) * kCount);
        ASSERT_LT(cell, kCount);
        EXPECT_FALSE(taken[cell]) << i;
        taken[cell] = true;
    }
}

}  // namespace
}  // namespace nacre
