#include "nacre/core/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"

namespace nacre {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using Texts = std::vector<std::vector<std::string>>;

Texts texts(const std::vector<CsvRow>& rows) {
    Texts result;
    for (const CsvRow& row : rows) {
        result.emplace_back();
        for (const CsvCell& cell : row) result.back().push_back(cell.text);
    }
    return result;
}

TEST(Csv, LeavesOutCommentsEmptyLinesAndTheByteOrderMark) {
    const Texts expected = {{"a", "b"}, {"1", ""}};
    EXPECT_EQ(texts(parse_csv("\xEF\xBB\xBF# x,y\r\n\r\na , b\r\n  # z\n1,", "f.csv")), expected);
}

TEST(Csv, TakesTheSeparatorOfTheFirstRowUnlessOneIsGiven) {
    EXPECT_EQ(texts(parse_csv("# a,b\na;b\n1,5;2", "f.csv")), (Texts{{"a", "b"}, {"1,5", "2"}}));
    EXPECT_EQ(texts(parse_csv("a\tb", "f.csv")), (Texts{{"a", "b"}}));
    EXPECT_EQ(texts(parse_csv("a;b", "f.csv", ',')), (Texts{{"a;b"}}));
}

TEST(Csv, TheSeparatorIsWhatStandsMostOftenOutsideOfQuotes) {
    EXPECT_EQ(csv_separator("L 45to30,90;a;b;\"c,,,,\""), ';');
    EXPECT_EQ(csv_separator("a\tb, c\td"), '\t');
    EXPECT_EQ(csv_separator("a,b;c"), ',');
    EXPECT_EQ(csv_separator("a"), ',');
    EXPECT_EQ(first_csv_line("\xEF\xBB\xBF# a;b\n\n c,d\ne"), " c,d");
}

TEST(Csv, RefusesOtherEncodings) {
    EXPECT_THAT([] { parse_csv("a\nb\xe4", "f.csv"); },
                ThrowsMessage<InputError>(HasSubstr("f.csv:2:2: is not UTF-8")));
}

TEST(Csv, DecimalCommasGoIntoNumbersAndNothingElse) {
    EXPECT_EQ(with_decimal_commas("name,x,R450.5\n\"1.5, a\",-0.25,1e-17\n45as0.1,3,'-1.5\n"),
              "name;x;R450.5\n\"1.5, a\";-0,25;1e-17\n45as0.1;3;'-1.5\n");
    EXPECT_EQ(with_decimal_commas("1.5,2"), "1,5;2");
    EXPECT_EQ(texts(parse_csv(with_decimal_commas("a,\"b;c\"\n1.25,2.5\n"), "f.csv")),
              (Texts{{"a", "b;c"}, {"1,25", "2,5"}}));
}

TEST(CsvNumbers, HaveOneDecimalMarkInAFile) {
    CsvNumbers german("f.csv", ';');
    EXPECT_EQ(german.parse({"0,04", 2, 5}), 0.04);
    EXPECT_EQ(german.parse({"\u2212400", 2, 1}), -400);
    EXPECT_EQ(german.parse({"1,2,3", 2, 1}), std::nullopt);
    EXPECT_EQ(german.parse({"a.b", 2, 1}), std::nullopt);
    EXPECT_THAT(german.advice({"1,234,567", 2, 1}), HasSubstr("thousands"));
    EXPECT_THAT(
        [&] {
            german.parse({"1.5", 7, 3});
        },
        ThrowsMessage<InputError>(
            HasSubstr("f.csv:2:5: 0,04 has a decimal comma, but 1.5 in line 7 has a")));
    CsvNumbers english("f.csv", ',');
    EXPECT_EQ(english.parse({"0.04", 2, 5}), 0.04);
    EXPECT_EQ(english.parse({"0,04", 2, 5}), std::nullopt);
    EXPECT_THAT(english.advice({"0,04", 2, 5}), HasSubstr("need semicolons or tabs"));
    EXPECT_EQ(english.advice({"much", 2, 5}), "");
    EXPECT_THAT(english.advice(CsvRow(3), 2), HasSubstr("need semicolons or tabs"));
    EXPECT_EQ(english.advice(CsvRow(1), 2), "");
    EXPECT_EQ(german.advice(CsvRow(3), 2), "");
}

TEST(Csv, BytesThatAreNoTextAreWrittenAsEscapes) {
    EXPECT_EQ(csv_cell("silver\xff"), "silver\\xff");
    EXPECT_EQ(csv_cell(std::string("a\0b", 3)), "a\\x00b");
}

TEST(Csv, KnowsWhereACellStands) {
    const auto rows = parse_csv("a,b\n\n\"x\ny\", z\nlast", "f.csv");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[1][0].text, "x\ny");
    EXPECT_EQ(rows[1][1].line, 4u);
    EXPECT_EQ(rows[1][1].column, 5u);
    EXPECT_EQ(rows[2][0].line, 5u);
}

TEST(Csv, RefusesQuotesThatDoNotEndOrEndEarly) {
    EXPECT_THAT([] { parse_csv("a\n\"b", "f.csv"); },
                ThrowsMessage<InputError>(HasSubstr("f.csv:2:1: the quote")));
    EXPECT_THAT([] { parse_csv("a,\"b\" c", "f.csv"); },
                ThrowsMessage<InputError>(HasSubstr("f.csv:1:3: something follows")));
}

TEST(Csv, ReadsBackWhatItWrites) {
    for (const std::string text :
         {"plain", "a,b", "say \"x\"", " padded ", "# no comment", "two\nlines"}) {
        const auto rows = parse_csv(csv_cell(text) + ",end", "f.csv", ',');
        ASSERT_EQ(rows.size(), 1u);
        EXPECT_EQ(rows[0][0].text, text);
    }
}

// As the spreadsheets' makers advise; a number, and a name that only holds such a character, stay.
TEST(Csv, WhatASpreadsheetWouldRunIsMadeHarmlessAndReadBack) {
    EXPECT_EQ(csv_cell("=1+1"), "'=1+1");
    EXPECT_EQ(csv_cell("@SUM(A1)"), "'@SUM(A1)");
    EXPECT_EQ(csv_cell("+cmd|' /C calc'!A0"), "'+cmd|' /C calc'!A0");
    EXPECT_EQ(csv_cell("-a,b"), "\"'-a,b\"");
    for (const char* plain : {"-15.5", "+2", "a=b", "'quoted'", "45as-15", "it's"}) {
        EXPECT_EQ(csv_cell(plain), plain);
    }
    for (const std::string text :
         {"=1+1", "@x", "+y", "-z", "\t=1", "\r=1", "=HYPERLINK(\"a\",\"b\")", "'=1", "''=1", "'",
          "''", "'x", "-15.5", "-"}) {
        const auto rows = parse_csv(csv_cell(text) + ",end", "f.csv", ',');
        ASSERT_EQ(rows.size(), 1u);
        EXPECT_EQ(rows[0][0].text, text);
        EXPECT_EQ(csv_cell(text).find_first_of("=+@") == 0, false) << text;
    }
}

}  // namespace
}  // namespace nacre
