#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/cli/program_test_support.h"
#include "nacre/core/csv.h"
#include "nacre/core/text.h"

// Files from elsewhere: what they may reach, and what the program says about them.

namespace nacre::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kGlass = "wavelength_nm,n\n300,1.5\n900,1.5\n";

class Trust : public Program {
 protected:
    /// A folder with a secret, and below it one that was downloaded, with links into the first.
    void SetUp() override {
        Program::SetUp();
        fs::create_directories(folder_ / "got/parts");
        for (const char* file : {"secret.csv", "got/own.csv"}) write(file, kGlass);
        for (const char* file : {"own.bin", "got/own.bin", "secret.bin"}) write(file, corners());
        for (const char* file : {"secret.gltf", "got/own.gltf"}) write(file, triangle("own.bin"));
        write("got/out.gltf", triangle("../secret.bin"));
        write("got/linked.gltf", triangle("link.bin"));
        for (const char* file : {"secret.toml", "got/own.toml"}) {
            write(file, contents(folder_ / "gray.toml"));
        }
        const std::string picture = "render sphere --paint gray.toml --spp 1 --size 2x2 -q -o ";
        for (const char* file : {"secret.exr", "got/own.exr"}) {
            ASSERT_EQ(nacre(picture + file).status, 0);
        }
        for (const char* extension : {"csv", "bin", "gltf", "toml", "exr"}) {
            fs::create_symlink(std::string("../secret.") + extension,
                               folder_ / (std::string("got/link.") + extension));
        }
        fs::create_directory_symlink("..", folder_ / "got/up");
    }

    void write_recipe(const std::string& name, const std::string& material) const {
        std::string recipe = contents(folder_ / "gray.toml");
        write(name, recipe.replace(recipe.find("1.5"), 3, "\"" + material + "\""));
    }
    /// A sphere under a constant sky, and more.
    void write_scene(const std::string& name, const std::string& paint, const std::string& more,
                     const std::string& sky = "type = \"constant\"") const {
        write(name, "[materials.paint]\ntype = \"paint\"\n" + paint +
                        "\n[[shapes]]\ntype = \"sphere\"\nmaterial = \"paint\"\n" + more +
                        "\n[environment]\n" + sky + "\n");
    }
    /// The ways out of the folder, to a file with this extension.
    std::vector<std::string> ways_out(const std::string& extension) const {
        return {"../secret." + extension, (folder_ / "secret.").string() + extension,
                "link." + extension, "up/secret." + extension, "parts/../../secret." + extension};
    }
};

const std::string kDraw = "--model walk --spp 1 --size 2x2 -q -o x.exr ";

TEST_F(Trust, AnUntrustedSceneReachesNothingOutsideOfItsFolder) {
    const auto draw = [&](const std::string& more) {
        return nacre("render got/scene.toml " + kDraw + more);
    };
    const auto check = [&](const std::string& extension, const auto& write_one) {
        write_one("own." + extension);
        const Outcome own = draw("--untrusted");
        EXPECT_EQ(own.status, 0) << own.err;
        for (const std::string& way : ways_out(extension)) {
            write_one(way);
            const Outcome trusted = draw("");
            EXPECT_EQ(trusted.status, 0) << way << '\n' << trusted.err;
            const Outcome refused = draw("--untrusted");
            EXPECT_EQ(refused.status, 2) << way;
            EXPECT_THAT(refused.err, AllOf(HasSubstr(".toml:"), HasSubstr("outside the folder")));
        }
    };
    const std::string own_paint = "recipe = \"own.toml\"";
    check("toml", [&](const std::string& way) {
        write_scene("got/scene.toml", "recipe = \"" + way + "\"", "");
    });
    check("gltf", [&](const std::string& way) {
        write_scene("got/scene.toml", own_paint,
                    "[[shapes]]\ntype = \"mesh\"\npath = \"" + way + "\"\nmaterial = \"paint\"\n");
    });
    check("exr", [&](const std::string& way) {
        write_scene("got/scene.toml", own_paint, "", "type = \"image\"\npath = \"" + way + "\"");
    });
    // From the scene to a recipe, and from there to a material.
    write_scene("got/scene.toml", "recipe = \"paint.toml\"", "");
    check("csv", [&](const std::string& way) { write_recipe("got/paint.toml", way); });
    write_scene("got/scene.toml", "recipe = \"parts/paint.toml\"", "");
    for (const auto& [way, status] : {std::pair{"../own.csv", 0}, {"../../secret.csv", 2}}) {
        write_recipe("got/parts/paint.toml", way);
        EXPECT_EQ(draw("--untrusted").status, status) << way;
    }
}

TEST_F(Trust, AMeshReachesNothingOutsideOfItsFolderWhoeverNamesIt) {
    for (const char* mesh : {"out", "linked"}) {
        write_scene("got/scene.toml", "recipe = \"own.toml\"",
                    std::string("[[shapes]]\ntype = \"mesh\"\nmaterial = \"paint\"\npath = \"") +
                        mesh + ".gltf\"\n");
        for (const char* flag : {"", "--untrusted"}) {
            const Outcome outcome = nacre("render got/scene.toml " + kDraw + flag);
            EXPECT_EQ(outcome.status, 2) << mesh;
            EXPECT_THAT(outcome.err, HasSubstr("outside the folder"));
        }
    }
    write("got/mesh.obj", "mtllib ../secret.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    write("secret.mtl", "newmtl a\nmap_Kd secret.exr\n");
    write_scene("got/scene.toml", "recipe = \"own.toml\"",
                "[[shapes]]\ntype = \"mesh\"\npath = \"mesh.obj\"\nmaterial = \"paint\"\n");
    const Outcome obj = shell("chmod 0 secret.mtl; \"$NACRE\" render got/scene.toml " + kDraw);
    EXPECT_EQ(obj.status, 0) << "the materials of an OBJ are not read\n" << obj.err;
}

/// Every command that opens a recipe, marked @.
constexpr const char* kRecipeReaders[] = {
    "info @",
    "eval @ --incident 45 --outgoing 0 --wavelength 550",
    "reference @ --incident 45 --outgoing 0 --wavelength 550 --samples 2",
    "solve @ --wavelength 550 -o x.h5",
    "export @ --cells 4,4,4 --model thin-film -o x.binary",
    "measure @",
    "measure gray.toml --versus @",
    "sparkle @",
    "panel @ -o x.html",
    "panel gray.toml --versus @ -o x.html",
    "fit @ --start gray.toml --free alpha",
    "fit gray.toml --start @ --free alpha",
    "atlas --recipe @ --key alpha --values 0.1,0.2",
    "render sphere --paint @ --spp 1 --size 2x2 -o x.exr"};

TEST_F(Trust, EveryCommandThatOpensARecipeCanKeepItToItsFolder) {
    write_recipe("got/paint.toml", "../secret.csv");
    for (const std::string reader : kRecipeReaders) {
        std::string arguments = reader + " --untrusted";
        arguments.replace(arguments.find('@'), 1, "got/paint.toml");
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments << '\n' << outcome.err;
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("got/paint.toml:1:7: ior = '../secret.csv'"),
                                       HasSubstr("is outside the folder 'got'")));
    }
    EXPECT_EQ(nacre("info got/paint.toml").status, 0);
    EXPECT_EQ(shell("cd got; \"$NACRE\" info paint.toml --untrusted").status, 2);
}

TEST_F(Trust, MessagesDoNotQuoteFilesThatASceneNames) {
    const std::string gray = contents(folder_ / "gray.toml");
    const auto complaint = [&](const std::string& name, const std::string& text,
                               const std::string& more = "") {
        write("foreign" + name, text);
        const std::string shape = "[[shapes]]\ntype = \"mesh\"\nmaterial = \"paint\"\npath = \"";
        write_scene("scene.toml",
                    name == ".toml" ? "recipe = \"foreign.toml\"" : "recipe = \"gray.toml\"",
                    name == ".toml" ? "" : shape + "foreign" + name + "\"\n");
        const Outcome outcome = nacre("render scene.toml " + kDraw + more);
        EXPECT_EQ(outcome.status, 2) << text;
        EXPECT_THAT(outcome.err, HasSubstr("foreign" + name));
        EXPECT_THAT(outcome.err + outcome.out, Not(HasSubstr("hunter2"))) << text;
        return outcome.err;
    };
    for (const std::string& text : std::vector<std::string>{
             std::string("root:hunter2:0\n"), std::string("a = \"hunter2\n"),
             std::string("hunter2 = 1\n"), "hunter2 = 1\n" + gray,
             "password = \"hunter2\"\n" + gray, "name = [\"hunter2\"]\n" + gray,
             "[clearcoat]\nthickness_um = \"hunter2\"\n", "[clearcoat]\nhunter2.x = 1\n",
             "ior = \"hunter2\"\n", "ior = \"hunter2.csv\"\n", "ior = \"../hunter2.yml\"\n",
             gray + "[fit]\nhunter2 = [1, 2]\n", gray + "[fit]\nalpha = [\"hunter2\", 2]\n",
             gray + "[substrate]\nreflectance = { hunter2 = 1 }\n",
             std::string("geometry,hunter2\nhunter2,1\n"),
             std::string("{\"format\":\"nacre-measurement\", hunter2"),
             std::string("{\"format\":\"nacre-measurement\",\"hunter2\":1}"),
             std::string("geometry,L,a,b\nhunter2,hunter2,1,2\n")}) {
        complaint(".toml", text);
        complaint(".toml", text, "--untrusted");
    }
    EXPECT_THAT(complaint(".toml", "root:hunter2:0\n"), HasSubstr("foreign.toml:1:5: is not TOML"));
    EXPECT_THAT(complaint(".toml", "ior = 1.5\nhunter2 = 1\n"),
                HasSubstr("foreign.toml:2:1: an unknown key; allowed here: name, ior"));
    EXPECT_THAT(complaint(".toml", "ior = 0.5\n" + gray.substr(gray.find('\n'))),
                HasSubstr("foreign.toml:1:7: ior = 0.5: must be"));
    for (const auto& [name, text] :
         {std::pair<std::string, std::string>{".gltf", "hunter2"},
          {".gltf", "{\"hunter2"},
          {".gltf", "{\"a\": hunter2}"},
          {".gltf", "{\"asset\":{\"version\":\"2.0\"},\"buffers\":\"hunter2\"}"},
          {".glb", "hunter2"},
          {".obj", "v hunter2 0 0\nf 1 1 1\n"},
          {".obj", "f hunter2\n"},
          {".obj", "root:hunter2:0\n"},
          {".stl", "solid hunter2\nfacet normal hunter2\nvertex hunter2 0 0\nendfacet\n"},
          {".stl", "root:hunter2\n"},
          {".ply", "hunter2\n"},
          {".ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\nhunter2\n"},
          {".hunter3", "hunter2"}}) {
        complaint(name, text);
    }
    for (const char* name : {"sky.exr", "sky.hdr", "sky.png"}) {
        write(name, "root:hunter2:0\n");
        write_scene("scene.toml", "recipe = \"gray.toml\"", "",
                    std::string("type = \"image\"\npath = \"") + name + "\"");
        const Outcome outcome = nacre("render scene.toml " + kDraw);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr(name), Not(HasSubstr("hunter2"))));
    }
    // What the user names may be quoted.
    EXPECT_THAT(nacre("info foreign.toml").err, HasSubstr("foreign.toml"));
    write("own.toml", "hunter2 = 1\n");
    EXPECT_THAT(nacre("info own.toml").err, HasSubstr("hunter2 = 1: unknown key"));
}

TEST_F(Trust, AComplaintOfTheTomlParserNamesTheKey) {
    write("point.toml", "ior = 1.5\n[substrate]\nreflectance = .5\n");
    EXPECT_THAT(nacre("info point.toml").err, HasSubstr("point.toml:3:15: reflectance: "));
    write("odd.toml", "\"a b\" = .5\n");
    EXPECT_THAT(nacre("info odd.toml").err, HasSubstr("odd.toml:1:9: Error"));
}

TEST_F(Trust, AnOutputDoesNotReplaceTheBufferOfAMesh) {
    write_scene("got/scene.toml", "recipe = \"own.toml\"",
                "[[shapes]]\ntype = \"mesh\"\npath = \"own.gltf\"\nmaterial = \"paint\"\n");
    const Outcome outcome =
        nacre("render got/scene.toml --spp 1 --size 2x2 -o x.exr --report got/own.bin");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("--report = got/own.bin: would replace an input, "
                                       "'got/own.bin', which 'got/scene.toml' names"));
    EXPECT_EQ(contents(folder_ / "got/own.bin"), corners());
}

TEST_F(Trust, AStudyKeepsFilesThatAreNotItsOwn) {
    const std::string study = "study mir-2022 -o s --quick --table 4 --quiet";
    fs::create_directories(folder_ / "s/pictures");
    for (const std::string file :
         {"s/index.html", "s/results.json", "s/pictures/table-4-tio2-80-microflake.exr",
          "s/pictures/table-4-tio2-80-microflake.png", "s/pictures/table-4-tio2-80-microflake.json",
          "s/tables/table-4-tio2-80-microflake.h5"}) {
        fs::create_directories((folder_ / file).parent_path());
        write(file, "mine");
        const Outcome outcome = nacre(study);
        EXPECT_EQ(outcome.status, 2) << file << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("cannot write '" + file + "'"));
        EXPECT_EQ(contents(folder_ / file), "mine");
        fs::remove(folder_ / file);
    }
    ASSERT_EQ(nacre(study).status, 0);
    ASSERT_EQ(nacre(study).status, 0) << "over its own";
    for (const char* other : {"flakes", "sparkle"}) {
        fs::create_directories(folder_ / "t");
        write("t/index.html", "mine");
        EXPECT_EQ(nacre(std::string("study ") + other + " -o t --quick --quiet").status, 2);
        EXPECT_EQ(contents(folder_ / "t/index.html"), "mine");
    }
}

TEST_F(Trust, EveryTableKeepsNamesFromBeingFormulas) {
    write("set.toml",
          "name = \"s\"\n[[geometry]]\nname = \"=1+1\"\nlamp_deg = 45\n"
          "aspecular_deg = 25\n[[geometry]]\nname = \"-2\"\nlamp_deg = 45\n"
          "aspecular_deg = 35\n[[geometry]]\nname = \"@a\"\nlamp_deg = 45\n"
          "aspecular_deg = 45\n[[geometry]]\nname = \"+a|b\"\nlamp_deg = 45\n"
          "aspecular_deg = 55\n");
    write("named.toml", "name = \"=cmd|' /C calc'!A0\"\n" + contents(folder_ / "gray.toml"));
    for (const std::string arguments :
         {"measure named.toml --geometry set.toml",
          "measure named.toml --geometry set.toml --versus "
          "gray.toml",
          "atlas --film mica --thickness 100", "atlas --recipe named.toml --key alpha --values 0.1",
          "sparkle named.toml --field 2 "
          "--diffuse-samples 0 --lamp 45",
          "film", "eval named.toml --incident 45 --outgoing 0"}) {
        const Outcome outcome = nacre(arguments);
        ASSERT_EQ(outcome.status, 0) << arguments << '\n' << outcome.err;
        std::size_t cells = 0;
        for (const CsvRow& row : parse_csv(outcome.out, "out")) cells += row.size();
        EXPECT_GT(cells, 5u) << arguments;
        // As a spreadsheet takes them: cells that begin with these are formulas, but for numbers.
        for (std::size_t at = 0; at != std::string::npos;
             at = outcome.out.find_first_of(",\n", at)) {
            if (at > 0) ++at;
            const std::size_t end = outcome.out.find_first_of(",\n", at);
            std::string cell = outcome.out.substr(at, end - at);
            if (cell.starts_with('"')) cell.erase(0, 1);
            const bool formula = !cell.empty() && std::string("=+-@").find(cell[0]) < 4;
            EXPECT_TRUE(!formula || nacre::parse_number(cell)) << arguments << ": " << cell;
        }
    }
}

}  // namespace
}  // namespace nacre::cli::testing
