#include "nacre/core/lru_cache.h"

#include <gtest/gtest.h>

#include <barrier>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace nacre {
namespace {

TEST(LruCache, AreMadeOnceWhileTheyAreKept) {
    LruCache<int, std::string> squares(2);
    const auto ask = [&](int x) { return *squares.get(x, [&] { return std::to_string(x * x); }); };
    EXPECT_EQ(ask(3), "9");
    EXPECT_EQ(ask(4), "16");
    EXPECT_EQ(ask(3), "9");
    EXPECT_EQ(squares.made(), 2u);
    EXPECT_EQ(ask(5), "25");  // in place of 4, which was not asked for since
    EXPECT_EQ(ask(3), "9");
    EXPECT_EQ(squares.made(), 3u);
    EXPECT_EQ(ask(4), "16");
    EXPECT_EQ(squares.made(), 4u);
}

TEST(LruCache, TakeNoMoreThanTheirCapacity) {
    LruCache<int, std::string> words(10, [](const std::string& s) { return s.size(); });
    const auto ask = [&](int length) {
        return words.get(length, [&] { return std::string(length, 'x'); })->size();
    };
    EXPECT_EQ(ask(6), 6u);
    EXPECT_EQ(ask(4), 4u);
    EXPECT_EQ(ask(6), 6u);
    EXPECT_EQ(words.made(), 2u);
    EXPECT_EQ(ask(11), 11u);  // is not kept, and drops nothing
    EXPECT_EQ(ask(11), 11u);
    EXPECT_EQ(ask(6) + ask(4), 10u);
    EXPECT_EQ(words.made(), 4u);
    EXPECT_EQ(ask(9), 9u);  // in place of both
    EXPECT_EQ(ask(9) + ask(4), 13u);
    EXPECT_EQ(words.made(), 6u);
}

TEST(LruCache, AreKeptOnceThoughTwoThreadsMakeTheSame) {
    LruCache<int, int> results(4);
    std::barrier both(2);
    std::shared_ptr<const int> here, there;
    const auto ask = [&](std::shared_ptr<const int>& found) {
        found = results.get(1, [&] {
            both.arrive_and_wait();
            return 7;
        });
    };
    std::thread other([&] { ask(there); });
    ask(here);
    other.join();
    EXPECT_EQ(results.made(), 2u);
    EXPECT_EQ(*here, 7);
    EXPECT_EQ(here, there);
    EXPECT_EQ(results.get(1, [] { return 8; }), here);
}

TEST(LruCache, KeepNothingOfWhatThrows) {
    LruCache<int, int> results(4);
    EXPECT_THROW(results.get(1, []() -> int { throw std::runtime_error("no"); }),
                 std::runtime_error);
    EXPECT_EQ(*results.get(1, [] { return 7; }), 7);
}

}  // namespace
}  // namespace nacre
