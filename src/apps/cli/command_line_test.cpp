#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "apps/cli/program_test_support.h"
#include "nacre/nacre.h"

// What the program says to those who mistype, or write what no paint has.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

TEST_F(Program, SuggestsTheCommandThatWasMeant) {
    const Outcome outcome = nacre("mesure gray.toml");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, StartsWith("nacre: there is no command 'mesure' (did you mean "
                                        "'measure'?); the commands are studio, film, solve, "));
}

TEST_F(Program, SuggestsTheOptionThatWasMeant) {
    for (const char* wrong : {"measure gray.toml --iluminant D65", "measure --iluminant=D65",
                              "measure --iluminant D65 gray.toml"}) {
        const Outcome outcome = nacre(wrong);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(outcome.err,
                  "nacre: measure has no option --iluminant (did you mean '--illuminant'?); nacre "
                  "measure --help tells what it takes\n")
            << wrong;
    }
    // Not the option that is missing since it was misspelt.
    EXPECT_THAT(nacre("render sphere --paint gray.toml --outptu x.exr").err,
                StartsWith("nacre: render has no option --outptu (did you mean '--output'?)"));
}

TEST_F(Program, EveryComplaintBeginsWithItsName) {
    EXPECT_EQ(nacre("render").err,
              "nacre: render: SCENE is required; nacre render --help tells what it takes\n");
    EXPECT_THAT(nacre("").err, StartsWith("nacre: A subcommand is required"));
    EXPECT_THAT(nacre("film 1.5").err, StartsWith("nacre: film: "));
    EXPECT_EQ(nacre("info gray.toml more.toml").err,
              "nacre: info: 'more.toml' was not expected; nacre info --help tells what it takes\n");
}

TEST_F(Program, HelpIsACommandToo) {
    const Outcome help = nacre("help render");
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.out, nacre("render --help").out);
    EXPECT_EQ(nacre("help").out, nacre("--help").out);
    EXPECT_THAT(nacre("help rendre").err, HasSubstr("did you mean 'render'?"));
}

TEST_F(Program, MaterialsThatAreNamedInPartAreOffered) {
    EXPECT_THAT(nacre("film --layer TiO2:80 --substrate 1.5").err,
                HasSubstr("did you mean 'TiO2_amorphous', 'TiO2_anatase', 'TiO2_rutile', "));
}

TEST_F(Program, AFractionInPerCentIsToldHowToWriteIt) {
    write("percent.toml",
          "ior = 1.5\n[[layer]]\nthickness_um = 15\n[[layer.flakes]]\nvolume_fraction = 3\n"
          "thickness_um = 0.3\norientation = { distribution = \"beckmann\", alpha = 0.2 "
          "}\nreflectance = 0.6\n");
    EXPECT_THAT(nacre("info percent.toml").err,
                AllOf(HasSubstr("volume_fraction = 3: must be a number in (0, 1]"),
                      HasSubstr("; 3 % is 0.03")));
    // Not of what is no fraction.
    write("rough.toml",
          "ior = 1.5\n[[layer]]\nthickness_um = 15\n[[layer.flakes]]\narea_density_per_um = 0.1\n"
          "orientation = { distribution = \"beckmann\", alpha = 3 }\nreflectance = 0.6\n");
    EXPECT_THAT(nacre("info rough.toml").err, AllOf(HasSubstr("alpha = 3"), Not(HasSubstr("%"))));
}

TEST_F(Program, ShippedPaintsGoByTheirNames) {
    ASSERT_GE(shipped_paints().size(), 30u);
    const Outcome by_name = nacre("info ruby -o by-name.txt");
    EXPECT_EQ(by_name.status, 0) << by_name.err;
    EXPECT_THAT(contents(folder_ / "by-name.txt"), HasSubstr("name: "));
    EXPECT_EQ(nacre("measure ruby --geometry 45as45").out,
              nacre("measure '" + find_paint("ruby").string() + "' --geometry 45as45").out);
    EXPECT_THAT(nacre("measure rubi").err, HasSubstr("did you mean 'ruby'?"));
    EXPECT_THAT(nacre("measure ruby.tml").err, HasSubstr("did you mean 'ruby'?"));
    EXPECT_THAT(nacre("measure ./ruby").err, Not(HasSubstr("shipped")));
    // A file of that name comes first.
    std::filesystem::copy(folder_ / "gray.toml", folder_ / "ruby");
    EXPECT_EQ(nacre("measure ruby --geometry 45as45").out.substr(0, 400),
              nacre("measure gray.toml --geometry 45as45").out.substr(0, 400));
}

TEST_F(Program, ADashIsTheStandardOutput) {
    const Outcome dash = nacre("measure gray.toml --geometry 45as45 -o -");
    EXPECT_EQ(dash.status, 0) << dash.err;
    EXPECT_EQ(dash.out, nacre("measure gray.toml --geometry 45as45").out);
    EXPECT_EQ(nacre("solve gray.toml --wavelength 550 -q -o gray.h5").status, 0);
    EXPECT_TRUE(nacre("solve gray.toml --wavelength 550 -q -o -").out ==
                contents(folder_ / "gray.h5"));
    EXPECT_FALSE(exists("-"));
    EXPECT_THAT(nacre("measure gray.toml -o - --report -").err, HasSubstr("is the same file as"));
}

TEST_F(Program, ShellsCompleteIt) {
    ASSERT_EQ(nacre("completion bash -o nacre.bash").status, 0);
    const auto completions = [&](const std::string& words, int at) {
        return shell("bash -c 'source ./nacre.bash; COMP_WORDS=(" + words +
                     "); COMP_CWORD=" + std::to_string(at) + "; _nacre; echo ${COMPREPLY[@]}'")
            .out;
    };
    EXPECT_EQ(completions("nacre mat", 1), "materials\n");
    EXPECT_EQ(completions("nacre measure --illu", 2), "--illuminant\n");
    EXPECT_EQ(completions("nacre render curv", 2), "curved-panel\n");
    EXPECT_EQ(completions("nacre render sphere --paint rub", 4), "ruby\n");
    EXPECT_EQ(completions("nacre measure gray", 2), "gray.toml\n");
    EXPECT_EQ(completions("nacre help rend", 2), "render\n");
    EXPECT_EQ(completions("nacre eval ruby --model thin", 4), "thin-film\n");
    EXPECT_THAT(nacre("completion zsh").out, HasSubstr("bashcompinit"));
    EXPECT_THAT(nacre("completion fish").out,
                HasSubstr("complete -c nacre -n '__fish_seen_subcommand_from render' -l paint -r"));
    EXPECT_EQ(nacre("completion tcsh").status, 1);
}

TEST_F(Program, BuiltInScenesBecomeFiles) {
    const std::string how = " --paint gray.toml --model microflake --spp 1 --size 24x24 -q -o ";
    for (const char* name :
         {"sphere", "panel", "curved-panel", "speed-shape", "macro", "panel-sun"}) {
        ASSERT_EQ(nacre(std::string("scene ") + name + " -o my.toml").status, 0) << name;
        EXPECT_EQ(nacre(std::string("render ") + name + how + "a.exr").status, 0);
        const Outcome own = nacre("render my.toml" + how + "b.exr");
        EXPECT_EQ(own.status, 0) << own.err;
        const Outcome same = nacre("diff a.exr b.exr --max-relative 0");
        EXPECT_EQ(same.status, 0) << name << same.out;
    }
    EXPECT_THAT(nacre("scene ball").err, HasSubstr("there are: curved-panel, macro, panel, "));
}

TEST_F(Program, ImplausibleNumbersAreWarnedOf) {
    write("thin.toml",
          "ior = 1.5\n[[layer]]\nthickness_um = 0.2\n[[layer.flakes]]\narea_density_per_um = 0.1\n"
          "thickness_um = 0.3\norientation = { distribution = \"beckmann\", alpha = 0.2 "
          "}\nreflectance = 0.6\n");
    const char* commands[] = {
        "info thin.toml",
        "solve thin.toml --wavelength 550 -o thin.h5",
        "measure thin.toml --geometry 45as45",
        "eval thin.toml --incident 45 --outgoing 30,180 --wavelength 550",
        "fit gray.toml --start thin.toml --free alpha --starts 1 --within 100",
        "render sphere --paint thin.toml --model microflake --spp 1 --size "
        "16x16 -o thin.exr",
        "info thin.h5"};
    for (const char* command : commands) {
        const Outcome outcome = nacre(command);
        EXPECT_EQ(outcome.status, 0) << command << "\n" << outcome.err;
        const std::string warning = "nacre: warning: thin.";
        EXPECT_THAT(outcome.err, AllOf(HasSubstr(warning),
                                       HasSubstr("flakes 0.3 um thick do not fit into a layer of "
                                                 "0.2 um")))
            << command;
        EXPECT_EQ(outcome.err.find(warning), outcome.err.rfind(warning)) << command;  // once
        EXPECT_THAT(nacre(std::string(command) + " -q").err, IsEmpty()) << command;
        const Outcome strict = nacre(std::string(command) + " --strict");
        EXPECT_EQ(strict.status, 2) << command;
        EXPECT_THAT(strict.err, HasSubstr("refused by --strict")) << command;
    }
    EXPECT_EQ(nacre("measure gray.toml --geometry 45as45 --strict").status, 0);
}

TEST_F(Program, ShippedPaintsArePlausible) {
    for (const std::string& name : shipped_paints()) {
        EXPECT_THAT(open(find_paint(name)).implausible_numbers(), IsEmpty()) << name;
    }
}

TEST_F(Program, OptionsTakeNoEmptyValue) {
    write("a.png", "any");
    write("lab.csv", "geometry,L,a,b\n45as15,90,1,2\n");
    for (const std::string arguments :
         {"measure gray.toml --tolerance", "measure gray.toml --versus",
          "measure gray.toml --weights", "measure gray.toml --formula",
          "measure gray.toml --illuminant", "measure gray.toml --observer",
          "measure gray.toml --aperture", "measure gray.toml --geometry",
          "measure gray.toml --wavelength", "measure gray.toml --model",
          "diff a.png a.png --max-delta-e-mean", "sparkle gray.toml --versus",
          "fit gray.toml --start gray.toml --also", "fit gray.toml --start gray.toml --noise",
          "atlas --film mica --illuminant", "atlas --film mica --observer",
          "render sphere --paint gray.toml -o x.exr --frames"}) {
        const Outcome outcome = nacre(arguments + " ''");
        EXPECT_EQ(outcome.status, 1) << arguments << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(arguments.substr(arguments.rfind("--")) + ": "))
            << arguments;
        EXPECT_THAT(outcome.out, IsEmpty());
    }
}

TEST_F(Program, NoRangeHoldsNan) {
    const std::string render = "render sphere --paint gray.toml -o x.exr ";
    for (const std::string& arguments :
         {std::string("diff a.png a.png --min-psnr"),
          std::string("diff a.png a.png --heat-full-scale"), render + "--exposure",
          render + "--fps", render + "--footprint", std::string("merge a.h5 -o x.exr --exposure"),
          std::string("sparkle gray.toml --panel"), std::string("sparkle gray.toml --distance")}) {
        for (const char* nan : {" nan", " -NaN"}) {
            const Outcome outcome = nacre(arguments + nan);
            EXPECT_EQ(outcome.status, 1) << arguments << outcome.err;
            EXPECT_THAT(outcome.err, HasSubstr(arguments.substr(arguments.rfind("--")) + ": "))
                << arguments;
        }
    }
}

TEST_F(Program, WholeNumbersAreDecimal) {
    const std::string at = " --incident 45 --outgoing 0 --wavelength 550 -q ";
    const std::string reference = "reference gray.toml" + at;
    EXPECT_EQ(nacre(reference + "--samples 0100").out, nacre(reference + "--samples 100").out);
    EXPECT_EQ(nacre(reference + "--samples 100 --seed 010").out,
              nacre(reference + "--samples 100 --seed 10").out);
    EXPECT_EQ(nacre(reference + "--samples 080").status, 0);
    EXPECT_NE(nacre(reference + "--samples 100 --seed 18446744073709551615").out, "");
    const std::string eval = "eval gray.toml" + at;
    EXPECT_EQ(nacre(eval + "--specimen 9007199254740992").status, 0);
    for (const std::string& arguments :
         {reference + "--samples 0x64", reference + "--samples 1e2", reference + "--seed -1",
          reference + "--seed 18446744073709551616", eval + "--specimen -1",
          eval + "--specimen 9007199254740993", eval + "--specimen 18446744073709551616",
          std::string("solve gray.toml -o x.h5 --orders 99999999999999999999")}) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments << outcome.err;
        const std::string option = arguments.substr(arguments.rfind("--"));
        EXPECT_THAT(outcome.err, HasSubstr(option.substr(0, option.find(' ')) + ": Value "));
    }
}

TEST_F(Program, RangesAreToldAsTheyAre) {
    EXPECT_THAT(nacre("solve gray.toml -o x.h5 --tolerance 0").err,
                HasSubstr("--tolerance: Value 0 not in range 1e-12 to 0.1"));
    EXPECT_EQ(nacre("solve gray.toml -o x.h5 --tolerance 1e-12").status, 0);
    for (const char* gamut : {"p3", "1"}) {
        const Outcome outcome =
            nacre(std::string("render sphere --paint gray.toml -o x.exr --gamut ") + gamut);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_THAT(outcome.err, HasSubstr(std::string("--gamut: ") + gamut + " not in {"));
        EXPECT_THAT(outcome.err, HasSubstr("display-p3"));
    }
}

TEST_F(Program, OptionsThatWouldDoNothingAreRefused) {
    write("lab.csv", "geometry,L,a,b\n45as15,90,1,2\n");
    const std::string render = "render sphere --paint gray.toml -o x.exr --spp 1 --size 2x2 ";
    const std::pair<std::string, const char*> cases[] = {
        {"measure lab.csv --model nacre", "--model = nacre: lab.csv holds measured colours"},
        {"measure lab.csv --no-hot-spot", "--no-hot-spot: lab.csv holds measured colours"},
        {"measure lab.csv --table svd", "--table = svd: lab.csv holds measured colours"},
        {"measure lab.csv --model walk --samples 100", "--model = walk: lab.csv holds measured"},
        {"measure lab.csv --samples 100", "--samples belongs to --model"},
        {"fit lab.csv --start gray.toml --free alpha --model walk", "--model = walk: lab.csv is"},
        {"fit lab.csv --start gray.toml --free alpha --constructions 2",
         "--constructions belongs to --library"},
        {render + "--footprint 2 --model microflake", "--footprint: the model microflake shows no"},
        {render + "--fps 12", "--fps belongs to --video"},
    };
    for (const auto& [arguments, complaint] : cases) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(complaint)) << arguments;
        EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
    }
}

}  // namespace
}  // namespace nacre::cli::testing
