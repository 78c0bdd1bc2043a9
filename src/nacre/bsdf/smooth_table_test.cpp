#include "nacre/bsdf/smooth_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <thread>
#include <vector>

namespace nacre::bsdf {
namespace {

constexpr std::size_t kCells = 1000;

void fill(const BoundSmoothTable& table, float value) {
    std::fill_n(table.get(), kCells, splat(value));
}

bool holds(const BoundSmoothTable& table, float value) {
    return std::all_of(table.get(), table.get() + kCells, [&](const FloatLanes& lanes) {
        return lanes[0] == value && lanes[kLanes - 1] == value;
    });
}

TEST(SmoothTableMemory, TablesBoundAtOnceHaveTheirOwn) {
    const auto memory = std::make_shared<SmoothTableMemory>();
    constexpr int kThreads = 4, kPasses = 200;
    std::array<int, kThreads> kept{};
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i) {
        threads.emplace_back([&, i] {
            for (int pass = 0; pass < kPasses; ++pass) {
                const BoundSmoothTable one = SmoothTableMemory::take(memory, kCells);
                const BoundSmoothTable two = SmoothTableMemory::take(memory, kCells);
                const auto value = static_cast<float>(2 * (pass * kThreads + i));
                fill(one, value);
                fill(two, value + 1);
                kept[i] += holds(one, value) && holds(two, value + 1);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const int count : kept) EXPECT_EQ(count, kPasses);
}

TEST(SmoothTableMemory, IsUsedAgain) {
    const auto memory = std::make_shared<SmoothTableMemory>();
    std::set<const FloatLanes*> places;
    for (int pass = 0; pass < 10; ++pass) {
        const BoundSmoothTable one = SmoothTableMemory::take(memory, kCells);
        const BoundSmoothTable two = SmoothTableMemory::take(memory, kCells);
        places.insert({one.get(), two.get()});
    }
    EXPECT_EQ(places.size(), 2u);  // as many as were bound at once
}

TEST(SmoothTableMemory, OutlivesItsTable) {
    auto memory = std::make_shared<SmoothTableMemory>();
    const BoundSmoothTable bound = SmoothTableMemory::take(memory, kCells);
    memory.reset();
    fill(bound, 1);
    EXPECT_TRUE(holds(bound, 1));
}

}  // namespace
}  // namespace nacre::bsdf
