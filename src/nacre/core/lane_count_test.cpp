#include "nacre/core/lane_count.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

TEST(LaneCount, EveryCombinationOfLanesIsCountedAndItsFirstFound) {
    for (unsigned bits = 0; bits < 1u << kLanes; ++bits) {
        const IntLanes lanes = make_lanes<IntLanes>([&](int i) { return bits >> i & 1u; });
        EXPECT_EQ(lane_bits(lanes != 0), bits);
        EXPECT_EQ(count_lanes(lanes != 0), std::popcount(bits));
        EXPECT_EQ(first_lane(lanes != 0), bits == 0 ? kLanes : std::countr_zero(bits));
    }
}

}  // namespace
}  // namespace nacre
