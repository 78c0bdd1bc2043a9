#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/cli/program_test_support.h"
#include "nacre/io/recipe_file.h"
#include "nacre/testing/files.h"

// `nacre fit` as a colour designer meets it.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The grey paint of the fixture with other numbers, and bounds.
const char* const kStart = R"(ior = 1.5
[[layer]]
thickness_um = 15
[[layer.flakes]]
area_density_per_um = 0.05
orientation = { distribution = "beckmann", alpha = 0.3 }
reflectance = 0.6
[fit]
"layer[0].flakes[0].area_density_per_um" = [0.02, 0.2]
"layer[0].flakes[0].orientation.alpha" = [0.1, 0.5]
)";

double value_of(const nlohmann::json& report, std::size_t number) {
    return report["numbers"][number]["value"];
}

TEST_F(Program, FitFindsAHiddenRecipe) {
    write("start.toml", kStart);
    const Outcome fit =
        nacre("fit gray.toml --start start.toml --starts 1 -o fitted.toml --report report.json");
    ASSERT_EQ(fit.status, 0) << fit.err;
    EXPECT_THAT(fit.out, AllOf(HasSubstr("layer[0].flakes[0].orientation.alpha"),
                               HasSubstr("45as110"), HasSubstr("Converged")));
    const auto report = nlohmann::json::parse(contents(folder_ / "report.json"));
    EXPECT_EQ(report["command"], "fit");
    EXPECT_NEAR(value_of(report, 0), 0.1, 1e-4);
    EXPECT_NEAR(value_of(report, 1), 0.2, 1e-4);
    EXPECT_LT(report["difference"]["mean_delta_e_2000"], 0.01);
    // What is written is a recipe with the bounds that it was fitted in.
    const io::RecipeFile fitted = io::read_recipe_file(folder_ / "fitted.toml");
    EXPECT_EQ(fitted.bounds.size(), 2u);
    EXPECT_EQ(paint::find_parameter(fitted.recipe, "layer[0].flakes[0].orientation.alpha").value,
              value_of(report, 1));
    const Outcome compared = nacre("measure fitted.toml --versus gray.toml --format json -q");
    EXPECT_LT(nlohmann::json::parse(compared.out)["mean_delta_e_2000"], 0.01);
}

TEST_F(Program, FitTakesMeasuredFilesAndSpeaksJson) {
    write("start.toml", kStart);
    ASSERT_EQ(nacre("measure gray.toml -q --geometry astm-e2194 -o standard.csv").status, 0);
    const Outcome fit = nacre(
        "fit standard.csv --start start.toml --free alpha,area_density_per_um --starts 1 "
        "--also A,FL11 --weights 45as15=2 --noise 0.1 --format json -q");
    ASSERT_EQ(fit.status, 0) << fit.err;
    EXPECT_THAT(fit.err, IsEmpty());
    const auto json = nlohmann::json::parse(fit.out);
    EXPECT_EQ(json["difference"]["angles"].size(), 3u);
    EXPECT_EQ(json["noise_delta_e"], 0.1);
    EXPECT_EQ(json["noise_given"], true);
    EXPECT_EQ(json["numbers"][0]["key"], "layer[0].flakes[0].orientation.alpha");  // as asked
    EXPECT_EQ(json["numbers"][0]["bounds"][1], 0.5);
    EXPECT_NEAR(value_of(json, 0), 0.2, 1e-4);
    EXPECT_EQ(json["correlation"].size(), 2u);
    EXPECT_TRUE(json["other_lights"].contains("FL11"));
}

TEST_F(Program, FitAgreesWithTheModelOfItsStandard) {
    // Large flakes, whose hot spot microflake does not have.
    std::string large = kStart;
    large.replace(large.find("reflectance"), 0, "diameter_um = 40\n");
    write("start.toml", large);
    ASSERT_EQ(nacre("measure start.toml -q --model nacre -o seen.csv").status, 0);
    const auto matched = [&](const std::string& arguments) {
        const Outcome fit = nacre("fit " + arguments +
                                  " --start start.toml --free area_density_per_um --starts 1 "
                                  "--format json -q");
        EXPECT_EQ(fit.status, 0) << fit.err;
        return nlohmann::json::parse(fit.out);
    };
    for (const char* standard : {"seen.csv", "start.toml"}) {
        const auto json = matched(std::string(standard) + " --model nacre");
        EXPECT_EQ(json["hot_spot"], true);
        EXPECT_NEAR(value_of(json, 0), 0.05, 5e-4) << standard;  // the tables of the model
        EXPECT_LT(json["difference"]["mean_delta_e_2000"], 0.05);
    }
    EXPECT_GT(std::abs(value_of(matched("seen.csv"), 0) - 0.05), 2e-3);
    EXPECT_EQ(matched("start.toml --model nacre --no-hot-spot")["hot_spot"], false);
    // Then sizes matter too.
    const Outcome sizes = nacre(
        "fit seen.csv --start start.toml --free diameter_um --starts 1 "
        "--model nacre --format json -q");
    ASSERT_EQ(sizes.status, 0) << sizes.err;
    EXPECT_NEAR(value_of(nlohmann::json::parse(sizes.out), 0), 40, 1);
}

TEST_F(Program, FitRefusesWhatItCannotDo) {
    write("start.toml", kStart);
    write("lab.csv", "geometry,L,a,b\n45as15,90,1,2\n");
    write("facets.toml", kMicrofacetRecipe);
    const struct {
        const char* arguments;
        int status;
        const char* says;
    } cases[] = {
        {"fit gray.toml --start gray.toml", 1, "--free: say which numbers of gray.toml are free"},
        {"fit gray.toml --start gray.toml --free alhpa", 1, "is not a number of this recipe"},
        {"fit gray.toml --start gray.toml --free ,", 1, "--free"},
        {"fit gray.toml --start start.toml --starts 0", 1, "--starts"},
        {"fit gray.toml --start start.toml --noise none", 1, "--noise"},
        {"fit gray.toml --start start.toml --also moon", 1, "--also = moon"},
        {"fit gray.toml --start start.toml --weights 45as15=-1", 1, "weight"},
        {"fit gray.toml --start start.toml --free diameter_um", 2, "does not change the colours"},
        {"fit lab.csv --start start.toml --also A", 2, "has no spectra"},
        {"fit gray.toml --start facets.toml --free alpha", 2, "needs at least one [[layer]]"},
        {"fit none.csv --start start.toml", 2, "none.csv"},
    };
    for (const auto& wrong : cases) {
        const Outcome outcome = nacre(std::string(wrong.arguments) + " -o out.toml");
        EXPECT_EQ(outcome.status, wrong.status) << wrong.arguments << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(wrong.says)) << wrong.arguments;
        EXPECT_THAT(outcome.out, IsEmpty());
        EXPECT_FALSE(exists("out.toml")) << wrong.arguments;
    }
}

TEST_F(Program, FitSaysThatAStandardIsNotMatched) {
    write("start.toml", kStart);
    write("lab.csv", "geometry,L,a,b\n45as15,60,70,10\n45as45,30,60,10\n45as110,10,20,5\n");
    const std::string arguments = "fit lab.csv --start start.toml --starts 1";
    const Outcome fit = nacre(arguments + " -o fitted.toml --report report.json");
    EXPECT_EQ(fit.status, 4) << fit.err;
    EXPECT_THAT(fit.out, AllOf(HasSubstr("NOT MATCHED: the mean is above 1"), HasSubstr("chroma ("),
                               HasSubstr("too dull by")));
    EXPECT_TRUE(exists("fitted.toml"));
    const auto report = nlohmann::json::parse(contents(folder_ / "report.json"));
    EXPECT_EQ(report["matched"], false);
    EXPECT_EQ(report["missing"][0]["attribute"], "chroma");
    EXPECT_LT(report["missing"][0]["angles"][0]["delta"], -10);
    EXPECT_EQ(nacre(arguments + " --within 100 -q").status, 0);
    EXPECT_EQ(nacre(arguments + " --within 0 -q").status, 1);
}

TEST_F(Program, FitNamesWhatWouldHelp) {
    write("start.toml", kStart);
    const Outcome fit = nacre(
        "fit gray.toml --start start.toml --free area_density_per_um "
        "--starts 1 --within 0.01 -q");
    EXPECT_EQ(fit.status, 4) << fit.err;
    EXPECT_THAT(fit.out, HasSubstr("  free alpha: mean Delta E about"));
}

TEST_F(Program, FitPassesOverWhatCannotBeFree) {
    write("start.toml", kStart);
    const Outcome fit = nacre(
        "fit gray.toml --start start.toml --free '*' --starts 1 "
        "--report report.json");
    ASSERT_EQ(fit.status, 0) << fit.err;
    EXPECT_THAT(fit.err, HasSubstr("--free passes over layer[0].flakes[0].diameter_um: does not "
                                   "change the colours"));
    const auto report = nlohmann::json::parse(contents(folder_ / "report.json"));
    EXPECT_GT(report["skipped"].size(), 1u);
    EXPECT_GT(report["numbers"].size(), 3u);
}

TEST_F(Program, FitKeepsTheCommentsOfTheStartAndReplacesItOnlyIfTold) {
    const std::string mine = "# Trial 7\r\n" + std::string(kStart) + "# The end.\n";
    write("start.toml", mine);
    const std::string arguments = "fit gray.toml --start start.toml --starts 1 -q -o ";
    const Outcome refused = nacre(arguments + "start.toml");
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("--output = start.toml: would replace an input"),
                                   HasSubstr("--overwrite allows it")));
    EXPECT_EQ(contents(folder_ / "start.toml"), mine);
    EXPECT_EQ(nacre(arguments + "gray.toml --overwrite").status, 1);  // the standard
    EXPECT_EQ(nacre("fit gray.toml --start start.toml --overwrite").status, 1);
    ASSERT_EQ(nacre(arguments + "fitted.toml").status, 0);
    const std::string fitted = contents(folder_ / "fitted.toml");
    EXPECT_THAT(fitted, AllOf(::testing::StartsWith("# Trial 7\r\nior = 1.5\n"),
                              ::testing::EndsWith(mine.substr(mine.find("reflectance")))));
    ASSERT_EQ(nacre(arguments + "start.toml --overwrite").status, 0);
    EXPECT_EQ(contents(folder_ / "start.toml"), fitted);
}

TEST_F(Program, FitWritesHowSureItsNumbersAre) {
    write("start.toml", "# Trial 8\n" + std::string(kStart));
    const std::string arguments = "fit gray.toml --start start.toml --starts 1 -q --noise 0.1 ";
    ASSERT_EQ(nacre(arguments + "-o plain.toml").status, 0);
    EXPECT_THAT(contents(folder_ / "plain.toml"), ::testing::Not(HasSubstr("uncertainty")));
    const Outcome fit = nacre(arguments + "-o sure.toml --with-uncertainty --format json");
    ASSERT_EQ(fit.status, 0) << fit.err;
    const auto report = nlohmann::json::parse(fit.out);
    EXPECT_EQ(report["rewritten"], "");
    const std::string sure = contents(folder_ / "sure.toml");
    EXPECT_THAT(sure, AllOf(::testing::StartsWith(contents(folder_ / "plain.toml")),
                            HasSubstr("\n[uncertainty]\n")));
    const Outcome read = nacre("measure sure.toml --format json");
    ASSERT_EQ(read.status, 0) << read.err;
    const auto known = nlohmann::json::parse(read.out)["uncertainty"];
    ASSERT_EQ(known["numbers"].size(), report["numbers"].size());
    for (std::size_t i = 0; i < known["numbers"].size(); ++i) {
        const double error = report["numbers"][i]["standard_error"];
        EXPECT_EQ(known["numbers"][i]["key"], report["numbers"][i]["key"]);
        EXPECT_NEAR(known["numbers"][i]["sd"].get<double>() / error, 1, 1e-3);
        for (std::size_t j = 0; j < known["numbers"].size(); ++j) {
            EXPECT_NEAR(known["correlation"][i][j].get<double>(),
                        report["correlation"][i][j].get<double>(), 1e-6);
        }
    }
    EXPECT_EQ(nacre("fit gray.toml --start start.toml --with-uncertainty").status, 1);
}

TEST_F(Program, FitSaysWhereCommentsAreLost) {
    std::filesystem::create_directory(folder_ / "out");
    write("primer.csv", "wavelength_nm,r\n380,0.1\n780,0.1\n");
    write("start.toml",
          "# Mine\n" +
              test::replaced(kStart, "[fit]", "[substrate]\nreflectance = \"primer.csv\"\n[fit]"));
    const Outcome fit = nacre(
        "fit gray.toml --start start.toml --starts 1 --within 100 "
        "-o out/fitted.toml");
    ASSERT_EQ(fit.status, 0) << fit.err;
    EXPECT_THAT(fit.err, AllOf(HasSubstr("out/fitted.toml is written anew, without the comments"),
                               HasSubstr("primer.csv")));
    EXPECT_EQ(nacre("info out/fitted.toml").status, 0);
}

TEST_F(Program, OtherCommandsIgnoreTheBoundsOfAFit) {
    write("start.toml", kStart);
    write("bare.toml", std::string(kStart, std::string(kStart).find("[fit]")));
    const std::string arguments = " --incident 45 --outgoing 30,180 --wavelength 550";
    EXPECT_EQ(nacre("eval start.toml" + arguments).out, nacre("eval bare.toml" + arguments).out);
}

}  // namespace

}  // namespace nacre::cli::testing
