#include "nacre/core/base64.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

TEST(Base64, GivesTheTestVectorsOfTheStandard) {
    // [rfc-4648-2006, section 10]
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, TakesEveryByte) {
    // python3 -c "import base64; print(base64.b64encode(bytes([0, 127, 128, 255, 251, 239])))"
    EXPECT_EQ(base64(std::string_view("\x00\x7f\x80\xff\xfb\xef", 6)), "AH+A//vv");
}

TEST(Base64, IsReadBackAndNothingElseIs) {
    for (const std::string_view bytes :
         {std::string_view(), std::string_view("f"), std::string_view("fo"),
          std::string_view("foo"), std::string_view("\x00\x7f\x80\xff\xfb\xef", 6)}) {
        EXPECT_EQ(from_base64(base64(bytes)), bytes);
    }
    for (const char* wrong :
         {"Zg", "Zg=", "Zh==", "Z===", "====", "Zm9v\n", "Zm 9", "Zm9v====", "=m9v", "Zm-_"}) {
        EXPECT_EQ(from_base64(wrong), std::nullopt) << wrong;
    }
}

}  // namespace
}  // namespace nacre
