#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "apps/cli/program_test_support.h"
#include "nacre/io/measured_brdf_file.h"

// `nacre export`, and measured BRDFs in the other commands.

namespace nacre::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const char* const kSmall = " --resolution 24 --incidences 16 --wavelength 450,550,650";
const char* const kDirections =
    " --incident 40 --outgoing 30,180 --outgoing 20,90 --wavelength 550";

TEST_F(Program, ExportedFilesGiveThePaintBack) {
    ASSERT_EQ(nacre(std::string("export gray.toml -q -o gray.bsdf") + kSmall).status, 0);
    ASSERT_EQ(nacre(std::string("export gray.toml -q -o gray_rgb.bsdf --rgb") + kSmall).status, 0);
    ASSERT_EQ(nacre("export gray.toml -q -o gray.binary --cells 60,60,60").status, 0);
    const std::string paint = nacre(std::string("eval gray.toml") + kDirections).out;
    for (const char* file : {"gray.bsdf", "gray_rgb.bsdf", "gray.binary"}) {
        const Outcome back = nacre(std::string("eval ") + file + kDirections);
        EXPECT_EQ(back.status, 0) << back.err;
        for (const int row : {1, 2}) {
            // Small tables of a lobe of alpha 0.2: a few per cent.
            EXPECT_NEAR(number(back.out, row, 5), number(paint, row, 5), 0.05 * number(paint, 1, 5))
                << file;
        }
    }
}

TEST_F(Program, ExportSaysByHowMuchItMisses) {
    const Outcome run =
        nacre(std::string("export gray.toml -o gray.bsdf --report r.json") + kSmall);
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.err, HasSubstr("misses the BRDF by "));
    EXPECT_THAT(contents(folder_ / "r.json"), HasSubstr("\"error_of_flux\""));
    const Outcome info = nacre("info gray.bsdf");
    EXPECT_THAT(info.out, HasSubstr("kind: measured BRDF, adaptive parameterization"));
    EXPECT_THAT(info.out, HasSubstr("theta_i: 16 from 0 to 89 deg"));
    EXPECT_THAT(info.out, HasSubstr("wavelengths: 3 from 450 to 650 nm"));
    ASSERT_EQ(nacre("export gray.bsdf -q -o again.binary --cells 10,10,10").status, 0);
    EXPECT_THAT(nacre("info again.binary").out, HasSubstr("cells: 10 theta_half"));
}

TEST_F(Program, MeasuredBrdfsAreRenderedByOptionAndBySceneFile) {
    ASSERT_EQ(nacre(std::string("export gray.toml -q -o gray.bsdf") + kSmall).status, 0);
    const Outcome sphere = nacre("render sphere --brdf gray.bsdf --spp 1 --size 8x8 -q -o a.exr");
    EXPECT_EQ(sphere.status, 0) << sphere.err;
    EXPECT_THAT(nacre("info a.exr").out, HasSubstr("nacre:model: measured"));
    EXPECT_EQ(nacre("render sphere --paint gray.bsdf --spp 1 --size 8x8 -q -o b.exr").status, 0);
    EXPECT_EQ(nacre("diff a.exr b.exr").status, 0);

    const std::string scene = R"(
[environment]
type = "constant"
[materials.measured]
type = "paint"
recipe = "gray.bsdf"
[[shapes]]
type = "sphere"
material = "measured"
)";
    write("measured.toml", scene);
    write("both.toml", scene + R"(
[materials.solved]
type = "paint"
recipe = "gray.toml"
[[shapes]]
type = "sphere"
material = "solved"
translation_mm = [200, 0, 0]
)");
    const std::string quick = " --spp 1 --size 8x8 -q -o d.exr";
    const Outcome named = nacre("render measured.toml" + quick);
    EXPECT_EQ(named.status, 0) << named.err;
    // A model is for recipes: where there are some it may be named, where there are none it may
    // not.
    EXPECT_EQ(nacre("render both.toml --model nacre" + quick).status, 0);
    EXPECT_THAT(nacre("info d.exr").out, HasSubstr("nacre:model: nacre"));
    const Outcome idle = nacre("render measured.toml --model nacre" + quick);
    EXPECT_EQ(idle.status, 1);
    EXPECT_THAT(idle.err, HasSubstr("models are for recipes"));

    const Outcome model =
        nacre("render sphere --brdf gray.bsdf --model nacre --spp 1 --size 8x8 -o c.exr");
    EXPECT_EQ(model.status, 1);
    EXPECT_THAT(model.err, HasSubstr("shown as it was measured"));
    const Outcome table =
        nacre("render sphere --brdf gray.bsdf --table raw --spp 1 --size 8x8 -o c.exr");
    EXPECT_EQ(table.status, 1);
    EXPECT_THAT(table.err, HasSubstr("tables are made of recipes"));
    const Outcome recipe = nacre("render sphere --brdf gray.toml --spp 1 --size 8x8 -o c.exr");
    EXPECT_EQ(recipe.status, 2);
    EXPECT_THAT(recipe.err, HasSubstr("recipes go with --paint"));
    EXPECT_EQ(nacre("render sphere --brdf gray.bsdf --paint gray.toml -o c.exr").status, 1);
    EXPECT_FALSE(exists("c.exr"));
}

TEST_F(Program, AMeasuredBrdfTakesNoModelAndHasNoRecipe) {
    ASSERT_EQ(nacre(std::string("export gray.toml -q -o gray.bsdf") + kSmall).status, 0);
    const Outcome model = nacre(std::string("eval gray.bsdf --model microflake") + kDirections);
    EXPECT_EQ(model.status, 1);
    EXPECT_THAT(model.err, HasSubstr("--model = microflake: gray.bsdf holds a measured BRDF"));
    EXPECT_EQ(nacre(std::string("eval gray.bsdf --part single") + kDirections).status, 1);
    const Outcome solved = nacre("solve gray.bsdf -o gray.h5");
    EXPECT_EQ(solved.status, 2);
    EXPECT_THAT(solved.err, HasSubstr("gray.bsdf: holds a measured BRDF; a recipe is needed"));
    EXPECT_EQ(nacre(std::string("reference gray.bsdf") + kDirections).status, 2);
}

TEST_F(Program, BesideAMeasuredBrdfTheModelIsThatOfThePaint) {
    ASSERT_EQ(nacre(std::string("export gray.toml -q -o gray.bsdf") + kSmall).status, 0);
    const Outcome both = nacre(
        "measure gray.toml --versus gray.bsdf --model microflake --geometry 45as45 --format json");
    EXPECT_EQ(both.status, 0) << both.err;
    EXPECT_THAT(both.out, HasSubstr("\"model\": \"microflake\""));
    EXPECT_THAT(both.out, HasSubstr("\"model\": \"\""));
    EXPECT_EQ(nacre("measure gray.bsdf --versus gray.bsdf --model microflake").status, 1);
}

TEST_F(Program, ExportFitsMaterialsAndSaysByHowMuchTheyMiss) {
    write("gray.gltf.svg", "<!-- nacre:chips -->");
    for (const std::string file : {"gray.gltf", "gray.mtlx"}) {
        const Outcome run =
            nacre("export gray.toml -o " + file + " --wavelength 400:700:30 --report r.json");
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_THAT(run.err, HasSubstr("45as110"));
        EXPECT_THAT(run.err, HasSubstr("a fit, not the paint. Delta E 2000, mean and greatest: "));
        EXPECT_THAT(
            contents(folder_ / file),
            HasSubstr(file == "gray.gltf" ? "\"nacre_delta_e_2000\"" : "CIEDE2000 from the paint"));
        EXPECT_THAT(contents(folder_ / (file + ".svg")),
                    AllOf(StartsWith("<!-- nacre:chips -->"), HasSubstr("<svg")));
        EXPECT_THAT(contents(folder_ / "r.json"), HasSubstr("\"tested\""));
    }
    // The picture has replaced one of Nacre's own; it replaces no other.
    write("gray.gltf.svg", "<svg/>");
    const Outcome kept = nacre("export gray.toml -q -o gray.gltf --wavelength 400:700:30");
    EXPECT_EQ(kept.status, 2);
    EXPECT_THAT(kept.err, HasSubstr("gray.gltf.svg: is no picture of Nacre's"));
    EXPECT_EQ(contents(folder_ / "gray.gltf.svg"), "<svg/>");
    EXPECT_EQ(nacre("export gray.toml -q -o a.gltf --chips gray.toml").status, 1);
    EXPECT_THAT(nacre("export gray.toml -q -o a.gltf --chips a.jpg").err,
                HasSubstr("--chips = a.jpg: must end in .svg or .png"));
    EXPECT_EQ(nacre("export gray.toml -q -o a.gltf --rgb").status, 1);
    EXPECT_EQ(nacre("export gray.toml -q -o a.bsdf --chips a.svg").status, 1);
    EXPECT_FALSE(exists("a.gltf"));
    ASSERT_EQ(nacre("export gray.toml -q -o b.gltf --chips b.png --wavelength 400:700:30").status,
              0);
    EXPECT_THAT(contents(folder_ / "b.png"), StartsWith("\x89PNG"));
}

TEST_F(Program, ExportWritesAShaderForThreejs) {
    // A name that looks like a place of the module's to be filled is a name.
    write("named.toml", "name = \"'@TABLE@' </script>\"\n" + contents(folder_ / "gray.toml"));
    const Outcome run = nacre("export named.toml -o gray.three.js --report r.json");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("  75as75   Delta E 2000  0.0"));
    EXPECT_THAT(run.err, HasSubstr("the model's own shader. Delta E 2000 from nacre"));
    const std::string module = contents(folder_ / "gray.three.js");
    EXPECT_THAT(module,
                AllOf(HasSubstr("\"name\": \"'@TABLE@' </script>\""),
                      HasSubstr("export function createMaterial"), Not(HasSubstr("'@SMOOTH@'"))));
    EXPECT_THAT(contents(folder_ / "gray.three.js.svg"), HasSubstr("<svg"));
    EXPECT_THAT(contents(folder_ / "r.json"),
                AllOf(HasSubstr("\"format\": \"three.js\""), HasSubstr("\"model\": \"nacre\"")));

    EXPECT_EQ(nacre("export gray.toml -q -o m.three.js --model microflake --report r.json").status,
              0);
    EXPECT_THAT(contents(folder_ / "r.json"), HasSubstr("\"model\": \"microflake\""));
    for (const char* arguments :
         {" --wavelength 400:700:30", " --rgb", " --model thin-film", " --table svd"}) {
        EXPECT_NE(nacre(std::string("export gray.toml -q -o a.three.js") + arguments).status, 0)
            << arguments;
    }
    EXPECT_FALSE(exists("a.three.js"));
}

TEST_F(Program, ExportRefusesAnisotropicSurfaces) {
    constexpr float kPi = std::numbers::pi_v<float>;
    bsdf::RglTable table;
    table.phi_i = {-kPi, 0, kPi};
    table.theta_i = {0, 1};
    table.ndf.values = table.sigma.values = {1, 1, 1, 1};
    table.vndf.assign(3 * 2 * 4, 1);
    table.luminance.assign(3 * 2 * 4, 1);
    table.spectra.assign(3 * 2 * 3 * 4, 0.3f);
    io::write_rgl(folder_ / "brushed.bsdf", table);
    EXPECT_EQ(nacre(std::string("eval brushed.bsdf") + kDirections).status, 0);
    const Outcome refused = nacre("export brushed.bsdf -o again.bsdf");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("brushed.bsdf: holds an anisotropic BRDF"));
    EXPECT_FALSE(exists("again.bsdf"));

    write("leaning.toml", "lean = { tilt_deg = 6 }\n" + contents(folder_ / "gray.toml"));
    for (const char* suffix : {".bsdf", ".binary", ".gltf", ".mtlx", ".blender.py", ".three.js"}) {
        const Outcome leaning = nacre(std::string("export leaning.toml -q -o leaning") + suffix);
        EXPECT_EQ(leaning.status, 2) << suffix;
        EXPECT_THAT(leaning.err, HasSubstr("leaning.toml: lean.tilt_deg = 6: ")) << suffix;
        EXPECT_FALSE(exists(std::string("leaning") + suffix));
    }
}

TEST_F(Program, ControlCharactersOfNamesAreNotPrinted) {
    write("escape.toml", "name = \"a\\u001b[31mb\"\n" + contents(folder_ / "gray.toml"));
    const Outcome info = nacre("info escape.toml");
    EXPECT_EQ(info.status, 0) << info.err;
    EXPECT_THAT(info.out, HasSubstr("name: a\\x1b[31mb\n"));
}

TEST_F(Program, ExportRefusesWhatDoesNotFitItsFormat) {
    for (const char* arguments :
         {"export gray.toml", "export gray.toml -o gray.csv", "export gray.toml -o a.binary --rgb",
          "export gray.toml -o a.binary --resolution 9", "export gray.toml -o a.bsdf --cells 9,9,9",
          "export gray.toml -o a.binary --cells 9,9",
          "export gray.toml -o a.binary --cells 9,9,1.5",
          "export gray.toml -o a.bsdf --resolution 1", "export gray.toml -o a.bsdf --model walk"}) {
        EXPECT_EQ(nacre(arguments).status, 1) << arguments;
    }
    write("cut.bsdf", std::string("tensor_file\0\1\0\7\0\0\0", 18));
    for (const char* arguments : {"info cut.bsdf", "export cut.bsdf -o a.binary",
                                  "eval cut.bsdf --incident 45 --outgoing 0"}) {
        const Outcome cut = nacre(arguments);
        EXPECT_EQ(cut.status, 2) << arguments;
        EXPECT_THAT(cut.err, StartsWith("nacre: cut.bsdf: field 0 is cut short"));
    }
    EXPECT_FALSE(exists("a.binary") || exists("a.bsdf"));
}

TEST_F(Program, MeasuredBrdfsHaveNoFlakes) {
    ASSERT_EQ(nacre(std::string("export gray.toml -q -o gray.bsdf") + kSmall).status, 0);
    const std::string render = "render sphere --brdf gray.bsdf --spp 1 --size 8x8 -q -o a.exr ";
    for (const auto& [option, said] : {std::pair{"--sparkle", "--sparkle"},
                                       {"--footprint 2", "--footprint"},
                                       {"--specimen 3", "--specimen = 3"},
                                       {"--no-hot-spot", "--no-hot-spot"}}) {
        const Outcome outcome = nacre(render + option);
        EXPECT_EQ(outcome.status, 1) << option;
        EXPECT_THAT(outcome.err, HasSubstr(std::string(said) + ": every"));
        EXPECT_FALSE(exists("a.exr")) << option;
    }
    for (const auto& [command, said] :
         {std::pair{"measure gray.bsdf --no-hot-spot", "--no-hot-spot"},
          {"measure gray.bsdf --specimen 3", "--specimen = 3"},
          {"eval gray.bsdf --incident 45 --outgoing 0 --specimen 3", "--specimen = 3"}}) {
        const Outcome outcome = nacre(command);
        EXPECT_EQ(outcome.status, 1) << command;
        EXPECT_THAT(outcome.err,
                    HasSubstr(std::string(said) + ": gray.bsdf holds a measured BRDF"));
    }
    const Outcome sparkle = nacre("sparkle gray.bsdf");
    EXPECT_EQ(sparkle.status, 2);
    EXPECT_THAT(sparkle.err,
                AllOf(HasSubstr("measured BRDF, which has no flakes"), Not(HasSubstr("--model"))));
}

}  // namespace
}  // namespace nacre::cli::testing
