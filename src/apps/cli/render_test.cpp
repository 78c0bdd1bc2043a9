#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/cli/program_test_support.h"

// `nacre render`: how noisy a picture is, and pictures that turn.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(Program, RenderTellsItsNoise) {
    const std::string render =
        "render sphere --paint gray.toml --model microflake --size 128x128 -o out.exr --report "
        "r.json ";
    const Outcome few = nacre(render + "--spp 4");
    EXPECT_THAT(few.err, HasSubstr("4 samples each, noise "));
    const double at_4 = nlohmann::json::parse(contents(folder_ / "r.json"))["noise"];
    EXPECT_THAT(nacre("info out.exr").out, HasSubstr("nacre:noise: "));
    const Outcome enough = nacre(render + fmt::format("--noise {}", at_4 / 4));
    ASSERT_EQ(enough.status, 0) << enough.err;
    const auto report = nlohmann::json::parse(contents(folder_ / "r.json"));
    EXPECT_GE(report["samples_per_pixel"], 16);
    EXPECT_LE(report["noise"], 1.2 * at_4 / 4);
    EXPECT_THAT(nacre(render + "--noise 0.0001 --spp 16").err,
                HasSubstr("16 samples were the most that --spp allows"));
    EXPECT_EQ(nacre(render + "--noise 0").status, 1);
}

TEST_F(Program, RenderTurnsThePaintFromFrameToFrame) {
    const std::string render =
        "render curved-panel --paint gray.toml --model microflake --size 32x24 --spp 2 -q ";
    const Outcome frames =
        nacre(render + "-o turn.exr --frames 0:2 --turntable shape --step 30 --report r.json");
    ASSERT_EQ(frames.status, 0) << frames.err;
    for (const char* file : {"turn.0000.exr", "turn.0001.png", "turn.0002.exr"}) {
        EXPECT_TRUE(exists(file)) << file;
    }
    EXPECT_FALSE(exists("turn.exr"));
    EXPECT_EQ(nlohmann::json::parse(contents(folder_ / "r.json"))["frames"].size(), 3u);
    // Frame 0 is the scene as it is; a shard of the frames has the same pictures.
    EXPECT_EQ(nacre(render + "-o still.exr").status, 0);
    EXPECT_EQ(nacre("diff turn.0000.exr still.exr --max-relative 0").status, 0);
    EXPECT_EQ(nacre("diff turn.0001.exr still.exr --min-psnr 60").status, 4);
    EXPECT_EQ(nacre(render + "-o shard.exr --frames 2:2 --turntable shape --step 30").status, 0);
    EXPECT_EQ(nacre("diff turn.0002.exr shard.0002.exr --max-relative 0").status, 0);

    EXPECT_THAT(nacre(render + "-o x.exr --frames 0:2").err, HasSubstr("--turntable"));
    EXPECT_THAT(nacre(render + "-o x.exr --turntable light").err, HasSubstr("belong to --frames"));
    EXPECT_THAT(nacre(render + "-o x.exr --frames 3:1 --turntable light").err,
                HasSubstr("must be FIRST:LAST"));
}

TEST_F(Program, RenderSaysHowAPictureWasMade) {
    const std::string render = "render macro --paint gray.toml --size 16x16 --spp 1 -q ";
    ASSERT_EQ(nacre(render + "-o usual.exr --report usual.json").status, 0);
    ASSERT_EQ(nacre(render + "--depth 3 --footprint 0.5 --no-hot-spot --frames 1:1 --turntable "
                             "shape --step 30 --exposure -1.5 --gamut display-p3 -o turn.exr "
                             "--report turn.json")
                  .status,
              0);
    EXPECT_THAT(nacre("info usual.exr").out,
                AllOf(HasSubstr("nacre:depth: 8\n"), HasSubstr("nacre:footprint_pixels: 0\n"),
                      HasSubstr("nacre:model_settings:paint: nacre specimen=0 hot_spot=true\n"),
                      HasSubstr("nacre:scene_sha256: "), Not(HasSubstr("nacre:turn"))));
    EXPECT_THAT(nacre("info turn.0001.png").out,
                AllOf(HasSubstr("nacre:depth: 3\n"), HasSubstr("nacre:footprint_pixels: 0.5\n"),
                      HasSubstr("nacre:model_settings:paint: nacre specimen=0 hot_spot=false\n"),
                      HasSubstr("nacre:turntable: shape\n"), HasSubstr("nacre:turn_deg: 30\n")));

    const auto usual = nlohmann::json::parse(contents(folder_ / "usual.json"));
    EXPECT_EQ(usual["depth"], 8);
    EXPECT_EQ(usual["footprint_pixels"], 0);
    EXPECT_EQ(usual["model_settings"]["paint"], "nacre specimen=0 hot_spot=true");
    EXPECT_EQ(usual["exposure_stops"], 0);
    EXPECT_EQ(usual["gamut"], "rec709");
    EXPECT_THAT(nacre("info usual.exr").out,
                HasSubstr("nacre:scene_sha256: " + usual["scene_sha256"].get<std::string>()));
    const auto turn = nlohmann::json::parse(contents(folder_ / "turn.json"))["frames"][0];
    EXPECT_EQ(turn["depth"], 3);
    EXPECT_EQ(turn["footprint_pixels"], 0.5);
    EXPECT_EQ(turn["turn_deg"], 30);
    EXPECT_EQ(turn["exposure_stops"], -1.5);
    EXPECT_EQ(turn["gamut"], "display-p3");
    EXPECT_NE(turn["scene_sha256"], usual["scene_sha256"]);
}

TEST_F(Program, RenderSaysWhereThereIsNothingToSee) {
    ASSERT_EQ(nacre("scene sphere -o away.toml").status, 0);
    std::string scene = contents(folder_ / "away.toml");
    const std::string::size_type shape = scene.find("[[shapes]]");
    ASSERT_NE(shape, std::string::npos);
    const auto at = scene.find("translation_mm = ", shape);
    ASSERT_NE(at, std::string::npos);
    scene.replace(at, scene.find('\n', at) - at, "translation_mm = [0, 5000, 0]");
    write("away.toml", scene);
    const std::string render = "render away.toml --paint gray.toml --spp 1 --size 16x16 -o x.exr";
    const Outcome nothing = nacre(render);
    EXPECT_EQ(nothing.status, 0) << nothing.err;
    EXPECT_THAT(nothing.err, HasSubstr("nacre: warning: away.toml: the camera sees no shape"));
    EXPECT_EQ(nacre(render + " --strict").status, 2);
}

TEST_F(Program, RenderRefusesTheSparkleOfAModelWithoutFlakes) {
    const Outcome outcome = nacre(
        "render sphere --paint gray.toml --model microflake --sparkle --spp 1 --size 16x16 -o "
        "x.exr");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("--sparkle: the model microflake shows no single flakes"));
    EXPECT_FALSE(exists("x.exr"));
}

}  // namespace

}  // namespace nacre::cli::testing
