#include "nacre/sparkle/lane_bits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

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

// All of the 256 sets of lanes.
TEST(LaneBits, SetLanesAreVisitedAndPackedInOrder) {
    const FloatLanes numbers = {10, 11, 12, 13, 14, 15, 16, 17};
    const UintLanes bits = {20, 21, 22, 23, 24, 25, 26, 27};
    for (unsigned set = 0; set < 1u << kLanes; ++set) {
        LaneMask mask;
        std::vector<int> expected, visited;
        for (int lane = 0; lane < kLanes; ++lane) {
            mask[lane] = set >> lane & 1 ? -1 : 0;
            if (mask[lane]) expected.push_back(lane);
        }
        EXPECT_EQ(lane_bits(mask), set);
        for_each_set_lane(mask, [&](int lane) { visited.push_back(lane); });
        EXPECT_EQ(visited, expected);
        const LanePacker packer(mask);
        ASSERT_EQ(packer.count(), static_cast<int>(expected.size()));
        std::array<float, kLanes> packed;
        std::array<std::uint32_t, kLanes> packed_bits;
        packer.store(packed.data(), numbers);
        packer.store(packed_bits.data(), bits);
        for (std::size_t n = 0; n < expected.size(); ++n) {
            EXPECT_EQ(packed[n], numbers[expected[n]]) << set;
            EXPECT_EQ(packed_bits[n], bits[expected[n]]) << set;
        }
    }
}

TEST(LaneBits, LanesArePickedFromEight) {
    const FloatLanes eight = {10, 11, 12, 13, 14, 15, 16, 17};
    const IntLanes at = {7, 0, 3, 3, 1, 6, 2, 5};
    const FloatLanes picked = pick_lanes(eight, at);
    for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(picked[lane], eight[at[lane]]);
}

}  // namespace
}  // namespace nacre::sparkle
