#include "nacre/core/estimate.h"

#include <gtest/gtest.h>

#include "nacre/core/error.h"

namespace nacre {
namespace {

TEST(Median, OneWildValueDoesNotMoveIt) {
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({3, 1e9, 2}), 3);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_THROW(median({}), DomainError);
}

}  // namespace
}  // namespace nacre
