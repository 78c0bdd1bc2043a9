#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/program_test_support.h"

// Files that are none, or that mean harm, and work that is interrupted.

namespace nacre::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kEvalOptions = " --incident 45 --outgoing 30,180 --wavelength 550";

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
                                    "fit gray.toml --start @ --free alpha",
                                    "atlas --recipe @ --key alpha --values 0.1,0.2",
                                    "render @ -o out.exr",
                                    "render sphere --paint @ -o out.exr",
                                    "render sphere --brdf @ -o out.exr",
                                    "diff @ @",
                                    "diff gray.toml @"};

/// What a scene or a recipe names, and how; materials stand on the command line too.
constexpr const char* kNamers[] = {
    "[materials.paint]\ntype = \"paint\"\nrecipe = \"@.toml\"\n[[shapes]]\ntype = \"sphere\"\n"
    "material = \"paint\"\n[environment]\ntype = \"constant\"\n",
    "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n[[shapes]]\ntype = \"mesh\"\npath = "
    "\"@.obj\"\n"
    "material = \"grey\"\n[environment]\ntype = \"constant\"\n",
    "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n[[shapes]]\ntype = \"mesh\"\npath = "
    "\"@.gltf\"\n"
    "material = \"grey\"\n[environment]\ntype = \"constant\"\n",
    "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n[[shapes]]\ntype = "
    "\"sphere\"\nmaterial = \"grey\"\n"
    "[environment]\ntype = \"image\"\npath = \"@.exr\"\n",
    "ior = \"@.csv\"\n[[layer]]\nthickness_um = 3\n",
    "ior = \"@.yml\"\n[[layer]]\nthickness_um = 3\n"};
constexpr const char* kMaterialReaders[] = {"film --layer @.csv:80",
                                            "film --ambient @.yml",
                                            "film --substrate @.csv",
                                            "atlas --film @.csv",
                                            "atlas --film mica --core @.yml:500:60",
                                            "atlas --film mica --core mica:500 --outer @.csv:30",
                                            "atlas --film mica --ior @.csv"};

std::string with_file(std::string command, const std::string& file) {
    for (std::size_t at; (at = command.find('@')) != std::string::npos;) {
        command.replace(at, 1, file);
    }
    return command;
}

// Opening a pipe waits for a writer, and reading a device has no end.
TEST_F(Program, FilesThatASceneNamesAreRefusedWithItsLine) {
    write("bad.toml", "ior = 1.5\n[[layer]]\nthickness_um = -15\n");
    write("sharp.toml",
          "ior = 1.5\n[[layer]]\nthickness_um = 15\n[[layer.pigment]]\nscattering_per_mm = 9\n"
          "anisotropy = 0.98\n");
    write("bad.obj", "v 0 0\nf 1 2 3\n");
    write("grey.png", "no picture");
    const auto complaint = [&](const std::string& material, const std::string& shape) {
        write("scene.toml", "[materials.m]\n" + material + "[[shapes]]\nmaterial = \"m\"\n" +
                                shape + "[environment]\ntype = \"constant\"\n");
        const Outcome outcome = nacre("render scene.toml --spp 1 --size 2x2 -o x.exr");
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        return outcome.err;
    };
    const std::string ball = "type = \"sphere\"\n", paint = "type = \"paint\"\n",
                      grey = "type = \"diffuse\"\nreflectance = 0.5\n", mesh = "type = \"mesh\"\n";
    EXPECT_EQ(complaint(paint + "recipe = \"bad.toml\"\n", ball),
              "nacre: scene.toml:3:10: materials.m.recipe: bad.toml:3:16: layer[0].thickness_um = "
              "-15: must be a number in (0, 1000000] um\n");
    EXPECT_THAT(complaint(paint + "recipe = \"absent.toml\"\n", ball),
                HasSubstr("scene.toml:3:10: materials.m.recipe: cannot read 'absent.toml'"));
    EXPECT_THAT(complaint(paint + "recipe = \"sharp.toml\"\n", ball),
                HasSubstr("scene.toml:3:10: materials.m.recipe: sharp.toml: layer[0].pigment[0]."));
    EXPECT_EQ(complaint(grey, mesh + "path = \"bad.obj\"\n"),
              "nacre: scene.toml:7:8: shapes[0].path: mesh 'bad.obj': line 1 is a vertex of fewer "
              "than three coordinates\n");
    EXPECT_THAT(complaint(grey, mesh + "path = \"absent.obj\"\n"),
                HasSubstr("scene.toml:7:8: shapes[0].path: cannot read 'absent.obj'"));
    EXPECT_THAT(complaint("type = \"diffuse-picture\"\npath = \"grey.png\"\n", ball),
                HasSubstr("scene.toml:3:8: materials.m.path = 'grey.png': grey.png: is not"));
    // What the command line names is not the scene's.
    EXPECT_THAT(nacre("render sphere --paint bad.toml -o x.exr").err,
                StartsWith("nacre: bad.toml:3:16: "));
}

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
    for (const char* extension : {".toml", ".obj", ".gltf", ".exr", ".csv", ".yml"}) {
        ASSERT_EQ(::mkfifo((folder_ / (std::string("fifo") + extension)).c_str(), 0600), 0);
        for (const char* device : {"zero", "random"}) {
            std::filesystem::create_symlink(std::string("/dev/") + device,
                                            folder_ / (std::string(device) + extension));
        }
    }
    for (const char* device : {"zero.toml", "random.toml"}) {
        for (const char* reader : kReaders) {
            const Outcome outcome = nacre(with_file(reader, device));
            EXPECT_EQ(outcome.status, 2) << reader << '\n' << outcome.err;
            EXPECT_THAT(outcome.err, HasSubstr("is a device")) << reader;
        }
    }
    // Named by a file, or as a material.
    for (const auto& [name, reason] :
         {std::pair{"fifo", "is a pipe"}, {"zero", "is a device"}, {"random", "is a device"}}) {
        std::vector<std::string> commands;
        for (const char* reader : kMaterialReaders) commands.push_back(with_file(reader, name));
        for (const char* namer : kNamers) {
            const bool scene = std::string(namer).find("[[shapes]]") != std::string::npos;
            const std::string file = fmt::format("namer-{}-{}.toml", name, commands.size());
            write(file, with_file(namer, name));
            commands.push_back(scene ? "render " + file + " -o out.exr" : "info " + file);
        }
        for (const std::string& command : commands) {
            const Outcome outcome = nacre(command);
            EXPECT_EQ(outcome.status, 2) << command << '\n' << outcome.err;
            EXPECT_THAT(outcome.err, HasSubstr(reason)) << command;
        }
    }
    for (const char* name : {"out.h5", "out.bsdf", "out.html", "out.exr"}) {
        EXPECT_FALSE(exists(name)) << name;
    }
}

TEST_F(Program, TheStandardInputMayBeAPipe) {
    const std::string before = "cat gray.toml |";
    const std::string expected = nacre(std::string("eval gray.toml") + kEvalOptions).out;
    ASSERT_THAT(expected, StartsWith("theta_i"));
    for (const char* name : {"-", "/dev/stdin", "/dev/fd/0"}) {
        EXPECT_EQ(nacre(std::string("eval ") + name + kEvalOptions, before).out, expected) << name;
    }
    EXPECT_EQ(nacre(std::string("eval -") + kEvalOptions + " < gray.toml").out, expected);
    ASSERT_EQ(nacre("solve gray.toml --wavelength 550 -o gray.h5").status, 0);
    EXPECT_EQ(nacre(std::string("eval -") + kEvalOptions, "cat gray.h5 |").out, expected);
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

// Each command with each of its inputs, through a pipe: the same as from the file.
TEST_F(Program, EveryInputMayComeThroughAPipe) {
    write("gray.toml", "name = \"gray\"\n" + contents(folder_ / "gray.toml"));
    write("start.toml", contents(folder_ / "gray.toml") +
                            "[fit]\n\"layer[0].flakes[0].orientation.alpha\" = [0.1, 0.3]\n");
    write("glass.csv", "# of nowhere\nwavelength_nm,n\n300,1.5\n900,1.5\n");
    write("glass.yml", "DATA:\n  - type: tabulated n\n    data: |\n      0.3 1.5\n      0.9 1.6\n");
    write("set.toml", "name = \"s\"\n[[geometry]]\nlamp_deg = 45\naspecular_deg = 25\n");
    write("scene.toml",
          "[materials.paint]\ntype = \"paint\"\n[[shapes]]\ntype = \"sphere\"\n"
          "material = \"paint\"\n[environment]\ntype = \"constant\"\n");
    const std::string small = "--spp 1 --size 2x2 --model walk -o x.exr";
    const std::string page = "--quality low --model microflake --scene sphere -o x.html";
    for (const char* make :
         {"solve gray.toml --wavelength 500,600 -o gray.h5",
          "solve gray.toml --wavelength 400:700:100 --table svd -o table.h5",
          "export gray.toml --cells 8,8,16 -o gray.binary",
          "export gray.toml --resolution 4 --incidences 2 -o gray.bsdf",
          "measure gray.toml --geometry 45as15,45as45 -o gray.csv",
          "measure gray.toml --geometry 45as15,45as45 --format json -o gray.json",
          "render sphere --paint gray.toml --spp 1 --size 2x2 -o gray.exr"}) {
        ASSERT_EQ(nacre(std::string(make) + " -q").status, 0) << make;
    }
    const std::vector<std::pair<std::string, std::string>> commands = {
        {"gray.toml", "info @"},
        {"scene.toml", "info @"},
        {"gray.h5", "info @"},
        {"table.h5", "info @"},
        {"gray.bsdf", "info @"},
        {"gray.binary", "info @"},
        {"gray.exr", "info @"},
        {"gray.png", "info @"},
        {"gray.toml", std::string("eval @") + kEvalOptions},
        {"gray.binary", "eval @ --incident 45 --outgoing 30,180"},
        {"gray.bsdf", "eval @ --incident 45 --outgoing 30,180"},
        {"table.h5", "eval @ --table svd --incident 45 --outgoing 30,180"},
        {"gray.toml", std::string("reference @ --samples 2") + kEvalOptions},
        {"gray.toml", "solve @ --wavelength 550 -o x.h5"},
        {"gray.toml", "export @ --cells 8,8,16 -o x.binary"},
        {"gray.toml", "measure @ --geometry 45as15"},
        {"gray.csv", "measure @"},
        {"gray.json", "measure @"},
        {"gray.csv", "measure gray.toml --versus @"},
        {"set.toml", "measure gray.toml --geometry @"},
        {"gray.toml", "sparkle @ --field 2 --diffuse-samples 0 --lamp 45"},
        {"gray.h5", "panel gray.h5 --versus @ " + page},
        {"gray.h5", "panel @ " + page},
        {"gray.csv", "fit @ --start start.toml --starts 1 --format json"},
        {"start.toml", "fit gray.csv --start @ --starts 1 --format json"},
        {"gray.toml", "atlas --recipe @ --key alpha --values 0.1,0.2"},
        {"scene.toml", "render @ --paint gray.toml " + small},
        {"gray.toml", "render sphere --paint @ " + small},
        {"gray.binary", "render sphere --brdf @ --spp 1 --size 2x2 -o x.exr"},
        {"gray.exr", "diff @ gray.exr"},
        {"gray.png", "diff gray.exr @"},
        {"glass.csv", "film --layer @:80"},
        {"glass.yml", "film --ambient @"},
        {"glass.csv", "film --substrate @"},
        {"glass.yml", "atlas --film @ --thickness 100"},
        {"glass.csv", "atlas --film mica --thickness 100 --core @:500:60"},
        {"glass.csv", "atlas --film mica --thickness 100 --ior @"}};
    int count = 0;
    for (const auto& [file, command] : commands) {
        const char* name = ++count % 2 ? "-" : "/dev/stdin";
        const Outcome piped = nacre(with_file(command, name), "cat " + file + " |");
        EXPECT_EQ(piped.status, 0) << command << ' ' << file << '\n' << piped.err;
        const bool tells = command.starts_with("info") || command.starts_with("fit");
        const bool writes = command.find(" -o ") != std::string::npos;
        if (writes) {
            EXPECT_EQ(piped.out, "") << command;
        } else if (!tells) {  // the name of the file
            EXPECT_EQ(piped.out, nacre(with_file(command, file)).out) << command;
        }
    }
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
    write("facets.toml", kMicrofacetRecipe);
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

class Interrupted : public Program {
 protected:
    /// Runs `nacre ARGUMENTS` and interrupts it half a second after it has begun to catch SIGINT (bit
    /// 2 of SigCgt), or after a minute if it never does.
    Outcome interrupted(const std::string& arguments) const {
        return shell("env --default-signal=INT \"$NACRE\" " + arguments +
                     " & n=0\nwhile [ $n -lt 6000 ] && "
                     "! grep -q '^SigCgt:.*[2367abef]$' /proc/$!/status; do\n"
                     "n=$((n + 1)); sleep 0.01; done\nsleep 0.5; kill -INT $!; wait $!\n");
    }
};

// Work that would go on for hours: it ends, and replaces nothing.
TEST_F(Interrupted, EndsLongWorkAndReplacesNothing) {
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
          std::pair{"render sphere --paint lossless.toml --model walk --size 1024x1024 -o old.exr",
                    "old.exr"},
          std::pair{
              "render sphere --paint lossless.toml --model volume --size 1024x1024 -o old.exr",
              "old.exr"}}) {
        write(file, "old");
        const Outcome outcome = interrupted(command);
        EXPECT_EQ(outcome.status, 3) << command << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("stopped")) << command;
        EXPECT_EQ(contents(folder_ / file), "old") << command;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        EXPECT_THAT(entry.path().string(), Not(HasSubstr(".partial")));
    }
}

TEST_F(Program, FlakesThatLeanAreRefusedWhereAllAzimuthsAreOne) {
    write("leaning.toml", "lean = { tilt_deg = 4 }\n" + contents(folder_ / "gray.toml") +
                              "[microfacet]\nalpha = 0.2\nfilm_ior = 1.8\n"
                              "film_thickness_nm = 158\nbase_ior = 1.08\n");
    EXPECT_EQ(nacre("eval leaning.toml --incident 45 --outgoing 30,180").status, 0);
    const std::vector<std::pair<std::string, std::string>> refused = {
        {"eval leaning.toml --incident 45,10 --outgoing 30,180",
         "--incident: must have the azimuth 0"},
        {"atlas --recipe leaning.toml --key orientation.alpha --values 0.2,0.4 --aspecular 15",
         "leaning.toml: lean.tilt_deg = 4: an atlas is of paints"},
        {"atlas --recipe gray.toml --key orientation.alpha --values 0.2,1.7 --aspecular 15",
         "gray.toml: layer[0].flakes[0].orientation.alpha = 1.7: must be"},
        {"render sphere --paint leaning.toml --model thin-film --size 8x8 --spp 1 -o a.exr",
         "does not show the lean of the paint"}};
    for (const auto& [arguments, why] : refused) {
        const Outcome outcome = nacre(arguments);
        EXPECT_NE(outcome.status, 0) << arguments;
        EXPECT_THAT(outcome.err, HasSubstr(why)) << arguments;
    }
    EXPECT_FALSE(exists("a.exr"));
}

}  // namespace
}  // namespace nacre::cli::testing
