#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/cli/program_test_support.h"

// What nacre studio refuses before it listens; the server itself: src/apps/studio/server_test.cpp.

namespace nacre::cli {
namespace {

using ::testing::HasSubstr;
using StudioProgram = nacre::cli::testing::Program;

TEST_F(StudioProgram, ListensToOthersOnlyIfToldSoInSoManyWords) {
    const auto others = nacre("studio --no-open --listen 0.0.0.0");
    EXPECT_EQ(others.status, 1);
    EXPECT_THAT(others.err, HasSubstr("--open-to-the-network"));
    EXPECT_EQ(nacre("studio --no-open --listen somewhere").status, 2);
    EXPECT_EQ(nacre("studio --no-open --port 65536").status, 1);
}

TEST_F(StudioProgram, ReadsPaintsByModelsOfExactValuesOnly) {
    const auto pictures = nacre("studio --no-open --model volume");
    EXPECT_EQ(pictures.status, 1);
    EXPECT_THAT(pictures.err, HasSubstr("--model = volume: is no model by which paints are read "
                                        "here; there are: microflake, nacre"));
}

TEST_F(StudioProgram, StartsWithARecipeOnly) {
    EXPECT_EQ(nacre("studio --no-open nowhere.toml").status, 2);
    write("wrong.toml", "ior = 0\n");
    const auto wrong = nacre("studio --no-open wrong.toml");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err, HasSubstr("wrong.toml:1"));
}

}  // namespace
}  // namespace nacre::cli
