#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/program_test_support.h"
#include "nacre/core/file.h"

// `nacre info` opens every kind of file that Nacre reads or writes, and says what others are; so do
// the commands that are given one in the place of another.

namespace nacre::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kTriangle = "# a triangle\nv 0 0 0\nv 20 0 0\nv 0 10 0\nf 1 2 3\n";

std::string scene_of(const std::string& mesh) {
    return "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n[[shapes]]\ntype = \"mesh\"\n"
           "path = \"" +
           mesh + "\"\nmaterial = \"grey\"\n[environment]\ntype = \"constant\"\n";
}

class Info : public Program {
 protected:
    std::string told(const std::string& file) const {
        const Outcome info = nacre("info " + file);
        EXPECT_EQ(info.status, 0) << file << '\n' << info.err;
        EXPECT_THAT(info.err, IsEmpty()) << file;
        return info.out;
    }
};

TEST_F(Info, OpensWhatNacreWrites) {
    for (const char* command :
         {"measure gray.toml -o read.csv", "measure gray.toml --format json -o read.json",
          "measure gray.toml --decimal comma --bom -o excel.csv",
          "measure gray.toml --versus read.csv -o difference.csv --report run.json --plots curves",
          "measure gray.toml --versus read.csv --tolerance 1 --format json -o difference.json",
          "sparkle gray.toml --lamp 15 --field 2 --diffuse-samples 0 -o sparkle.csv",
          "sparkle gray.toml --lamp 15 --field 2 --diffuse-samples 0 --versus gray.toml "
          "-o sparkles.csv",
          "sparkle gray.toml --lamp 15 --field 2 --diffuse-samples 0 --versus gray.toml "
          "--format json -o sparkle.json",
          "export gray.toml -o gray.blender.py --wavelength 400:700:30",
          "export gray.toml -o gray.three.js", "film -o film.csv", "materials -o materials.csv",
          "pigments -o pigments.csv", "eval gray.toml --incident 45 --outgoing 45,180 -o eval.csv",
          "solve gray.toml --wavelength 550 -o gray.h5",
          "export gray.toml --resolution 8 --incidences 8 -o gray.bsdf",
          "atlas --film TiO2_anatase --thickness 40:80:20 -o atlas.csv",
          "render sphere --paint gray.toml --spp 1 --size 2x2 -o picture.exr",
          "render sphere --paint gray.toml --spp 4 --size 2x2 --shard 2/3 -o shard.h5"}) {
        const Outcome outcome = nacre(command);
        ASSERT_EQ(outcome.status, 0) << command << '\n' << outcome.err;
    }
    for (const char* file : {"read.csv", "read.json", "excel.csv"}) {
        EXPECT_THAT(
            told(file),
            AllOf(HasSubstr("kind: measured colours\n"), HasSubstr("light: D65, 10 degrees\n"),
                  HasSubstr("wavelengths: 31 from 400 to 700 nm\n"),
                  HasSubstr("sample: gray, 6 readings, L*a*b* 45as-15 ("), HasSubstr("flop index")))
            << file;
    }
    EXPECT_THAT(told("difference.csv"),
                AllOf(HasSubstr("colour differences"), HasSubstr("rows: 6")));
    EXPECT_THAT(told("difference.json"),
                AllOf(HasSubstr("holds: colour differences"), HasSubstr("illuminant: D65\n"),
                      HasSubstr("angles: 6\n"), HasSubstr("max_delta_e_2000: 0.0\n"),
                      HasSubstr("passes: true\n")));
    EXPECT_THAT(told("sparkle.csv"), HasSubstr("holds: sparkle and graininess"));
    EXPECT_THAT(told("sparkles.csv"), HasSubstr("holds: differences of sparkle"));
    EXPECT_THAT(told("sparkle.json"),
                AllOf(HasSubstr("holds: sparkle and graininess"), HasSubstr("recipe: gray.toml\n"),
                      HasSubstr("readings: 1\n"), HasSubstr("comparison: 4\n")));
    EXPECT_THAT(told("run.json"), HasSubstr("command: measure\n"));
    EXPECT_THAT(told("gray.blender.py"),
                AllOf(HasSubstr("Blender's Cycles"), HasSubstr("name: gray\n"),
                      HasSubstr("generator: Nacre "),
                      HasSubstr("differences from the paint: CIEDE2000, mean and greatest ")));
    EXPECT_THAT(told("gray.three.js"),
                AllOf(HasSubstr("three.js"), HasSubstr("name: gray\n"),
                      HasSubstr("generator: Nacre "), HasSubstr("recipe SHA-256: "),
                      HasSubstr("differences from the paint: CIEDE2000, mean and greatest ")));
    const Outcome diff = nacre("diff picture.exr picture.exr");
    write("diff.csv", diff.out);
    EXPECT_THAT(told("diff.csv"), HasSubstr("holds: the difference of two pictures"));
    EXPECT_THAT(told("curves/spectra.svg"), HasSubstr("kind: a drawing (SVG)"));
    EXPECT_THAT(told("film.csv"),
                HasSubstr("columns: wavelength_nm, angle_deg, polarization, R, T"));
    EXPECT_THAT(told("materials.csv"), HasSubstr("nacre materials"));
    EXPECT_THAT(told("pigments.csv"), HasSubstr("nacre pigments"));
    EXPECT_THAT(told("eval.csv"), HasSubstr("nacre eval"));
    EXPECT_THAT(told("atlas.csv"), HasSubstr("nacre atlas"));
    EXPECT_THAT(told("gray.h5"), HasSubstr("kind: solved paint"));
    EXPECT_THAT(told("gray.bsdf"), HasSubstr("RGL"));
    EXPECT_THAT(told("picture.exr"), HasSubstr("size: 2 x 2 pixels"));
    EXPECT_THAT(told("picture.png"), HasSubstr("kind: picture"));
    EXPECT_THAT(told("shard.h5"),
                AllOf(HasSubstr("kind: shard 2/3 of a picture"),
                      HasSubstr("samples: 1 of 4 per pixel"), HasSubstr("nacre:scene: sphere")));
}

TEST_F(Info, OpensWhatNacreReads) {
    write("triangle.obj", kTriangle);
    EXPECT_THAT(told("triangle.obj"), AllOf(HasSubstr("kind: a mesh\n"), HasSubstr("triangles: 1"),
                                            HasSubstr("size: 20 x 10 x 0 mm")));
    EXPECT_THAT(nacre("info -", "cat triangle.obj |").out, HasSubstr("triangles: 1"));
    write("triangle.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
          "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_THAT(told("triangle.ply"), HasSubstr("triangles: 1"));
    ASSERT_EQ(nacre("export gray.toml -o gray.gltf").status, 0);
    EXPECT_THAT(told("gray.gltf"), HasSubstr("kind: a mesh"));
    write("scene.toml", scene_of("triangle.obj"));
    EXPECT_THAT(told("scene.toml"),
                AllOf(HasSubstr("kind: scene"),
                      HasSubstr("shapes[0]: mesh triangle.obj, 1 triangles, 3 vertices")));
    write("set.toml", "name = \"booth\"\n[[geometry]]\nlamp_deg = 20\naspecular_deg = 30\n");
    EXPECT_THAT(told("set.toml"), AllOf(HasSubstr("kind: a set of geometries"),
                                        HasSubstr("geometry: 20as30 (lamp 20 deg")));
    write("glass.csv", "# source: a book\nwavelength_nm,n,k\n400,1.6,0\n700,1.5,0.1\n");
    EXPECT_THAT(
        told("glass.csv"),
        AllOf(HasSubstr("kind: a file of optical constants"), HasSubstr("source: a book"),
              HasSubstr("range: 400 to 700 nm"), HasSubstr("index: 1.55 + 0.05i at 550 nm")));
    write("glass.yml",
          "DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5 0\n        0.7 1.4 0\n");
    EXPECT_THAT(told("glass.yml"), HasSubstr("range: 400 to 700 nm"));
    write("grey.csv", "wavelength_nm,reflectance\n400,0.25\n700,0.5\n");
    EXPECT_THAT(told("grey.csv"), HasSubstr("values: reflectance: 0.25 to 0.5"));
    for (const auto& [file, words] :
         {std::pair{"data/pigments/chalk.toml", "holds: particles"},
          {"data/drawdowns/organic-blue-synthetic.csv", "grounds: black, white"},
          {"scenes/flakes.toml", "kind: scene"}}) {
        EXPECT_THAT(told(shipped_file(file).string()), HasSubstr(words)) << file;
    }
}

TEST_F(Info, TellsTheSamplesOfAFile) {
    write("panels.csv", "Probe;L 15;a 15;b 15\nSilber;120,5;0;0\nRot;50;60;30\n");
    EXPECT_THAT(told("panels.csv"),
                AllOf(HasSubstr("sample 1: Silber, 1 readings, L*a*b* 45as15 (120.5, 0.0, 0.0)\n"),
                      HasSubstr("sample 2: Rot"), HasSubstr("wavelengths: none: colours only")));
    EXPECT_THAT(told("'panels.csv#Rot'"),
                AllOf(HasSubstr("sample: Rot, "), Not(HasSubstr("Silber"))));
    EXPECT_THAT(nacre("info 'panels.csv#Blau'").err,
                HasSubstr("panels.csv: has no sample 'Blau', but 2: 'Silber', 'Rot'"));
    EXPECT_THAT(nacre("info 'gray.toml#1'").err, HasSubstr("only measured colours have samples"));
    write("percent.csv", "geometry,R400,R500\n45as45,45.2,45\n");
    EXPECT_THAT(told("percent.csv"),
                HasSubstr("note: percent.csv: reflectances of up to 45.2 are"));
}

TEST_F(Info, SaysWhatAFileIsThatItDoesNotRead) {
    const auto refused = [&](const std::string& name, const std::string& text) {
        write(name, text);
        const Outcome info = nacre("info " + name);
        EXPECT_EQ(info.status, 2) << name;
        EXPECT_THAT(info.out, IsEmpty());
        EXPECT_THAT(info.err, HasSubstr(name));
        EXPECT_THAT(info.err, Not(HasSubstr("expected '='"))) << name;
        return info.err;
    };
    EXPECT_THAT(refused("a.csv", "key,value\n1,2\n"),
                AllOf(HasSubstr("a.csv:1:1: 'key' is in no header that is known"),
                      HasSubstr("geometry (45as15")));
    EXPECT_THAT(refused("a.xlsx", std::string("PK\x03\x04\0", 5)),
                HasSubstr("save the table in it as CSV"));
    EXPECT_THAT(refused("a.cxf", "<?xml version=\"1.0\"?>\n<cc:CxF/>\n"), HasSubstr("CxF"));
    EXPECT_THAT(refused("a.json", "{\"a\": 1}"), HasSubstr("JSON"));
    EXPECT_THAT(refused("latin.csv",
                        "Pr\xfc"
                        "fling;Winkel;L;a;b\n"),
                HasSubstr("latin.csv:1:3: is not UTF-8"));
    EXPECT_THAT(refused("latin.toml", "name = \"gr\xfcn\"\n"), HasSubstr("save the file as UTF-8"));
    EXPECT_THAT(refused("wide.toml", std::string("\xFF\xFEn\0", 4)), HasSubstr("UTF-16"));
    EXPECT_THAT(refused("empty.csv", ""), HasSubstr("is empty"));
    write("scene.toml", scene_of("absent.obj"));
    EXPECT_THAT(nacre("info scene.toml").err,
                HasSubstr("scene.toml:6:8: shapes[0].path: cannot read"));
}

TEST_F(Info, OtherCommandsSayWhatTheyWereGivenInstead) {
    write("triangle.obj", kTriangle);
    write("scene.toml", scene_of("triangle.obj"));
    ASSERT_EQ(nacre("measure gray.toml -o read.csv").status, 0);
    for (const auto& [command, words] :
         {std::pair{"eval triangle.obj --incident 45 --outgoing 45",
                    "triangle.obj: is a mesh; needed"},
          {"measure scene.toml", "scene.toml: is a scene; needed here is a recipe"},
          {"render triangle.obj -o x.exr", "is a mesh; a text in TOML is needed"},
          {"render read.csv -o x.exr", "read.csv: is measured colours; a text in TOML"},
          {"measure gray.toml --geometry ./read.csv.toml", "read.csv.toml"},
          {"fit gray.toml --start read.csv --free alpha",
           "read.csv: holds measured colours; a recipe"}}) {
        const Outcome outcome = nacre(command);
        EXPECT_EQ(outcome.status, 2) << command;
        EXPECT_THAT(outcome.err, HasSubstr(words)) << command;
    }
    write("comma.toml", "ior = 1,5\n");
    EXPECT_THAT(nacre("eval comma.toml --incident 45 --outgoing 45").err,
                HasSubstr("comma.toml:1:8: ior: 1,5: a number has a decimal point: 1.5"));
}

TEST_F(Info, TablesMayHaveDecimalCommas) {
    write("primer.csv", "wavelength_nm;R\n400;0,2\n700;0,4\n");
    EXPECT_THAT(nacre("info primer.csv").out, HasSubstr("0.2 to 0.4"));
    write("glass.csv", "wavelength_nm;n\n400;1,6\n700;1,5\n");
    EXPECT_THAT(nacre("film --substrate glass.csv --wavelength 400").out,
                HasSubstr("400,0,u,0.053254"));
    write("mixed.csv", "wavelength_nm;R\n400;0,2\n700;0.4\n");
    const Outcome mixed = nacre("info mixed.csv");
    EXPECT_EQ(mixed.status, 2);
    EXPECT_THAT(mixed.err, HasSubstr("mixed.csv:2:5: 0,2 has a decimal comma"));
}

}  // namespace
}  // namespace nacre::cli::testing
