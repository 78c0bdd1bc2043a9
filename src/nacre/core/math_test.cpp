#include "nacre/core/math.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

TEST(WrappedDeg, IsTheSameDirectionAndNever360) {
    EXPECT_EQ(wrapped_deg(0), 0);
    EXPECT_EQ(wrapped_deg(359.5), 359.5);
    EXPECT_EQ(wrapped_deg(360), 0);
    EXPECT_EQ(wrapped_deg(725), 5);
    EXPECT_EQ(wrapped_deg(-90), 270);
    EXPECT_EQ(wrapped_deg(-450), 270);
    EXPECT_EQ(wrapped_deg(-1e-20), 0);
}

}  // namespace
}  // namespace nacre
