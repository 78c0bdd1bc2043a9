#include "nacre/core/sha256.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

// hashlib.sha256(text).hexdigest() of Python 3.11.7; the second and third are the standard's own
// examples.
TEST(Sha256, MatchesTheStandardsExamples) {
    EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_hex("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256_hex(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnHowTheBytesAreCutUp) {
    std::string bytes;
    for (int i = 0; i < 200; ++i) bytes += static_cast<char>(i * 37);
    for (std::size_t length = 0; length <= bytes.size(); ++length) {
        const std::string whole = sha256_hex({bytes.data(), length});
        for (std::size_t cut : {std::size_t{0}, length / 3, length}) {
            Sha256 pieces;
            pieces.update({bytes.data(), cut});
            EXPECT_FALSE(pieces.hex().empty());  // looking must not disturb
            pieces.update({bytes.data() + cut, length - cut});
            ASSERT_EQ(pieces.hex(), whole) << length << " " << cut;
        }
    }
}

}  // namespace
}  // namespace nacre
