#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/cli/program_test_support.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/statistics.h"

// The program as a user meets it: what goes where, and with which exit status.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

TEST_F(Program, EveryCommandExplainsItselfWithAnExample) {
    for (const char* command :
         {"film", "solve", "eval", "reference", "render", "diff", "study", "info", "measure",
          "atlas", "panel", "sparkle", "export", "fit", "materials"}) {
        const Outcome help = nacre(std::string(command) + " --help");
        EXPECT_EQ(help.status, 0) << command;
        EXPECT_THAT(help.out, HasSubstr("Example"));
        EXPECT_THAT(help.out, HasSubstr(std::string("nacre ") + command));
        EXPECT_THAT(help.err, IsEmpty());
    }
    EXPECT_THAT(nacre("--help").out, HasSubstr("Exit status"));
    EXPECT_THAT(nacre("--version").out, StartsWith("nacre "));
}

TEST_F(Program, WrongUsageEndsWithOne) {
    for (const char* arguments :
         {"",
          "paint",
          "film --colour red",
          "solve gray.toml --wavelength 0.5 -o out.h5",
          "film --angle 90.1",
          "film --angle nan",
          "film --wavelength 400:700:-10",
          "film --wavelength 1:2",
          "film --wavelength ,",
          "film --wavelength 0:1e6:1e-3",
          "film --layer 1.5",
          "film --layer 1.5:-3",
          "film --polarization x",
          "eval gray.toml",
          "eval gray.toml --incident 45",
          "eval gray.toml --incident 95 --outgoing 0",
          "eval gray.toml --incident 1,2,3 --outgoing 0",
          "eval gray.toml --incident 45 --outgoing 0 --model nonsense",
          "eval gray.toml --incident 45 --outgoing 0 --model walk",
          "eval gray.toml --incident 45 --outgoing 0 --model thin-film --table raw",
          "eval gray.toml --incident 45 --outgoing 0 --at 0.5,0.5",
          "render speed-shape --paint gray.toml --model volume -o a.exr",
          "study nonsense -o x",
          "study mir-2022 -o x --table 5",
          "eval gray.toml --incident 45 --outgoing 0 --part most",
          "solve gray.toml",
          "render sphere --size 0x10 -o a.exr",
          "render sphere --size 10 -o a.exr",
          "render sphere --paint gray.toml -o a.jpg",
          "render sphere -o a.exr",
          "diff a.exr",
          "info"}) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments << '\n' << outcome.err;
        EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
        EXPECT_THAT(outcome.err, Not(IsEmpty())) << arguments;
    }
}

TEST_F(Program, BadInputEndsWithTwoAndWritesNothing) {
    write("bad.toml", "ior = 1.5\n[[layer]]\nthickness_um = -3\n");
    write("bad.h5", "nacre solved paint\nversion 1\n");
    write("bad_scene.toml", "[camera]\nvertical_fov_deg = 400\n");
    write("picture.png", "\x89PNG\r\n\x1a\n and no more");
    for (const char* arguments :
         {"eval bad.toml --incident 45 --outgoing 0 -o out.csv", "solve bad.toml -o out.h5",
          "reference bad.toml --incident 45 --outgoing 0 -o out.csv",
          "render sphere --paint bad.toml -o out.exr", "render bad_scene.toml -o out.exr",
          "render no-such-scene --paint gray.toml -o out.exr", "info bad.toml -o out.txt",
          "info bad.h5 -o out.txt", "info no-such-file -o out.txt", "info . -o out.txt",
          "diff picture.png picture.png -o out.exr", "film --layer unobtainium:80 -o out.csv"}) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments << '\n' << outcome.err;
        EXPECT_THAT(outcome.out, IsEmpty());
        EXPECT_THAT(outcome.err, StartsWith("nacre: ")) << arguments;
        for (const char* name : {"out.csv", "out.h5", "out.exr", "out.png", "out.txt"}) {
            EXPECT_FALSE(exists(name)) << arguments << " left " << name;
        }
    }
    EXPECT_THAT(nacre("info bad.toml").err,
                HasSubstr("bad.toml:3:16: layer[0].thickness_um = -3: must be a number in "
                          "(0, 1000000] um"));
}

TEST_F(Program, FilmPrintsAPublishedQuarterWave) {
    // MgF2, a quarter wave at 550 nm on glass 1.52: R = ((1.38^2 - 1.52) / (1.38^2 + 1.52))^2.
    const Outcome film =
        nacre("film --layer 1.38:99.6376811594 --substrate 1.52 --wavelength 550 --polarization s");
    EXPECT_EQ(film.status, 0) << film.err;
    EXPECT_THAT(film.out, StartsWith("wavelength_nm,angle_deg,polarization,R,T\n550,0,s,"));
    EXPECT_NEAR(number(film.out, 1, 3), 0.012600790215, 1e-11);
    EXPECT_NEAR(number(film.out, 1, 3) + number(film.out, 1, 4), 1, 1e-11);
}

// The limit: all is reflected, but where there is nothing to reflect.
TEST_F(Program, FilmTakesAnglesUpToTheHorizon) {
    const std::string grazing = "film --angle 90 --wavelength 550 --polarization ";
    for (const char* polarization : {"s", "p", "u"}) {
        const Outcome glass =
            nacre(grazing + polarization + " --substrate 1.52 --layer 1.38:99.6376811594");
        EXPECT_EQ(glass.status, 0) << glass.err;
        EXPECT_NEAR(number(glass.out, 1, 3), 1, 1e-12) << polarization;
        EXPECT_NEAR(number(glass.out, 1, 4), 0, 1e-12) << polarization;
        const Outcome air = nacre(grazing + polarization);
        EXPECT_EQ(number(air.out, 1, 3), 0) << polarization;
        EXPECT_EQ(number(air.out, 1, 4), 1) << polarization;
    }
    EXPECT_THAT(nacre("film --angle 90.1").err, HasSubstr("[0, 90] deg"));
}

TEST_F(Program, InfoTellsWhatIsSolvedInPlaceOfFlakes) {
    EXPECT_THAT(nacre("info gray.toml").out, Not(HasSubstr("solved layer")));
    std::string text = contents(folder_ / "gray.toml");
    text.replace(text.find("reflectance"), 0,
                 "d10_um = 9\nd50_um = 18\nd90_um = 33\nedge_um = 0.3\n");
    write("sheet.toml", text);
    const Outcome info = nacre("info sheet.toml");
    EXPECT_EQ(info.status, 0) << info.err;
    EXPECT_THAT(info.out, HasSubstr("diameters d10 9, d50 18, d90 33 um"));
    EXPECT_THAT(info.out, HasSubstr("4 species of flakes, 1 pigments"));
    EXPECT_THAT(info.out, HasSubstr("edges of flakes"));
}

TEST_F(Program, InfoTellsTheTypicalSizesOfAMedianAlone) {
    std::string text = contents(folder_ / "gray.toml");
    text.replace(text.find("reflectance"), 0, "d50_um = 18\n");
    write("median.toml", text);
    const Outcome info = nacre("info median.toml");
    EXPECT_EQ(info.status, 0) << info.err;
    EXPECT_THAT(info.out, HasSubstr("diameters d10 9, d50 18, d90 36 um (d10 and d90 typical)"));
    EXPECT_THAT(nacre("info median.toml --set layer[0].flakes[0].d50_um=20").out,
                HasSubstr("diameters d10 10, d50 20, d90 40 um (d10 and d90 typical)"));
}

TEST_F(Program, ListsOfNumbersIncludeTheirEnds) {
    const Outcome film = nacre("film --angle 0,30 --wavelength 400:400.3:0.1,700");
    EXPECT_EQ(std::count(film.out.begin(), film.out.end(), '\n'), 1 + 2 * 5);
    EXPECT_DOUBLE_EQ(number(film.out, 8, 0), 400.3);
    EXPECT_EQ(cell(film.out, 10, 0), "700");
}

TEST_F(Program, EvalAgreesForARecipeAndItsSolvedFile) {
    ASSERT_EQ(nacre("solve gray.toml --wavelength 500,600 -o gray.h5 --quiet").err, "");
    const std::string directions = " --incident 45 --outgoing 30,180 --outgoing 45,180";
    const Outcome recipe = nacre("eval gray.toml --wavelength 500,600" + directions);
    const Outcome solved = nacre("eval gray.h5" + directions);
    EXPECT_EQ(recipe.status, 0) << recipe.err;
    EXPECT_EQ(solved.out, recipe.out);
    EXPECT_THAT(solved.out, StartsWith("theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf\n"
                                       "45,0,30,180,500,"));
    const Outcome other = nacre("eval gray.h5 --wavelength 550" + directions);
    EXPECT_EQ(other.status, 2);
    EXPECT_THAT(other.err, HasSubstr("550 nm is not among them"));
}

TEST_F(Program, WarnsOfWhatTheSolverCouldNotResolve) {
    write("sharp.toml", R"(ior = 1.5
[[layer]]
thickness_um = 50
[[layer.pigment]]
scattering_per_mm = 200
anisotropy = 0.95
)");
    const std::string solve = "solve sharp.toml --wavelength 550 -o sharp.h5 ";
    const std::string few = "--nodes 12 --inner-nodes 8 --orders 3 ";
    const Outcome coarse = nacre(solve + few);
    EXPECT_EQ(coarse.status, 0) << coarse.err;
    EXPECT_THAT(coarse.err, HasSubstr("nacre: warning: sharp.toml: 12 + 8 nodes miss "));
    EXPECT_THAT(coarse.err, HasSubstr("solve it without --nodes and --inner-nodes"));
    EXPECT_THAT(coarse.err, HasSubstr("nacre: warning: sharp.toml: the azimuthal series ends "
                                      "after 3 orders at "));
    EXPECT_THAT(coarse.err, HasSubstr("solve it without --orders"));

    // Commands that read the solved file repeat the warning, on stderr alone.
    const Outcome eval = nacre("eval sharp.h5 --incident 45 --outgoing 0");
    EXPECT_THAT(eval.err, HasSubstr("nacre: warning: sharp.h5: 12 + 8 nodes miss "));
    EXPECT_THAT(eval.out, Not(HasSubstr("warning")));
    const Outcome render = nacre("render sphere --paint sharp.h5 --spp 1 --size 4x4 -o sharp.exr");
    EXPECT_EQ(render.status, 0);
    EXPECT_THAT(render.err, HasSubstr("nacre: warning: sharp.h5: 12 + 8 nodes miss "));

    EXPECT_THAT(nacre(solve + few + "--quiet").err, IsEmpty());
    EXPECT_THAT(nacre(solve).err, Not(HasSubstr("warning")));  // what the advice leads to
}

TEST_F(Program, NamesThePigmentThatTheSolverDoesNotResolve) {
    write("sharp.toml",
          "ior = 1.5\n[[layer]]\nthickness_um = 50\n[[layer.pigment]]\nscattering_per_mm = 200\n"
          "anisotropy = 0.98\n");
    for (const char* command : {"solve sharp.toml -o x.h5", "measure sharp.toml"}) {
        const Outcome refused = nacre(command);
        EXPECT_EQ(refused.status, 2) << command;
        EXPECT_THAT(refused.err, HasSubstr("sharp.toml: layer[0].pigment[0].anisotropy = 0.98: "
                                           "must be in [-0.97, 0.97] to be solved"));
    }
    EXPECT_EQ(
        nacre("reference sharp.toml --incident 45 --outgoing 45 --samples 100 --wavelength 550")
            .status,
        0);
}

TEST_F(Program, SingleAndMultipleScatteringMakeUpTheTotal) {
    const std::string arguments =
        "eval gray.toml --wavelength 550 --incident 45 --outgoing 30,180 --part ";
    const double single = number(nacre(arguments + "single").out, 1, 5);
    const double multiple = number(nacre(arguments + "multiple").out, 1, 5);
    const double total = number(nacre(arguments + "total").out, 1, 5);
    EXPECT_GT(single, 0);
    EXPECT_GT(multiple, 0);
    EXPECT_NEAR(single + multiple, total, 1e-8 * total);  // nine digits are printed
}

TEST_F(Program, ReferenceAgreesWithEvalWithinItsError) {
    const std::string where = " gray.toml --wavelength 550 --incident 45 --outgoing 30,180";
    const Outcome walk = nacre("reference" + where + " --samples 400000 --seed 3 --quiet");
    EXPECT_EQ(walk.status, 0) << walk.err;
    EXPECT_THAT(walk.out, StartsWith("theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf,stderr\n"));
    EXPECT_THAT(walk.err, IsEmpty());
    const double solved = number(nacre("eval" + where).out, 1, 5);
    const double error = number(walk.out, 1, 6);
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 1e-3 * solved);
    EXPECT_NEAR(number(walk.out, 1, 5), solved, test::kWorstZ * error);
}

TEST_F(Program, RenderWritesBothPicturesWithTheirOrigin) {
    const std::string arguments =
        "render sphere --paint gray.toml --spp 2 --size 24x16 --seed 5 --quiet --spectral-bins 3 ";
    const Outcome first = nacre(arguments + "--threads 1 -o a.exr --report run.json");
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_THAT(first.out + first.err, IsEmpty());
    ASSERT_EQ(nacre(arguments + "--threads 2 -o b.exr").status, 0);

    const Outcome info = nacre("info a.exr");
    EXPECT_THAT(info.out, HasSubstr("size: 24 x 16 pixels"));
    EXPECT_THAT(info.out, HasSubstr("nacre:seed: 5"));
    EXPECT_THAT(info.out, HasSubstr("nacre:samples_per_pixel: 2"));
    EXPECT_THAT(info.out, HasSubstr("nacre:state: complete"));
    EXPECT_THAT(info.out, HasSubstr("nacre:recipe_sha256:"));
    for (const char* channel :
         {"channel R:", "channel albedo.G:", "channel normal.Z:", "channel S0.550,000000nm:"}) {
        EXPECT_THAT(info.out, HasSubstr(channel));
    }
    EXPECT_THAT(nacre("info a.png").out, HasSubstr("nacre:seed: 5"));
    EXPECT_THAT(contents(folder_ / "run.json"), HasSubstr("\"samples_per_pixel\": 2"));

    const Outcome diff = nacre("diff a.exr b.exr --min-psnr 200");
    EXPECT_EQ(diff.status, 0) << diff.err;  // the number of threads changes nothing
    EXPECT_THAT(diff.out, HasSubstr("\nmse,0\npsnr_db,inf\n"));
}

TEST_F(Program, DiffEndsWithFourWhenABoundIsBroken) {
    const std::string render = "render sphere --paint gray.toml --spp 1 --size 16x16 --quiet ";
    ASSERT_EQ(nacre(render + "--seed 1 -o a.exr").status, 0);
    ASSERT_EQ(nacre(render + "--seed 2 -o b.exr").status, 0);
    const std::string commas = nacre("diff a.exr b.exr --decimal comma --bom").out;
    EXPECT_THAT(commas, StartsWith("\xEF\xBB\xBFquantity;value\nmse;0,"));
    EXPECT_THAT(commas, Not(HasSubstr(".")));
    const Outcome within = nacre("diff a.exr b.exr -o d.png");
    EXPECT_EQ(within.status, 0);
    EXPECT_TRUE(exists("d.png"));
    const Outcome broken = nacre("diff a.exr b.exr -o d.exr --max-delta-e-mean 1e-6");
    EXPECT_EQ(broken.status, 4);
    EXPECT_THAT(broken.err, HasSubstr("is more than 1e-06"));
    EXPECT_THAT(broken.out, HasSubstr("delta_e_2000_mean,"));
    EXPECT_THAT(nacre("info d.exr").out, HasSubstr("channel deltaE2000"));
}

TEST_F(Program, EveryModelIsEvaluatedOrRendered) {
    write("facets.toml", R"(ior = 1.5
[clearcoat]
thickness_um = 40
[microfacet]
alpha = 0.1
film_ior = 2.5
film_thickness_nm = 80
base_ior = 1.58
[microfacet.facets]
count = 1_000_000
cone_deg = 3
thickness_spread_nm = 5
)");
    const std::string directions = " --incident 30 --outgoing 30,180 --wavelength 550 ";
    for (const char* model : {"thin-film", "thin-film --colour table", "special-effect"}) {
        const Outcome eval = nacre(std::string("eval facets.toml --model ") + model + directions);
        EXPECT_EQ(eval.status, 0) << eval.err;
        EXPECT_GT(number(eval.out, 1, 5), 0.01) << model;
    }
    EXPECT_EQ(
        nacre("eval facets.toml --model special-effect --at 1.5,0.5 --footprint 0.1" + directions)
            .status,
        1);
    EXPECT_EQ(nacre("eval facets.toml --model special-effect --at 0.5 --footprint 0.1" + directions)
                  .status,
              1);
    // A patch differs from the mean; one as large as the whole square only by its noise.
    const std::string facets = "eval facets.toml --model special-effect" + directions;
    const double mean = number(nacre(facets).out, 1, 5);
    const double patch = number(nacre(facets + "--at 0.3,0.6 --footprint 0.02").out, 1, 5);
    const double whole = number(nacre(facets + "--at 0.5,0.5 --footprint 1").out, 1, 5);
    EXPECT_NE(patch, mean);
    // Of a million facets those reflect whose normals lie within half of 3 deg of the surface's, a
    // fraction of (1.5 deg / alpha)^2, and their reflectances differ little.
    const double reflecting = 1e6 * std::pow(1.5 * kDegree / 0.1, 2);
    EXPECT_NEAR(whole / mean, 1, test::kWorstZ / std::sqrt(reflecting));
    for (const char* paint : {"facets.toml --model thin-film", "facets.toml --model special-effect",
                              "gray.toml --model walk", "gray.toml --model volume",
                              "gray.toml --model volume --tracking simpson"}) {
        const Outcome render =
            nacre(std::string("render sphere --quiet --spp 1 --size 16x16 -o a.exr "
                              "--paint ") +
                  paint);
        EXPECT_EQ(render.status, 0) << paint << ": " << render.err;
    }
    ASSERT_EQ(nacre("render sphere --paint facets.toml --model special-effect --sparkle --quiet "
                    "--spp 1 --size 16x16 -o s.exr")
                  .status,
              0);
    EXPECT_THAT(nacre("info s.exr").out, HasSubstr("channel sparkle.G:"));
    EXPECT_THAT(nacre("info a.exr").out, Not(HasSubstr("sparkle")));
    const Outcome missing = nacre("eval gray.toml --model special-effect" + directions);
    EXPECT_EQ(missing.status, 2);
    EXPECT_THAT(missing.err, HasSubstr("gray.toml: microfacet: is missing"));
}

TEST_F(Program, SingleFlakesAreEvaluatedInMillimetresAndRendered) {
    const std::string eval =
        "eval gray.toml --incident 20 --outgoing 22,180 --wavelength 550 --model ";
    const double mean = number(nacre(eval + "nacre").out, 1, 5);
    const double smooth = number(nacre(eval + "nacre --no-hot-spot").out, 1, 5);
    EXPECT_NEAR(smooth, number(nacre(eval + "microflake").out, 1, 5), 2e-3 * smooth);  // its table
    EXPECT_GT(mean, 1.05 * smooth);
    EXPECT_EQ(number(nacre(eval + "nacre --hot-spot").out, 1, 5), mean);
    // The same flakes again, and others with another seed: a fan wide enough to meet some.
    const std::string fan =
        "eval gray.toml --incident 20 --outgoing 0:60:1,150:210:5 --wavelength 550 --model nacre "
        "--at 7,3.3 --footprint 0.1";
    const std::string patch = nacre(fan).out;
    EXPECT_THAT(patch, StartsWith("theta_i,"));
    EXPECT_EQ(patch, nacre(fan).out);
    EXPECT_NE(patch, nacre(fan + " --seed 1").out);
    // The flakes of the model at that place: on a flat panel that faces +z.
    const auto paint = std::make_shared<const solver::SolvedPaint>(
        solver::solve(io::read_recipe(folder_ / "gray.toml"), {550}));
    const auto surface = bsdf::Nacre(paint).bind({550, 550, 550, 550, 550, 550, 550, 550});
    const Frame frame = Frame::around({0, 0, 1});
    bsdf::Patch patch_of_fan;
    patch_of_fan.footprint = {{7, 3.3f, 0}, {0, 0, 1}, frame.s, {0.1f * frame.s, 0.1f * frame.t}};
    int row = 0, single = 0;
    for (int theta = 0; theta <= 60; ++theta) {
        for (int phi = 150; phi <= 210; phi += 5) {
            const Vec3f wi = test::direction(20, 0), wo = test::direction(theta, phi);
            const double f = surface->evaluate_on(patch_of_fan, wi, wo).f[0];
            EXPECT_NEAR(number(patch, ++row, 5), f, 1e-3 * f) << theta << ", " << phi;
            single += f > 1.5 * surface->eval(wi, wo)[0];
        }
    }
    EXPECT_GT(single, 10);  // flakes flash
    const Outcome far = nacre(eval + "nacre --at 0,20000 --footprint 1");
    EXPECT_EQ(far.status, 1);
    EXPECT_THAT(far.err, HasSubstr("--at = 20000: must be a number in [-10000, 10000] mm"));
    EXPECT_EQ(nacre(eval + "nacre --at 0,0").status, 1);
    EXPECT_EQ(nacre(eval + "microflake --no-hot-spot").status, 1);

    for (const char* scene : {"sphere", "macro", "panel-sun"}) {
        const Outcome render = nacre(
            std::string("render ") + scene +
            " --paint gray.toml --model nacre --sparkle --quiet --spp 1 --size 16x16 -o a.exr");
        EXPECT_EQ(render.status, 0) << render.err;
        EXPECT_THAT(nacre("info a.exr").out, HasSubstr("channel sparkle.B:")) << scene;
    }
    std::string matte = contents(folder_ / "gray.toml");
    matte.insert(0, "clearcoat = { thickness_um = 40, roughness = 0.2 }\n");
    write("matte.toml", matte);
    const Outcome rough = nacre(
        "render sphere --paint matte.toml --model nacre --sparkle --quiet --spp 1 --size 16x16 -o "
        "b.exr");
    EXPECT_EQ(rough.status, 0) << rough.err;
    EXPECT_THAT(nacre("info b.exr").out, HasSubstr("channel sparkle.B:"));
}

TEST_F(Program, StudyWritesOnePageAndGoesOnWhereItStopped) {
    const std::string study = "study mir-2022 -o s --quick --table 4 --quiet";
    const Outcome first = nacre(study);
    ASSERT_EQ(first.status, 0) << first.err;
    const std::string page = contents(folder_ / "s/index.html");
    EXPECT_THAT(page, HasSubstr("Table 4"));
    EXPECT_THAT(page, Not(HasSubstr("Table 2 and Figure 3")));
    EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
    EXPECT_THAT(page, HasSubstr("Scaled down"));
    const std::string results = contents(folder_ / "s/results.json");
    EXPECT_THAT(results, HasSubstr("\"special-effect\""));

    // A lost picture is made again, the others are taken as they are: times included.
    const auto kept = folder_ / "s/pictures/table-4-tio2-80-thin-film.exr";
    const auto lost = folder_ / "s/pictures/table-4-tio2-80-microflake";
    const auto written = std::filesystem::last_write_time(kept);
    std::filesystem::remove(lost.string() + ".json");
    std::filesystem::remove(lost.string() + ".exr");
    ASSERT_EQ(nacre(study).status, 0);
    EXPECT_TRUE(std::filesystem::exists(lost.string() + ".exr"));
    EXPECT_EQ(std::filesystem::last_write_time(kept), written);
}

TEST_F(Program, ExplicitFlakesLieUnderFlatPanelsOnly) {
    const std::string scene = shipped_file("scenes/flakes.toml").string();
    const std::string discs = " --paint gray.toml --model nacre --flakes explicit --quiet --spp 4 ";
    const Outcome panel = nacre("render " + scene + discs + "--size 16x16 -o a.exr");
    EXPECT_EQ(panel.status, 0) << panel.err;
    EXPECT_TRUE(exists("a.exr"));
    const Outcome sphere = nacre("render sphere" + discs + "-o b.exr");
    EXPECT_EQ(sphere.status, 1);
    EXPECT_THAT(sphere.err, HasSubstr("no flat panel; --flakes hashed goes on any shape"));
    const Outcome large = nacre("render panel" + discs + "-o b.exr");
    EXPECT_EQ(large.status, 2);
    EXPECT_THAT(large.err, HasSubstr("take a smaller panel"));
    EXPECT_FALSE(exists("b.exr"));
    for (const char* wrong :
         {"render sphere --paint gray.toml --model microflake --flakes explicit -o b.exr",
          "render sphere --paint gray.toml --model nacre --flakes painted -o b.exr",
          "render sphere --paint gray.toml --model nacre --flakes explicit --no-hot-spot -o b.exr",
          "eval gray.toml --model nacre --flakes explicit --incident 20 --outgoing 20"}) {
        EXPECT_EQ(nacre(wrong).status, 1) << wrong;
    }
}

TEST_F(Program, StudyOfFlakesWritesOnePage) {
    const Outcome study = nacre("study flakes -o s --quick --quiet");
    ASSERT_EQ(study.status, 0) << study.err;
    const std::string page = contents(folder_ / "s/index.html");
    for (const char* part : {"What hides a flake", "Contrast against footprint", "All together"})
        EXPECT_THAT(page, HasSubstr(part));
    EXPECT_THAT(contents(folder_ / "s/results.json"), HasSubstr("\"mean_hashed_over_discs\""));
    EXPECT_EQ(nacre("study flakes -o t --spp 64").status, 1);
    EXPECT_EQ(nacre("study flake -o t").status, 1);
}

TEST_F(Program, FailuresWhileRunningEndWithThree) {
    EXPECT_EQ(nacre("film -o /dev/full").status, 3);
}

TEST_F(Program, PatchesOfAMeanAreRefusedByTheirOptions) {
    write(
        "facets.toml",
        kMicrofacetRecipe +
            std::string(
                "[microfacet.facets]\ncount = 1000\ncone_deg = 3.0\nthickness_spread_nm = 10.0\n"));
    const Outcome outcome = nacre(
        "eval facets.toml --model special-effect --smooth-ndf --incident 45 --outgoing 0 "
        "--at 0.5,0.5 --footprint 0.1");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("--at and --footprint"), Not(HasSubstr("--patch"))));
}

TEST_F(Program, ScenesNameTheirMeshFromTheirFolder) {
    write("corners.bin", corners());
    write("triangle.gltf", triangle("corners.bin"));
    std::filesystem::create_directories(folder_ / "other" / "folder");
    for (const std::string scene : {"x.toml", "other/x.toml", "other/folder/x.toml"}) {
        ASSERT_EQ(nacre("scene triangle.gltf -o " + scene).status, 0);
        const Outcome picture =
            nacre("render " + scene + " --paint gray.toml --spp 1 --size 2x2 -q -o x.exr");
        EXPECT_EQ(picture.status, 0) << picture.err;
    }
    EXPECT_THAT(contents(folder_ / "other/folder/x.toml"), HasSubstr("../../triangle.gltf"));
    EXPECT_THAT(nacre("scene other/../triangle.gltf").out, HasSubstr("other/../triangle.gltf"));
}

}  // namespace

}  // namespace nacre::cli::testing
