#include "nacre/io/toml_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using nacre::test::replaced;
using ::testing::HasSubstr;

std::string edited(const std::string& text, const std::string& path, const std::string& value) {
    TomlEditor editor(text, "test.toml");
    editor.set({{parse_toml_path(path), value}});
    return editor.text();
}

// Every way in which TOML writes a table.
const std::string kText = R"(# Gold: a trial.
name = "Gold \u00e4 \"x\" = 7"   # said here

ior=1.5 # of the binder
[ layer_of_air ]
[[layer]]
  thickness_um = 15.0	# um, wet: 40
  # no flakes yet

  [[layer.flakes]]
  core  = { material = "mica", thickness_nm=500 }
  coats = [
      { material = "TiO2", thickness_nm = 80 }, # inside
      { },
  ]
  orientation.alpha = 0.1 # dotted
  list = [ 1, # first
           2.5,
           3 ]
[layer.flakes.more]
x = 1
[[layer]]
thickness_um = 0x10
[sub.below]
y = 2_000
)";

TEST(TomlEdit, ReplacesAValueAndKeepsEveryOtherByte) {
    const struct {
        const char *path, *value, *from, *to;
    } cases[] = {
        {"ior", "1.52", "ior=1.5 #", "ior=1.52 #"},
        {"name", "\"Silver\"", "\"Gold \\u00e4 \\\"x\\\" = 7\"   #", "\"Silver\"   #"},
        {"layer[0].thickness_um", "7", "15.0\t#", "7\t#"},
        {"layer[1].thickness_um", "17", "0x10", "17"},
        {"layer[0].flakes[0].core.thickness_nm", "510", "500 }", "510 }"},
        {"layer[0].flakes[0].core.material", "1.58", "\"mica\",", "1.58,"},
        {"layer[0].flakes[0].coats[0].thickness_nm", "81.5", "80 }, # in", "81.5 }, # in"},
        {"layer[0].flakes[0].coats[1]", "{ a = 1 }", "{ },", "{ a = 1 },"},
        {"layer[0].flakes[0].orientation.alpha", "0.2", "0.1 # dotted", "0.2 # dotted"},
        {"layer[0].flakes[0].list[1]", "-2e3", "2.5,", "-2e3,"},
        {"layer[0].flakes[0].list", "[]", "[ 1, # first\n           2.5,\n           3 ]", "[]"},
        {"layer[0].flakes[0].more.x", "true", "x = 1", "x = true"},
        {"sub.below.y", "2", "2_000", "2"},
    };
    for (const auto& [path, value, from, to] : cases) {
        EXPECT_EQ(edited(kText, path, value), replaced(kText, from, to)) << path;
    }
}

TEST(TomlEdit, AddsAKeyWhereItsTableIsWritten) {
    const struct {
        const char *path, *from, *to;
    } cases[] = {
        {"clear", "ior=1.5 # of the binder\n", "ior=1.5 # of the binder\nclear = 9\n"},
        {"layer[0].flakes[0].core.spread_nm", "500 }", "500, spread_nm = 9 }"},
        {"layer[0].flakes[0].coats[1].n", "{ },", "{ n = 9 },"},
        {"layer[0].depth", "40\n", "40\n  depth = 9\n"},
        {"layer[1].depth", "0x10\n", "0x10\ndepth = 9\n"},
        {"layer[0].flakes[0].orientation.bottom", "3 ]\n", "3 ]\n  orientation.bottom = 9\n"},
        {"layer[0].flakes[0].edge.width", "3 ]\n", "3 ]\n  edge.width = 9\n"},
        {"layer_of_air.k", "[ layer_of_air ]\n", "[ layer_of_air ]\nk = 9\n"},
        {"sub.below.z", "2_000\n", "2_000\nz = 9\n"},
        {"substrate.reflectance", "2_000\n", "2_000\n\n[substrate]\nreflectance = 9\n"},
        {"a.b.c", "2_000\n", "2_000\n\n[a.b]\nc = 9\n"},
    };
    for (const auto& [path, from, to] : cases) {
        EXPECT_EQ(edited(kText, path, "9"), replaced(kText, from, to)) << path;
    }
}

TEST(TomlEdit, KeepsTheLineEndsOfOtherSystems) {
    EXPECT_EQ(edited("a = 1\r\n[t]\r\nb = 2 # two\r\n", "t.b", "3"),
              "a = 1\r\n[t]\r\nb = 3 # two\r\n");
    EXPECT_EQ(edited("a = 1\r\n[t]\r\nb = 2 # two\r\n", "t.c", "3"),
              "a = 1\r\n[t]\r\nb = 2 # two\r\nc = 3\r\n");
    EXPECT_EQ(edited("a = 1\r\n", "s.x", "3"), "a = 1\r\n\r\n[s]\r\nx = 3\r\n");
}

TEST(TomlEdit, TakesTextsThatEndWithoutALineEnd) {
    EXPECT_EQ(edited("a = 1", "a", "25"), "a = 25");
    EXPECT_EQ(edited("a = 1", "b", "2"), "a = 1\nb = 2");
    EXPECT_EQ(edited("a = 1", "s.x", "2"), "a = 1\n\n[s]\nx = 2\n");
    EXPECT_EQ(edited("t = { a = 1 }", "t.a", "25"), "t = { a = 25 }");
    EXPECT_EQ(edited("", "a", "1"), "a = 1\n");
}

// Columns count characters, not bytes, and do not count the mark at the beginning.
TEST(TomlEdit, FindsValuesBehindLettersOfSeveralBytes) {
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_EQ(edited(mark + "a = 1\n", "a", "2"), mark + "a = 2\n");
    EXPECT_EQ(edited(mark + "[t]\na = 1\n", "b", "2"), mark + "b = 2\n[t]\na = 1\n");
    const std::string text =
        "t = { n = \"Gr\xC3\xBCn \xE2\x82\xAC \xF0\x9F\x8E\xA8\", a = 1, b = 2 }";
    EXPECT_EQ(edited(text, "t.a", "7"), replaced(text, "a = 1", "a = 7"));
    EXPECT_EQ(edited(text, "t.c", "7"), replaced(text, "b = 2", "b = 2, c = 7"));
}

TEST(TomlEdit, SetsManyAtOnceAndQuotesKeys) {
    TomlEditor editor(kText, "test.toml");
    editor.set({{parse_toml_path("layer[0].flakes[0].list[2]"), "33"},
                {parse_toml_path("ior"), "1.6"},
                {{std::string("fit"), std::string("layer[0].thickness_um")}, "[1, 2]"},
                {parse_toml_path("layer[0].flakes[0].list[0]"), "11"}});
    std::string wanted = replaced(kText, "1.5 #", "1.6 #");
    wanted = replaced(wanted, "[ 1,", "[ 11,");
    wanted = replaced(wanted, "3 ]", "33 ]");
    EXPECT_EQ(editor.text(), wanted + "\n[fit]\n\"layer[0].thickness_um\" = [1, 2]\n");
    EXPECT_TRUE(editor.find({std::string("fit"), std::string("layer[0].thickness_um")}));
}

TEST(TomlEdit, ReplacesAnEntryByOthers) {
    TomlEditor editor("[[p]]\n  from = \"white\" # theirs\n  v = 1\n[q]\nx = { from = 1, v = 2 }\n",
                      "test.toml");
    editor.replace(parse_toml_path("p[0].from"), {{"s", "3"}, {"a", "[1, 2]"}});
    editor.replace(parse_toml_path("q.x.from"), {{"s", "3"}, {"a b", "4"}});
    EXPECT_EQ(editor.text(),
              "[[p]]\n  s = 3\n  a = [1, 2] # theirs\n  v = 1\n[q]\n"
              "x = { s = 3, \"a b\" = 4, v = 2 }\n");
}

TEST(TomlEdit, RefusesWhatItCannotDoAndLeavesTheText) {
    TomlEditor editor(kText, "test.toml");
    const auto refused = [&](const std::string& path, const std::string& value = "9") {
        return message_of<Error>([&] {
            editor.set({{parse_toml_path("ior"), "1.7"}, {parse_toml_path(path), value}});
        });
    };
    EXPECT_THAT(refused("layer[2].depth"), HasSubstr("layer[2]: there is no such entry"));
    EXPECT_THAT(refused("layer[0].flakes[0].coats[5].n"), HasSubstr("no such entry"));
    EXPECT_THAT(refused("layer"), HasSubstr("over several lines"));
    EXPECT_THAT(refused("layer[0].flakes[0].orientation"), HasSubstr("over several lines"));
    EXPECT_THAT(refused("ior"), HasSubstr("ior: is set twice"));
    EXPECT_THAT(refused("name.x"), HasSubstr("is a value without keys"));
    EXPECT_THAT(refused("sub.z"), HasSubstr("no line of its own"));
    EXPECT_THAT(refused("layer[0].thickness_um", "1 2"), HasSubstr("test.toml:7"));
    EXPECT_THAT(refused("layer[0].thickness_um", "]"), HasSubstr("test.toml"));
    EXPECT_EQ(editor.text(), kText);
}

TEST(TomlEdit, PathsAndValuesOfTheCommandLine) {
    EXPECT_EQ(parse_toml_path("a[10].b_c[0][1].d-1"),
              (TomlPath{std::string("a"), std::size_t{10}, std::string("b_c"), std::size_t{0},
                        std::size_t{1}, std::string("d-1")}));
    for (const char* wrong : {"", "a.", ".a", "a[", "a[]", "a[-1]", "a[1", "a[1]b", "a b", "a[1].",
                              "a[99999999999999999999]", "a=b", "\"a\""}) {
        EXPECT_THROW(parse_toml_path(wrong), DomainError) << wrong;
    }
    EXPECT_EQ(toml_value(" 0.5 # half"), "0.5");
    EXPECT_EQ(toml_value("[1,\n2]"), "[1,\n2]");
    EXPECT_EQ(toml_value("{ a = 1 }"), "{ a = 1 }");
    EXPECT_EQ(toml_value("'x y'"), "'x y'");
    EXPECT_EQ(toml_value("TiO2_anatase"), "\"TiO2_anatase\"");
    EXPECT_EQ(toml_value("0,5"), "\"0,5\"");
    for (const char* wrong : {"", " ", "1\ny = 2", "[1, 2", "\"a", "{", "a\nb"}) {
        EXPECT_THROW(toml_value(wrong), DomainError) << wrong;
    }
}

}  // namespace
}  // namespace nacre::io
