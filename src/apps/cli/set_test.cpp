#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/cli/program_test_support.h"
#include "nacre/testing/files.h"

// --set, of all commands that take a recipe.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(Program, SetPutsValuesIntoTheRecipe) {
    const std::string gray = "name = \"gray\"\n" + contents(folder_ / "gray.toml");
    write("gray.toml", gray);
    write("other.toml", test::replaced(test::replaced(gray, "alpha = 0.2", "alpha = 0.3"),
                                       "thickness_um = 15", "thickness_um = 20"));
    const std::string set = " --set alpha=0.3 --set layer[0].thickness_um=20 ";
    const std::string at = " --incident 45 --outgoing 30,180 --wavelength 550 ";
    for (const std::string& arguments : {"eval FILE" + at, std::string("measure FILE -q"),
                                         "reference FILE --samples 2000 -q" + at}) {
        const Outcome changed = nacre(test::replaced(arguments, "FILE", set + "gray.toml"));
        const Outcome wanted = nacre(test::replaced(arguments, "FILE", "other.toml"));
        EXPECT_EQ(changed.status, 0) << changed.err;
        EXPECT_EQ(changed.out, wanted.out) << arguments;
    }
    EXPECT_EQ(contents(folder_ / "gray.toml"), gray);
}

TEST_F(Program, SetIsSolvedAndRenderedAndSaid) {
    ASSERT_EQ(nacre("solve gray.toml --set alpha=0.3 --set name=Wider --wavelength 550 -o w.h5 "
                    "--report report.json -q")
                  .status,
              0);
    const Outcome info = nacre("info w.h5");
    EXPECT_THAT(info.out, AllOf(HasSubstr("Wider"), HasSubstr("0.3")));
    EXPECT_THAT(nacre("info gray.toml --set name=Wider").out,
                AllOf(HasSubstr("Wider"), HasSubstr("changed by --set")));
    const auto report = nlohmann::json::parse(contents(folder_ / "report.json"));
    EXPECT_EQ(report["set"], (std::vector<std::string>{"alpha=0.3", "name=Wider"}));
    // A solved paint is solved anew.
    const std::string at = " --incident 45 --outgoing 30,180 --wavelength 550";
    EXPECT_EQ(nacre("eval w.h5 --set alpha=0.2" + at).out, nacre("eval gray.toml" + at).out);
    const std::string picture = " --model microflake --spp 1 --size 8x8 -q -o ";
    ASSERT_EQ(nacre("render sphere --paint gray.toml --set layer[0].flakes[0].reflectance=0" +
                    picture + "a.exr")
                  .status,
              0);
    ASSERT_EQ(nacre("render sphere --paint gray.toml" + picture + "b.exr").status, 0);
    EXPECT_NE(contents(folder_ / "a.exr"), contents(folder_ / "b.exr"));
    EXPECT_EQ(nacre("render sphere --set alpha=0.3" + picture + "c.exr").status, 1);
}

TEST_F(Program, SetFindsFilesWhereTheCommandRuns) {
    write("ground.csv", "wavelength_nm,reflectance\n400,0.2\n700,0.4\n");
    std::filesystem::create_directory(folder_ / "elsewhere");
    write("elsewhere/gray.toml", contents(folder_ / "gray.toml"));
    write("elsewhere/beside.csv", contents(folder_ / "ground.csv"));
    const std::string beside =
        nacre("measure gray.toml --set substrate.reflectance=ground.csv").out;
    EXPECT_FALSE(beside.empty());
    EXPECT_NE(beside, nacre("measure gray.toml").out);
    for (const std::string name : {"ground.csv", "beside.csv"}) {
        EXPECT_EQ(nacre("measure elsewhere/gray.toml --set substrate.reflectance=" + name).out,
                  beside)
            << name;
    }
    EXPECT_EQ(nacre("measure elsewhere/gray.toml --set substrate.reflectance=none.csv").status, 1);
}

TEST_F(Program, SetChangesTheStartOfAFit) {
    write("start.toml", contents(folder_ / "gray.toml") + "# The end.\n");
    const Outcome fit = nacre(
        "fit gray.toml --start start.toml --set area_density_per_um=0.05 "
        "--free alpha,area_density_per_um --starts 1 -q --format json "
        "-o fitted.toml");
    ASSERT_EQ(fit.status, 0) << fit.err;
    EXPECT_EQ(nlohmann::json::parse(fit.out)["numbers"][1]["start"], 0.05);
    EXPECT_THAT(contents(folder_ / "fitted.toml"), ::testing::EndsWith("# The end.\n"));
}

TEST_F(Program, SetRefusesWhatTheRecipeCannotBe) {
    write("lab.csv", "geometry,L,a,b\n45as15,90,1,2\n");
    const struct {
        const char* arguments;
        int status;
        const char* says;
    } cases[] = {
        {"measure gray.toml --set alpha", 1, "--set alpha: must be KEY=VALUE"},
        {"measure gray.toml --set =3", 1, "--set =3: must be KEY=VALUE"},
        {"measure gray.toml --set alpha=3", 1,
         "--set alpha=3: layer[0].flakes[0].orientation.alpha = 3: must be"},
        {"measure gray.toml --set alhpa=0.3", 1, "did you mean 'alpha'"},
        {"measure gray.toml --set reflectance=0.3", 1, "may mean"},
        {"measure lab.csv --set alpha=0.3", 2, "a recipe is needed here"},
        {"atlas --film TiO2_anatase --thickness 40:80:20 --set alpha=0.3", 1, "--set belongs to"},
    };
    for (const auto& wrong : cases) {
        const Outcome outcome = nacre(wrong.arguments);
        EXPECT_EQ(outcome.status, wrong.status) << wrong.arguments << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(wrong.says)) << wrong.arguments;
        EXPECT_THAT(outcome.out, IsEmpty());
    }
}

TEST_F(Program, SetTakesQuotedFilesAndTables) {
    write("glass.csv", "wavelength_nm,n,k\n380,1.45,0\n780,1.46,0\n");
    std::filesystem::create_directory(folder_ / "elsewhere");
    write("elsewhere/gray.toml", contents(folder_ / "gray.toml"));
    const std::string elsewhere = "measure elsewhere/gray.toml -q --set ";
    const std::string glass = nacre(elsewhere + "ior=glass.csv").out;
    EXPECT_FALSE(glass.empty());
    EXPECT_EQ(nacre(elsewhere + "'ior=\"glass.csv\"'").out, glass);
    const std::string coat = nacre(elsewhere + "clearcoat.thickness_um=10").out;
    EXPECT_FALSE(coat.empty());
    EXPECT_EQ(nacre(elsewhere + "'clearcoat={ thickness_um = 10 }'").out, coat);
}

}  // namespace

}  // namespace nacre::cli::testing
