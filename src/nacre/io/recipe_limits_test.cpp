#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/table_reader.h"
#include "nacre/testing/errors.h"

// Texts that are too long or nest too deeply to be recipes, and those that only look so.

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

const std::string kSmallest = "ior = 1.5\n[[layer]]\nthickness_um = 1\n";

std::string refusal_of(const std::string& text) {
    return message_of<InputError>([&] { parse_recipe(text, "paint.toml", ""); });
}

TEST(RecipeLimits, RefusesAbsurdSizes) {
    std::string many = "ior = 1.5\n";
    for (int i = 0; i < 65; ++i) many += "[[layer]]\nthickness_um = 1\n";
    EXPECT_THAT(refusal_of(many),
                HasSubstr("layer = [...] (65 entries): must be a list of 1 to 64"));
    EXPECT_THAT(refusal_of(std::string(kMaxTextBytes + 1, '\n')),
                HasSubstr("at most 1048576 are allowed"));
    EXPECT_THAT(refusal_of("a = " + std::string(100000, '[')), HasSubstr("paint.toml:1:"));
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

// The parser and its tree are recursive: what nests too deeply must not get there.
TEST(RecipeLimits, RefusesDeepNestingBeforeItIsParsed) {
    constexpr int kDeep = 50'000;
    const std::string deep = repeated("a.", kDeep) + "a = 1";
    for (const std::string& text :
         {deep, "[" + repeated("a.", kDeep) + "a]", repeated("a . ", kDeep) + "a = 1",
          repeated(R"("a".'b'."".)", kDeep) + "a = 1", "x = { " + deep + " }",
          // Texts that end where they seem not to.
          "x = 'it\\'\n" + deep, "# \"\n" + deep, "x = \"\\\"\"\n" + deep,
          "x = \"\"\"\\\"\"\"\"\"\"\n" + deep, "x = '''''''''\n" + deep, "x = \"a\n" + deep}) {
        EXPECT_THAT(refusal_of(text), HasSubstr("paint.toml:"));
    }
    EXPECT_THAT(refusal_of("ior = 1.5\n" + deep),
                HasSubstr("paint.toml:2:64: a key of more than 32 parts"));
    for (const std::string open : {"[", "{a=", "[{a=", "[ ", "[\n"}) {
        EXPECT_THAT(refusal_of("ior = 1.5\nx = " + repeated(open, kDeep)),
                    HasSubstr("nested more than 32 deep"))
            << open;
    }
    EXPECT_THAT(refusal_of("ior = " + repeated("[", kDeep) + repeated("]", kDeep)),
                HasSubstr("paint.toml:1:39: nested more than 32 deep"));
    // Tables one by one, each a little deeper.
    std::string deeper;
    for (int i = 0; i < 40; ++i) deeper += "[" + repeated("a.", i) + "a]\n";
    EXPECT_THAT(refusal_of(deeper), HasSubstr("a key of more than 32 parts"));
}

TEST(RecipeLimits, DotsAndBracketsInTextsAndCommentsDoNotNest) {
    const std::string many = repeated(".", 40) + repeated("[{", 20);
    for (const std::string& name :
         {'"' + many + "\\\"" + many + "\" # \" " + many, "\"\"\"\n\"" + many + "\"\n\"\"\"\"\"",
          "'" + many + "\\' # ' " + many, "'''" + many + "'" + many + "\\''''"}) {
        const std::string recipe = "name = " + name + "\n" + kSmallest;
        EXPECT_NO_THROW(parse_recipe(recipe, "paint.toml", "")) << refusal_of(recipe);
    }
}

}  // namespace
}  // namespace nacre::io
