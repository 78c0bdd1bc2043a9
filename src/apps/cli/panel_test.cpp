#include <gmock/gmock.h>

#include "apps/cli/program_test_support.h"

namespace nacre::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Panel = nacre::cli::testing::Program;
using nacre::cli::testing::contents;
using nacre::cli::testing::Outcome;

TEST_F(Panel, WritesOnePage) {
    const Outcome outcome =
        nacre("panel gray.toml -o gray.html --quality low --model microflake --report run.json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string page = contents(folder_ / "gray.html");
    EXPECT_THAT(page, StartsWith("<!doctype html>"));
    EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
    EXPECT_THAT(page, HasSubstr("Flop index"));
    EXPECT_THAT(page, Not(HasSubstr("Graininess")));  // this model shows no single flakes
    EXPECT_THAT(contents(folder_ / "run.json"), HasSubstr("recipe_sha256"));
}

TEST_F(Panel, GoesToTheStandardOutput) {
    const std::string panel = "panel gray.toml --model microflake --quality low -q -o ";
    const Outcome printed = nacre(panel + "-");
    EXPECT_EQ(printed.status, 0) << printed.err;
    ASSERT_EQ(nacre(panel + "page.html").status, 0);
    EXPECT_EQ(printed.out, contents(folder_ / "page.html"));
    EXPECT_THAT(nacre(panel + "page.pdf").err, HasSubstr("must end in .html, or be - for"));
    EXPECT_THAT(nacre("render sphere --paint gray.toml --spp 1 -o -").err,
                HasSubstr("--output = -: must end in .exr; a picture is two files"));
    EXPECT_THAT(nacre("export gray.toml -o -").err,
                HasSubstr("does not go to the standard output"));
}

TEST_F(Panel, ComparesWithWhatWasMeasured) {
    EXPECT_EQ(nacre("measure gray.toml -o standard.csv").status, 0);
    const Outcome outcome =
        nacre("panel gray.toml -o a.html --quality low --model microflake --versus standard.csv");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string page = contents(folder_ / "a.html");
    EXPECT_THAT(page, HasSubstr("standard, measured"));
    EXPECT_THAT(page, HasSubstr("<dd>0.00"));  // it is the same paint
}

TEST_F(Panel, SaysHowSureItIsWhereTheRecipeDoes) {
    write("known.toml", contents(folder_ / "gray.toml") +
                            "\n[uncertainty]\n\"layer[0].thickness_um\" = \"5 %\"\n");
    const std::string how = " --quality low --model microflake -o a.html";
    ASSERT_EQ(nacre("panel known.toml" + how).status, 0);
    const std::string page = contents(folder_ / "a.html");
    EXPECT_THAT(page, HasSubstr("How sure this is"));
    EXPECT_THAT(page, HasSubstr("ellipses hold 95 %"));
    EXPECT_THAT(page, HasSubstr("they are taken to be independent"));
    ASSERT_EQ(nacre("panel known.toml --uncertainty alpha=5% --correlation *=0.5" + how).status, 0);
    EXPECT_THAT(
        contents(folder_ / "a.html"),
        HasSubstr("layer[0].thickness_um and layer[0].flakes[0].orientation.alpha by 0.5."));
    ASSERT_EQ(nacre("panel known.toml --no-uncertainty" + how).status, 0);
    const std::string without = contents(folder_ / "a.html");
    EXPECT_THAT(without, Not(HasSubstr("How sure")));
    EXPECT_THAT(without, Not(HasSubstr("±")));
}

TEST_F(Panel, ComparesWithAMeasuredBrdf) {
    ASSERT_EQ(nacre("export gray.toml -q -o gray.bsdf --resolution 8 --incidences 4").status, 0);
    const Outcome outcome = nacre("panel gray.toml -o a.html --quality low --versus gray.bsdf");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(contents(folder_ / "a.html"), HasSubstr("standard, measured"));
    const Outcome refused = nacre("panel gray.bsdf -o c.html");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("needs a recipe"));
}

TEST_F(Panel, IsTheSameHoweverManyThreadsMakeIt) {
    EXPECT_EQ(nacre("panel gray.toml -o a.html --quality low --threads 1").status, 0);
    EXPECT_EQ(nacre("panel gray.toml -o b.html --quality low --threads 3").status, 0);
    EXPECT_THAT(contents(folder_ / "a.html"), HasSubstr("Graininess"));
    EXPECT_EQ(contents(folder_ / "a.html"), contents(folder_ / "b.html"));
}

TEST_F(Panel, RefusesWhatHasNoComposition) {
    EXPECT_EQ(nacre("measure gray.toml --geometry 45as15 -o measured.csv").status, 0);
    const auto complaint = [&](const std::string& arguments, int status) {
        const Outcome outcome = nacre("panel " + arguments);
        EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.err;
        return outcome.err;
    };
    EXPECT_THAT(complaint("measured.csv -o a.html", 2), HasSubstr("needs a recipe"));
    EXPECT_THAT(complaint("gray.toml -o a.pdf", 1), HasSubstr("must end in .html"));
    EXPECT_THAT(complaint("gray.toml -o a.html --scene moon", 2), HasSubstr("moon"));
    EXPECT_THAT(complaint("gray.toml -o nowhere/a.html", 2), HasSubstr("nowhere"));
    EXPECT_THAT(complaint("gray.toml -o a.html --model walk", 1), HasSubstr("walk"));
    EXPECT_THAT(complaint("gray.toml -o a.html --model thin-film", 2), HasSubstr("microfacet"));
    EXPECT_THAT(complaint("missing.toml -o a.html", 2), HasSubstr("missing.toml"));
    EXPECT_FALSE(exists("a.html"));
}

TEST_F(Panel, EndsWithFourBeyondTheTolerance) {
    write("darker.csv", "geometry,L,a,b\n45as15,1,0,0\n45as45,1,0,0\n");
    const std::string panel =
        "panel gray.toml -o a.html --quality low --model microflake --versus darker.csv ";
    const Outcome beyond = nacre(panel + "--tolerance 1");
    EXPECT_EQ(beyond.status, 4) << beyond.err;
    EXPECT_THAT(beyond.err, HasSubstr("does not pass: beyond the tolerance"));
    EXPECT_TRUE(exists("a.html"));
    EXPECT_EQ(nacre(panel + "--tolerance 1000").status, 0);
    EXPECT_EQ(nacre(panel).status, 0);
}

TEST_F(Panel, MeasureDrawsPlots) {
    const Outcome outcome = nacre("measure gray.toml --plots curves -o gray.csv");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const std::string name : {"lightness", "travel", "spectra"}) {
        EXPECT_THAT(contents(folder_ / "curves" / (name + ".svg")), StartsWith("<svg"));
        EXPECT_THAT(contents(folder_ / "curves" / (name + ".png")), StartsWith("\x89PNG"));
    }
    EXPECT_EQ(nacre("measure gray.toml --versus gray.toml --plots both").status, 0);
    EXPECT_THAT(contents(folder_ / "both/travel.svg"), HasSubstr("standard: "));
    EXPECT_EQ(nacre("measure gray.toml --plots gray.toml/x").status, 2);
}

}  // namespace
}  // namespace nacre::cli
