#include "nacre/core/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"

namespace nacre {
namespace {

using testing::ElementsAre;

TEST(Split, GivesAllPiecesEmptyOnesToo) {
    EXPECT_THAT(split("a, b,", ','), ElementsAre("a", " b", ""));
    EXPECT_THAT(split("", ','), ElementsAre(""));
}

TEST(Words, AreWhatStandsBetweenSpaces) {
    EXPECT_THAT(words("  0.4\t1.5   0\r"), ElementsAre("0.4", "1.5", "0"));
    EXPECT_THAT(words(" \t"), ElementsAre());
}

// ESC, line ends, DEL, C1 as UTF-8 and as a stray byte, and what only looks like it.
TEST(Printable, EscapesWhatATerminalWouldObey) {
    EXPECT_EQ(printable("a\x1b[31mb"), "a\\x1b[31mb");
    EXPECT_EQ(printable("a\nb\tc\rd"), "a\\nb\\tc\\x0dd");
    EXPECT_EQ(printable("\x7f|\xc2\x9b|\x9b|\xff"), "\\x7f|\\x9b|\\x9b|\\xff");
    EXPECT_EQ(printable("\xc2\xb0 \xc3\xa9 \xe2\x80\x93 \xf0\x9f\x98\x80"),
              "\xc2\xb0 \xc3\xa9 \xe2\x80\x93 \xf0\x9f\x98\x80");
    EXPECT_EQ(printable("\xe2\x80"), "\\xe2\\x80") << "cut short";
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(printable_lines("a,\x1b\nb\tc"), "a,\\x1b\nb\tc");
    EXPECT_EQ(excerpt("a\xc2\x9b[31mb"), "a?[31mb");
}

TEST(Excerpt, IsOneLineAndCutBetweenCharacters) {
    EXPECT_EQ(excerpt("a\nb"), "a?b");
    EXPECT_EQ(excerpt("a\tb", 60, ' '), "a b");
    EXPECT_EQ(excerpt("abcd", 4), "abcd");
    EXPECT_EQ(excerpt("abcde", 4), "abcd...");
    EXPECT_EQ(excerpt("ab\u00e9", 3), "ab...") << "half of the last character would be left";
}

std::string encoding_complaint(std::string_view text) {
    return test::message_of<InputError>([&] { require_utf8(text, "f.csv"); });
}

TEST(Encoding, Utf8WithAndWithoutItsMarkIsAccepted) {
    EXPECT_NO_THROW(require_utf8("Pr\u00fcfling;15\u00b0\n", "f.csv"));
    EXPECT_NO_THROW(require_utf8("\xEF\xBB\xBFname\n", "f.csv"));
    EXPECT_NO_THROW(require_utf8("", "f.csv"));
}

TEST(Encoding, OthersAreNamedWithTheirPlace) {
    EXPECT_EQ(
        encoding_complaint("L;a\n\"Pr\xfc"
                           "fling\";1\n"),
        "f.csv:2:4: is not UTF-8, but perhaps Latin-1 or Windows-1252; save the file as UTF-8");
    for (const std::string& text : {std::string("\xFF\xFEn\0", 4), std::string("\xFE\xFF\0n", 4),
                                    std::string("n\0a\0", 4), std::string("\0n\0a", 4)}) {
        EXPECT_EQ(encoding_complaint(text), "f.csv: is UTF-16; save the file as UTF-8");
    }
    for (const std::string& bytes : {std::string("ab\0c", 4), std::string("Z\0\0\0Z\0\0\0", 8)}) {
        EXPECT_THAT(encoding_complaint(bytes), testing::HasSubstr("binary data"));
    }
}

TEST(Replaced, ChangesAllPlacesAndNothingElse) {
    EXPECT_EQ(replaced("1,5;2,5", ",", "."), "1.5;2.5");
    EXPECT_EQ(replaced("aaa", "aa", "b"), "ba");
    EXPECT_EQ(replaced("", "x", "y"), "");
}

TEST(Lowercase, ChangesTheEnglishAlphabetAlone) {
    EXPECT_EQ(lowercase("L*a9\u00c9"), "l*a9\u00c9");
}

TEST(EditDistance, CountsEachKindOfEditOnce) {
    EXPECT_EQ(edit_distance("alpha", "alpha"), 0);
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("abc", ""), 3);
    EXPECT_EQ(edit_distance("alpha", "alpa"), 1);
    EXPECT_EQ(edit_distance("alpha", "alphaa"), 1);
    EXPECT_EQ(edit_distance("alpha", "alphe"), 1);
    EXPECT_EQ(edit_distance("alpha", "aplha"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(edit_distance("TiO2", "tio2"), 0);
}

TEST(EditDistance, IsSymmetric) {
    const std::vector<std::string> words = {"spread_nm", "thickness_nm", "core", "ca", "abc", ""};
    for (const auto& a : words) {
        for (const auto& b : words) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
    }
}

TEST(ClosestMatch, FindsTheKeyThatWasMeant) {
    const std::vector<std::string> keys = {"thickness_um", "thickness_nm", "spread_nm", "material"};
    EXPECT_EQ(closest_match("thicknes_um", keys), "thickness_um");
    EXPECT_EQ(closest_match("matreial", keys), "material");
    EXPECT_EQ(did_you_mean("spred_nm", keys), " (did you mean 'spread_nm'?)");
}

TEST(ClosestMatch, PrefersNamesThatGoOn) {
    const std::vector<std::string> names = {"SiO2", "TiO2_anatase", "TiO2_rutile_e",
                                            "TiO2_rutile_o"};
    EXPECT_EQ(did_you_mean("TiO2", names),
              " (did you mean 'TiO2_anatase', 'TiO2_rutile_e' or 'TiO2_rutile_o'?)");
    EXPECT_EQ(did_you_mean("tio2_rutile", names),
              " (did you mean 'TiO2_rutile_e' or 'TiO2_rutile_o'?)");
    EXPECT_EQ(did_you_mean("Si02", names), " (did you mean 'SiO2'?)");
    // So many that listing them is no suggestion.
    const std::vector<std::string> many = {"a_1", "a_2", "a_3", "a_4", "a_5", "a_6", "a_7"};
    EXPECT_EQ(did_you_mean("a", many), "");
}

TEST(ClosestMatch, SaysNothingWhenNothingIsNear) {
    const std::vector<std::string> keys = {"thickness_um", "material"};
    EXPECT_EQ(closest_match("viscosity", keys), std::nullopt);
    EXPECT_EQ(closest_match("", keys), std::nullopt);
    EXPECT_EQ(closest_match("x", {}), std::nullopt);
    EXPECT_EQ(closest_match("B", std::vector<std::string>{"A", "E"}), std::nullopt);
    EXPECT_EQ(did_you_mean("viscosity", keys), "");
}

TEST(ClosestMatch, DoesNotChokeOnAnEnormousName) {
    const std::vector<std::string> keys = {"material"};
    EXPECT_EQ(closest_match(std::string(10'000'000, 'm'), keys), std::nullopt);
}

TEST(JsonNesting, CountsBracketsThatStandOutsideOfStrings) {
    EXPECT_EQ(json_nesting("1"), 0u);
    EXPECT_EQ(json_nesting("[]"), 1u);
    EXPECT_EQ(json_nesting(R"({"a": [1, {"b": 2}], "c": [[3]]})"), 3u);
    EXPECT_EQ(json_nesting(R"(["[[[", "\"[[[", "\\", [1]])"), 2u);
    EXPECT_EQ(json_nesting(R"("\\"[[)"), 2u);
}

TEST(JsonNesting, OfTextThatIsNoJsonIsNoLessThanAParserMeets) {
    EXPECT_EQ(json_nesting(std::string(200'000, '[')), 200'000u);
    EXPECT_EQ(json_nesting("]]]}[["), 2u);
    EXPECT_EQ(json_nesting("[\"[[\\"), 1u);
    EXPECT_EQ(json_nesting(""), 0u);
}

}  // namespace
}  // namespace nacre
