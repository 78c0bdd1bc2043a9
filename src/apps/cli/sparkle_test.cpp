#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "apps/cli/program_test_support.h"

namespace nacre::cli::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const char* const kSmallField = "sparkle gray.toml --field 2 --diffuse-samples 4 ";

TEST_F(Program, SparkleWritesARowALampAndOneForDiffuseLight) {
    const Outcome run = nacre(std::string(kSmallField) + "--lamp 15,60 -q");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_THAT(run.out, StartsWith("geometry,theta_i,Y,background_Y,threshold_Y,spots_per_cm2,"));
    EXPECT_EQ(cell(run.out, 1, 0), "15s");
    EXPECT_EQ(cell(run.out, 2, 0), "60s");
    EXPECT_EQ(cell(run.out, 3, 0), "diffuse");
    EXPECT_GT(number(run.out, 1, 5), 0);   // spots
    EXPECT_GT(number(run.out, 3, 15), 0);  // graininess
    EXPECT_EQ(cell(run.out, 3, 5), "");
    EXPECT_EQ(cell(run.out, 1, 15), "");
}

TEST_F(Program, SparkleDependsOnTheSeedAndNotOnTheThreads) {
    const std::string one = nacre(std::string(kSmallField) + "-q --threads 1").out;
    EXPECT_EQ(nacre(std::string(kSmallField) + "-q --threads 2").out, one);
    EXPECT_NE(nacre(std::string(kSmallField) + "-q --seed 1").out, one);
}

TEST_F(Program, SparkleWritesJsonAndPictures) {
    const Outcome run = nacre(std::string(kSmallField) +
                              "--format json --pictures seen -o sparkle.json --report r.json");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, IsEmpty());
    const auto json = nlohmann::json::parse(contents(folder_ / "sparkle.json"));
    EXPECT_EQ(json["model"], "nacre");
    EXPECT_EQ(json["readings"].size(), 4u);
    EXPECT_GT(json["readings"][3]["graininess"]["value"], 0);
    for (const char* name : {"15s", "45s", "75s", "diffuse"}) {
        EXPECT_TRUE(exists(std::string("seen/") + name + ".png")) << name;
        EXPECT_TRUE(exists(std::string("seen/") + name + ".exr")) << name;
    }
    EXPECT_EQ(nlohmann::json::parse(contents(folder_ / "r.json"))["command"], "sparkle");
}

const char* const kCoated = R"(name = "Coated"
ior = 1.5
[clearcoat]
thickness_um = 40
absorption_per_mm = 2
[[layer]]
thickness_um = 15
[[layer.flakes]]
area_density_per_um = 0.1
diameter_um = 20
reflectance = 0.6
transmittance = 0
thickness_um = 0.3
orientation = { distribution = "beckmann", alpha = 0.12 }
)";

TEST_F(Program, SparkleSeesWavesOfTheCoatAndSaysThatItSeesItsMeanThickness) {
    write("coated.toml", kCoated);
    const std::string small =
        "sparkle coated.toml --field 2 --lamp 20 --diffuse-samples 0 --format json ";
    const Outcome even = nacre(small);
    ASSERT_EQ(even.status, 0) << even.err;
    EXPECT_THAT(even.err, Not(HasSubstr("mean thickness")));
    EXPECT_EQ(nlohmann::json::parse(even.out)["of_mean_coat_thickness"], false);
    const Outcome uneven = nacre(small + "--set clearcoat.thickness_spread_um=4");
    ASSERT_EQ(uneven.status, 0) << uneven.err;
    EXPECT_THAT(uneven.err,
                HasSubstr("clearcoat.thickness_spread_um = 4: the camera sees the mean"));
    const auto json = nlohmann::json::parse(uneven.out);
    EXPECT_EQ(json["of_mean_coat_thickness"], true);
    EXPECT_EQ(json["readings"], nlohmann::json::parse(even.out)["readings"]);
    const Outcome wavy = nacre(small + "--set clearcoat.orange_peel.wb=0.02");
    ASSERT_EQ(wavy.status, 0) << wavy.err;
    EXPECT_NE(nlohmann::json::parse(wavy.out)["readings"], json["readings"]);
}

TEST_F(Program, SparkleTakesTheModelSpecialEffect) {
    write("facets.toml", kMicrofacetRecipe + std::string(R"([microfacet.facets]
count = 4_000_000
cone_deg = 3.0
thickness_spread_nm = 10.0
)"));
    const Outcome run = nacre(
        "sparkle facets.toml --model special-effect --field 2 --lamp 15 --diffuse-samples 4 -q");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_GT(number(run.out, 1, 17), 0.1);  // contrast of the pixels
    EXPECT_EQ(nacre("sparkle facets.toml --model special-effect --field 20 --panel 10").status, 2);
}

TEST_F(Program, SparkleRefusesWhatItCannotMeasure) {
    const struct {
        const char *arguments, *complaint;
        int status;
    } cases[] = {
        {"--model microflake", "shows no single flakes", 1},
        {"--model thin-film", "shows no single flakes", 1},
        {"--model walk", "shows no single flakes", 1},
        {"--flakes explicit", "follows light", 1},
        {"--lamp 15,90", "--lamp", 1},
        {"--lamp 0:85:1", "at most 16", 1},
        {"--format xml", "--format", 1},
        {"--pixel 0", "pixel in um = 0", 2},
        {"--field nan", "--field: Value nan is not a number", 1},
        {"--panel nan", "--panel: Value nan is not a number", 1},
        {"--field 0.5", "--field = 0.5: field of the camera in pixels = 20", 2},
        {"--field 1e9", "field of the camera in pixels", 2},
        {"--field 100 --lamp 1:16:1", "pixels in all pictures", 2},
        {"--lamp-half-angle -1", "half-angle", 2},
        {"--diffuse-samples 5", "must be even", 2},
        {"--distance 1", "viewing distance in mm = 1", 2},
        {"--illuminance 0", "illuminance in lx = 0", 2},
        {"--distance 60", "smaller pixels or a larger distance", 2},
        {"--field 1 --distance 5000", "larger field", 2},
    };
    for (const auto& c : cases) {
        const std::string field =
            std::string(c.arguments).find("--field") == std::string::npos ? "--field 2 " : "";
        const Outcome run = nacre("sparkle gray.toml " + field + c.arguments);
        EXPECT_EQ(run.status, c.status) << c.arguments << run.err;
        EXPECT_THAT(run.err, HasSubstr(c.complaint)) << c.arguments;
        EXPECT_THAT(run.out, IsEmpty()) << c.arguments;
    }
    EXPECT_EQ(nacre("sparkle none.toml").status, 2);
}

}  // namespace
}  // namespace nacre::cli::testing
