#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "apps/cli/program_test_support.h"

// Files that are none, or that mean harm, and work that is interrupted.

namespace nacre::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kEval = " --incident 45 --outgoing 30,180 --wavelength 550";

/// Every command that reads a file, with the file's place marked @.
constexpr const char* kReaders[] = {"info @",
                                    "eval @ --incident 45 --outgoing 30,180",
                                    "solve @ -o out.h5",
                                    "reference @ --incident 45 --outgoing 30,180",
                                    "export @ -o out.bsdf",
                                    "measure @",
                                    "measure gray.toml --versus @",
                                    "measure gray.toml --geometry @",
                                    "sparkle @",
                                    "panel @ -o out.html",
                                    "panel gray.toml --versus @ -o out.html",
                                    "fit @ --start gray.toml --free alpha",
                                    "atlas --recipe @ --key alpha --values 0.1,0.2",
                                    "render @ -o out.exr",
                                    "render sphere --paint @ -o out.exr",
                                    "render sphere --brdf @ -o out.exr",
                                    "diff @ @"};

std::string with_file(std::string command, const std::string& file) {
    for (std::size_t at; (at = command.find('@')) != std::string::npos;) {
        command.replace(at, 1, file);
    }
    return command;
}

// Opening a pipe waits for a writer, and reading a device has no end.
TEST_F(Program, PipesAndDevicesByNameAreRefusedByEveryCommand) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe.toml").c_str(), 0600), 0);
    for (const char* reader : kReaders) {
        const Outcome pipe = nacre(with_file(reader, "pipe.toml"));
        EXPECT_EQ(pipe.status, 2) << reader << '\n' << pipe.err;
        EXPECT_THAT(pipe.err, AllOf(HasSubstr("pipe.toml"), HasSubstr("is a pipe"))) << reader;
    }
    for (const char* other : {"/dev/zero", "/dev/tty", "/dev/null", "."}) {
        const Outcome outcome = nacre(std::string("info ") + other);
        EXPECT_EQ(outcome.status, 2) << other;
        EXPECT_THAT(outcome.err, HasSubstr(std::string("'") + other + "'"));
    }
    EXPECT_EQ(nacre("info - < /dev/zero").status, 2);
    for (const char* name : {"out.h5", "out.bsdf", "out.html", "out.exr"}) {
        EXPECT_FALSE(exists(name)) << name;
    }
}

TEST_F(Program, TheStandardInputMayBeAPipe) {
    const std::string before = "cat gray.toml |";
    const std::string expected = nacre(std::string("eval gray.toml") + kEval).out;
    ASSERT_THAT(expected, StartsWith("theta_i"));
    for (const char* name : {"-", "/dev/stdin", "/dev/fd/0"}) {
        EXPECT_EQ(nacre(std::string("eval ") + name + kEval, before).out, expected) << name;
    }
    EXPECT_EQ(nacre(std::string("eval -") + kEval + " < gray.toml").out, expected);
    ASSERT_EQ(nacre("solve gray.toml --wavelength 550 -o gray.h5").status, 0);
    EXPECT_EQ(nacre(std::string("eval -") + kEval, "cat gray.h5 |").out, expected);
    EXPECT_THAT(nacre("info -", before).out, HasSubstr("kind: recipe"));
    EXPECT_THAT(nacre("info -", "cat gray.h5 |").out, HasSubstr("kind: solved paint"));

    ASSERT_EQ(nacre("measure gray.toml --geometry 45as15,45as45 -o gray.csv").status, 0);
    EXPECT_EQ(nacre("measure gray.toml --versus gray.csv").out,
              nacre("measure gray.toml --versus -", "cat gray.csv |").out);
    write("set.toml", "name = \"s\"\n[[geometry]]\nlamp_deg = 45\naspecular_deg = 25\n");
    EXPECT_EQ(nacre("measure gray.toml --geometry set.toml").out,
              nacre("measure gray.toml --geometry -", "cat set.toml |").out);
    write("scene.toml", R"([materials.paint]
type = "paint"
[[shapes]]
type = "sphere"
material = "paint"
[environment]
type = "constant"
)");
    const std::string picture = " --paint gray.toml --spp 1 --size 4x4 -o ";
    EXPECT_EQ(nacre("render scene.toml" + picture + "a.exr").status, 0);
    EXPECT_EQ(nacre("render -" + picture + "b.exr", "cat scene.toml |").status, 0);
    EXPECT_EQ(nacre("diff a.exr b.exr --max-relative 0").status, 0);
    EXPECT_EQ(nacre("diff a.exr - --max-relative 0", "cat b.exr |").status, 0);
}

TEST_F(Program, WhatComesThroughAPipeNamesNoFiles) {
    write("glass.csv", "wavelength_nm,n\n300,1.5\n900,1.5\n");
    std::string recipe = contents(folder_ / "gray.toml");
    write("glass.toml", recipe.replace(recipe.find("1.5"), 3, "\"glass.csv\""));
    EXPECT_EQ(nacre("info glass.toml").status, 0);
    const Outcome outcome = nacre("info -", "cat glass.toml |");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("-:1:"), HasSubstr("glass.csv"), HasSubstr("may name none")));
}

TEST_F(Program, ReferenceRefusesAPaintWithoutLayers) {
    write("facets.toml", R"(ior = 1.5
[microfacet]
alpha = 0.07
film_ior = 1.8
film_thickness_nm = 158.333
base_ior = 1.08
base_extinction = 0.51
)");
    const Outcome outcome = nacre("reference facets.toml --incident 45 --outgoing 30,180");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("facets.toml: layer: is missing"), HasSubstr("[[layer]]")));
    EXPECT_THAT(outcome.out, IsEmpty());
}

TEST_F(Program, ControlCharactersOfNamesDoNotReachTheTerminal) {
    std::string recipe = contents(folder_ / "gray.toml");
    write("evil.toml", "name = \"\\u001b[2Jgold\\u009b31m\\nnacre: all is well\"\n" + recipe);
    const Outcome info = nacre("info evil.toml");
    EXPECT_EQ(info.status, 0);
    EXPECT_THAT(info.out, HasSubstr("name: \\x1b[2Jgold\\x9b31m\\nnacre: all is well\n"));
    const std::string name = "no\x1b[2J\nthing.toml";
    const Outcome absent = nacre("info '" + name + "'");
    EXPECT_EQ(absent.status, 2);
    EXPECT_THAT(absent.err, HasSubstr("'no\\x1b[2J\\nthing.toml'"));
    write("key.toml", "\"\\u001b[2J\" = 1\n" + recipe);
    EXPECT_THAT(nacre("info key.toml").err, Not(HasSubstr("\x1b")));
    EXPECT_THAT(nacre("info gray.toml --no\x1bsuch").err, Not(HasSubstr("\x1b")));
}

TEST_F(Program, FormulasInNamesAreHarmlessInTablesAndReadBack) {
    write("formula.toml",
          "name = \"=HYPERLINK(\\\"http://a\\\",\\\"b\\\")\"\n" + contents(folder_ / "gray.toml"));
    ASSERT_EQ(nacre("measure formula.toml --geometry 45as15 -o formula.csv").status, 0);
    EXPECT_THAT(contents(folder_ / "formula.csv"),
                HasSubstr(R"x("'=HYPERLINK(""http://a"",""b"")")x"));
    EXPECT_THAT(nacre("measure formula.csv --format json").out,
                HasSubstr(R"x("=HYPERLINK(\"http://a\",\"b\")")x"));
}

TEST_F(Program, MessagesDoNotShowWhatIsInAFileThatIsNoMaterial) {
    write("secret.csv", "root:hunter2:0:0\n");
    std::string recipe = contents(folder_ / "gray.toml");
    write("glass.toml", recipe.replace(recipe.find("1.5"), 3, "\"secret.csv\""));
    const Outcome outcome = nacre("info glass.toml");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("secret.csv:1:"), Not(HasSubstr("hunter2"))));
}

// Work that would go on for hours, stopped after a second: it ends, and replaces nothing.
TEST_F(Program, AnInterruptEndsLongWorkAndReplacesNothing) {
    write("lossless.toml", R"(ior = 1.5
[[layer]]
thickness_um = 10000
[[layer.flakes]]
area_density_per_um = 0.1
orientation = { distribution = "beckmann", alpha = 0.1 }
reflectance = 1.0
[substrate]
reflectance = 1.0
)");
    std::string films = contents(folder_ / "lossless.toml");
    films.replace(films.find("reflectance = 1.0"), 17,
                  R"(core = { material = "mica", thickness_nm = 500, spread_nm = 100 }
coats = [{ material = "TiO2_anatase", thickness_nm = 80, spread_nm = 80 }, { material = "SiO2", thickness_nm = 300, spread_nm = 1000 }])");
    write("films.toml", films);
    for (const auto& [command, file] :
         {std::pair{"solve films.toml --wavelength 400:700:1 -o old.h5", "old.h5"},
          std::pair{"atlas --recipe films.toml --key coats[0].thickness_nm --values 40:160:1 "
                    "-o old.svg",
                    "old.svg"},
          std::pair{"render panel --paint films.toml --model walk -o old.exr", "old.exr"},
          std::pair{"reference lossless.toml --incident 45 --outgoing 0:80:10,0:350:10 "
                    "--samples 1000000000 -o old.csv",
                    "old.csv"},
          std::pair{"export gray.toml --resolution 256 --incidences 256 -o old.bsdf", "old.bsdf"},
          std::pair{"render sphere --paint lossless.toml --model walk --size 4096x4096 -o old.exr",
                    "old.exr"},
          std::pair{
              "render sphere --paint lossless.toml --model volume --size 4096x4096 -o old.exr",
              "old.exr"}}) {
        write(file, "old");
        const Outcome outcome = nacre(command, "timeout --foreground --preserve-status -s INT 1");
        EXPECT_EQ(outcome.status, 3) << command << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("stopped")) << command;
        EXPECT_EQ(contents(folder_ / file), "old") << command;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        EXPECT_THAT(entry.path().string(), Not(HasSubstr(".partial")));
    }
}

}  // namespace
}  // namespace nacre::cli::testing
