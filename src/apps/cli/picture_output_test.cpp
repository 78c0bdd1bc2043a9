#include "apps/cli/picture_output.h"

#include <gtest/gtest.h>

namespace nacre::cli {
namespace {

TEST(PictureOutput, PercentagesArePlainNumbers) {
    EXPECT_EQ(percent_text(0), "0 %");
    EXPECT_EQ(percent_text(0.0001234), "0.012 %");
    EXPECT_EQ(percent_text(0.0234), "2.3 %");
    EXPECT_EQ(percent_text(0.994), "99 %");
    EXPECT_EQ(percent_text(0.996), "100 %");
    EXPECT_EQ(percent_text(1), "100 %");
    EXPECT_EQ(percent_text(1.1), "110 %");
    EXPECT_EQ(percent_text(50), "5000 %");
}

}  // namespace
}  // namespace nacre::cli
