#include "nacre/sparkle/lane_bits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/random.h"

namespace nacre::sparkle {
namespace {

TEST(SlopeLanes, BitsAreMixedAsNumbersAre) {
    const BitLanes bits = {0, 1, 2, 77, ~0ull, 1ull << 63, 0xdeadbeefull, 42};
    const BitLanes mixed = mix_bits(bits);
    for (int i = 0; i < kLanes; ++i) EXPECT_EQ(mixed[i], mix_bits(bits[i]));
}

TEST(SlopeLanes, SlopesAreGaussian) {
    constexpr int kCount = 200000;
    double x = 0, x2 = 0, x4 = 0, y2 = 0, xy = 0;
    for (int i = 0; i < kCount / kLanes; ++i) {
        BitLanes bits;
        for (int k = 0; k < kLanes; ++k) bits[k] = hash_of(i, k);
        const SlopeLanes s = gaussian_slopes(bits);
        for (int k = 0; k < kLanes; ++k) {
            x += s.x[k];
            x2 += s.x[k] * s.x[k];
            x4 += std::pow(s.x[k], 4);
            y2 += s.y[k] * s.y[k];
            xy += s.x[k] * s.y[k];
        }
    }
    // Of exp(-x^2) / sqrt(pi): variance 1/2, fourth moment 3/4, eighth 105/16.
    EXPECT_NEAR(x / kCount, 0, 4 * std::sqrt(0.5 / kCount));
    EXPECT_NEAR(x2 / kCount, 0.5, 4 * std::sqrt(0.5 / kCount));
    EXPECT_NEAR(y2 / kCount, 0.5, 4 * std::sqrt(0.5 / kCount));
    EXPECT_NEAR(xy / kCount, 0, 4 * std::sqrt(0.25 / kCount));
    EXPECT_NEAR(x4 / kCount, 0.75, 4 * std::sqrt((105.0 / 16 - 9.0 / 16) / kCount));
}

}  // namespace
}  // namespace nacre::sparkle
