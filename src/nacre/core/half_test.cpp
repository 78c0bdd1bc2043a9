#include "nacre/core/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace nacre {
namespace {

TEST(Half, EveryValueComesBack) {
    int finite = 0;
    for (unsigned bits = 0; bits < 0x10000u; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        if (!is_finite_half(half)) continue;
        ++finite;
        EXPECT_EQ(half_bits(half_value(half)), half) << bits;
    }
    EXPECT_EQ(finite, 2 * 31 * 1024);
}

TEST(Half, RoundsToTheNearestAndToEvenBetween) {
    const auto rounded = [](float x) { return half_value(half_bits(x)); };
    EXPECT_EQ(rounded(1 + 0x1p-11f), 1.0f);
    EXPECT_EQ(rounded(1 + 0x1.8p-10f), 1 + 0x1p-9f);
    EXPECT_EQ(rounded(1 + 0x1.2p-11f), 1 + 0x1p-10f);
    EXPECT_EQ(rounded(0x1p-25f), 0.0f);
    EXPECT_EQ(rounded(0x1.8p-24f), 0x1p-23f);
    EXPECT_EQ(rounded(-0x1.4p-24f), -0x1p-24f);
    EXPECT_EQ(rounded(65519.0f), 65504.0f);
}

TEST(Half, WhatIsTooLargeIsInfinite) {
    EXPECT_FALSE(is_finite_half(half_bits(65520.0f)));
    EXPECT_TRUE(std::isinf(half_value(half_bits(1e9f))));
    EXPECT_TRUE(std::isnan(half_value(half_bits(std::numeric_limits<float>::quiet_NaN()))));
}

}  // namespace
}  // namespace nacre
