#include "nacre/core/memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"

namespace nacre {
namespace {

using test::message_of;

TEST(Memory, WorkThatNeedsMoreThanThereIsIsRefusedAndSaysWhatToDo) {
    EXPECT_NO_THROW(require_memory(1e6, "work", "do less"));
    EXPECT_THAT(message_of<Error>([] { require_memory(1e18, "work", "do less"); }),
                testing::MatchesRegex(
                    "work takes 1000000000.0 GB of memory, and [0-9.]+ GB are free: do less"));
}

}  // namespace
}  // namespace nacre
