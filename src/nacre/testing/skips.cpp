#include <gtest/gtest.h>

#include <iostream>
#include <stdexcept>
#include <string>

// Tests that are skipped, for check_skips_test.py.

class SetUpFails : public testing::Test {
 public:
    static void SetUpTestSuite() { FAIL() << "deliberately"; }
};
TEST_F(SetUpFails, OfASuite) {}

class SetUpExpects : public testing::Test {
 public:
    static void SetUpTestSuite() { EXPECT_EQ(1, 2) << "deliberately"; }
};
TEST_F(SetUpExpects, OfASuite) {}

class SetUpThrows : public testing::Test {
 public:
    static void SetUpTestSuite() { throw std::runtime_error("deliberately"); }
};
TEST_F(SetUpThrows, OfASuite) {}

TEST(Skips, WithoutAReason) { GTEST_SKIP(); }

TEST(Skips, WithATraceAlone) {
    SCOPED_TRACE("no reason");
    GTEST_SKIP();
}

TEST(Skips, WithAReason) {
    std::cout << std::string(3000, '.') << '\n';  // more than CTest keeps unless told to
    GTEST_SKIP() << "deliberately";
}

TEST(Skips, DISABLED_Always) {}

TEST(Skips, No) {}
