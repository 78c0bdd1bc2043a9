#include "nacre/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "nacre/core/error.h"

namespace nacre {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnce) {
    std::vector<std::atomic<int>> visits(1000);
    parallel_for(10, 1000, [&](std::size_t i) { ++visits[i]; });
    for (std::size_t i = 0; i < visits.size(); ++i) EXPECT_EQ(visits[i], i >= 10 ? 1 : 0) << i;
}

TEST(ParallelFor, RangesCoverTheWholeAndRespectTheGrain) {
    std::vector<std::atomic<int>> visits(1000);
    std::atomic<std::size_t> longest = 0;
    parallel_for_ranges(0, 1000, 64, [&](std::size_t first, std::size_t last) {
        std::size_t seen = longest;
        while (last - first > seen && !longest.compare_exchange_weak(seen, last - first)) {
        }
        for (std::size_t i = first; i < last; ++i) ++visits[i];
    });
    for (auto& v : visits) EXPECT_EQ(v, 1);
    EXPECT_LE(longest, 64u);
    EXPECT_GT(longest, 0u);
}

TEST(ParallelFor, EmptyAndReversedRangesDoNothing) {
    int calls = 0;
    parallel_for(5, 5, [&](std::size_t) { ++calls; });
    parallel_for(6, 5, [&](std::size_t) { ++calls; });
    parallel_for_ranges(6, 5, 1, [&](std::size_t, std::size_t) { ++calls; });
    EXPECT_EQ(calls, 0);
}

TEST(ParallelFor, ExceptionsReachTheCaller) {
    EXPECT_THROW(parallel_for(0, 100,
                              [](std::size_t i) {
                                  if (i == 42) throw std::runtime_error("42");
                              }),
                 std::runtime_error);
}

TEST(ParallelFor, InsideOfAnotherGoesToItsEndThoughThatIsGivenUp) {
    std::atomic<int> cut_short = 0;
    for (int round = 0; round < 300; ++round) {
        EXPECT_THROW(parallel_for(0, 16,
                                  [&](std::size_t i) {
                                      if (i == 15) throw Error("given up");
                                      std::atomic<int> visited = 0;
                                      parallel_for(0, 500, [&](std::size_t) { ++visited; });
                                      if (visited != 500) ++cut_short;
                                  }),
                     Error);
    }
    EXPECT_EQ(cut_short, 0);
}

TEST(ThreadLimit, HoldsWhileItLives) {
    const int before = ThreadLimit::threads();
    {
        const ThreadLimit limit(1);
        EXPECT_EQ(ThreadLimit::threads(), 1);
        const ThreadLimit none(0);
        EXPECT_EQ(ThreadLimit::threads(), 1);
    }
    EXPECT_EQ(ThreadLimit::threads(), before);
    EXPECT_THROW(ThreadLimit(-1), DomainError);
}

}  // namespace
}  // namespace nacre
