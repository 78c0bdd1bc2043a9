#include "nacre/io/file_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/pigment_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/toml_document.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

TEST(FileKind, IsToldByContents) {
    std::string stl(80, ' ');
    stl += std::string("\1\0\0\0", 4) + std::string(50, '\0');
    const std::vector<std::pair<std::string, FileKind>> cases = {
        {"ior = 1.5\n[[layer]]\nthickness_um = 1\n", FileKind::recipe},
        {"ior 1,5\n[[layer]]\n", FileKind::recipe},
        {"[[shapes]]\ntype = \"sphere\"\n", FileKind::scene},
        {"[[geometry]]\nlamp_deg = 45\n", FileKind::geometry_set},
        {"name = \"chalk\"\nmaterial = \"CaCO3_o\"\ndiameter_nm = 1000\n", FileKind::pigment},
        {"name = \"x\"\n", FileKind::recipe},
        {"geometry,L,a,b\n45as15,1,2,3\n", FileKind::measured_colours},
        {"Winkel;L*;a*;b*\n15;1,5;2;3\n", FileKind::measured_colours},
        {"Probe;L 15;a 15;b 15\nA;1;2;3\n", FileKind::measured_colours},
        {"{\"format\": \"nacre-measurement\"}", FileKind::measured_colours},
        {"CGATS.17\nBEGIN_DATA_FORMAT\nLAB_L\n", FileKind::measured_colours},
        {"# x\nground,thickness_um,volume_fraction,400,410,420,430,440\n", FileKind::drawdown},
        {"# source: x\nwavelength_nm,n,k\n400,1,0\n", FileKind::material},
        {"REFERENCES: \"x\"\nDATA:\n  - type: tabulated n\n", FileKind::material},
        {"wavelength_nm,reflectance\n400,0.5\n", FileKind::spectrum},
        {"# by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", FileKind::mesh},
        {"ply\nformat ascii 1.0\n", FileKind::mesh},
        {"glTF\2", FileKind::mesh},
        {"{\"asset\": {\"version\": \"2.0\"}}", FileKind::mesh},
        {"solid x\nfacet normal 0 0 1\n", FileKind::mesh},
        {stl, FileKind::mesh},
        {"wavelength_nm,angle_deg,polarization,R,T\n", FileKind::result_table},
        {"wavelength_nm;angle_deg;polarization;R;T\n", FileKind::result_table},
        {"geometry,theta_i,aspecular_deg,L_standard,a_standard\n", FileKind::result_table},
        {"thickness_nm,theta_i,aspecular_deg,L,a,b,C,h,chip\n", FileKind::result_table},
        {"geometry,quantity,standard,standard_se,sample\n", FileKind::result_table},
        {"quantity,value\nmse,0\n", FileKind::result_table},
        {"quantity;value\nmse;0,5\n", FileKind::result_table},
        {"quantity,value\nmass,0\n", FileKind::other_table},
        {"{\"command\": \"measure\", \"version\": \"1\"}", FileKind::report},
        {"{\"angles\": [1], \"format\": \"nacre-difference\", "
         "\"sample\": {\"format\": \"nacre-measurement\"}}",
         FileKind::result_document},
        {"{\"distance_mm\": 500.0, \"format\": \"nacre-sparkle\"}", FileKind::result_document},
        {"{\"a\": {\"format\": \"nacre-sparkle\"}}", FileKind::other_json},
        {"{\"format\": \"nacre-sparkle\", \"cut\": [1", FileKind::result_document},
        {"\"\"\"A paint for Blender's Cycles: a node group", FileKind::cycles_script},
        {"// A paint as a material of three.js (0.154", FileKind::threejs_module},
        {"<?xml version=\"1.0\"?>\n<materialx version=\"1.38\">", FileKind::materialx},
        {"<!doctype html>\n", FileKind::page},
        {"<svg width=\"1\">", FileKind::plot},
        {"", FileKind::empty},
        {"key,value\n1,2\n", FileKind::other_table},
        {"{\"a\": 1}", FileKind::other_json},
        {"<?xml version=\"1.0\"?>\n<cc:CxF>", FileKind::measured_colours},
        {"<?xml version=\"1.0\"?>\n<note>", FileKind::other_xml},
        {"\x89HDF\r\n\x1a\n", FileKind::other_hdf5},
        {"nacre share of a picture\nversion 1\n", FileKind::picture_shard},
        {"\xFF\xD8\xFF\xE0", FileKind::other_picture},
        {std::string("PK\x03\x04\0", 5), FileKind::spreadsheet},
        {"%PDF-1.7\n", FileKind::document},
        {std::string("\xFF\xFEn\0", 4), FileKind::other_encoding},
        {"name = \"Pr\xfc"
         "fling\"\n",
         FileKind::other_encoding},
        {std::string("\1\2\0\0\3", 5), FileKind::binary}};
    for (const auto& [text, kind] : cases) {
        EXPECT_EQ(words_for(file_kind(text)), words_for(kind)) << text;
    }
    EXPECT_EQ(file_kind(read_file(shipped_file("scenes/flakes.toml"))), FileKind::scene);
    EXPECT_EQ(file_kind(read_file(shipped_file("paints/ruby.toml"))), FileKind::recipe);
}

TEST(FileKind, LongAndDeepJsonIsToldByItsOutermostKeys) {
    std::string text = "{\"angles\": [";
    while (text.size() < (1 << 17)) text += "[0.5], ";
    EXPECT_EQ(kind_of_bytes(text + "1], \"format\": \"nacre-difference\"}"),
              FileKind::result_document);
    EXPECT_EQ(kind_of_bytes("{\"a\": " + std::string(1'000'000, '[')), FileKind::other_json);
}

TEST(FileKind, ALongTextMayBeCutWithinACharacter) {
    std::string text = "name = \"";
    while (text.size() < (1 << 16) - 1) text += 'x';
    text += "\u00e9\"\n";
    EXPECT_EQ(kind_of_bytes(text), FileKind::text);
}

TEST(FileKind, AReaderOfTomlSaysWhatItWasGivenInstead) {
    const auto complaint = [](const std::string& text, const References& references = {}) {
        return message_of<InputError>([&] { TomlDocument(text, "f", references); });
    };
    EXPECT_EQ(complaint("geometry,L,a,b\n45as15,1,2,3\n"),
              "f: is measured colours; a text in TOML is needed here");
    EXPECT_THAT(complaint("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), HasSubstr("f: is a mesh"));
    EXPECT_THAT(complaint("n\xe4me = 1\n"), HasSubstr("f:1:2: is not UTF-8"));
    EXPECT_THAT(complaint("15 122.4 -0.6 -1.1\n"),
                HasSubstr("f:1:4: the file is of no kind that is read here; taken for TOML: "));
    EXPECT_EQ(complaint("\xEF\xBB\xBFname = \"x\"\n"), "accepted");
    // A file that another one names is not talked about.
    EXPECT_EQ(complaint("v 0 0 0\n", References().beside("x")), "f:1:3: is not TOML");
}

TEST(FileKind, IsToldOnceAndTomlParsedOnce) {
    const std::string recipe = "ior = 1.4\n[[layer]]\nthickness_um = 7\n";
    TypedFile file = typed_file(recipe, "a.toml", References());
    EXPECT_EQ(file.kind, FileKind::recipe);
    EXPECT_EQ(parse_recipe_file(file).recipe, parse_recipe(recipe, "a.toml", {}));
    // What has been parsed is not parsed again.
    file.bytes = "geometry,L,a,b\n45as15,1,2,3\n";
    EXPECT_EQ(parse_recipe_file(file).recipe, parse_recipe(recipe, "a.toml", {}));
    const TypedFile thin = typed_file(test::replaced(recipe, "7", "0"), "a.toml", References());
    EXPECT_THAT(message_of<InputError>([&] { parse_recipe_file(thin); }),
                HasSubstr("a.toml:3:16: layer[0].thickness_um = 0"));
    // A text that is not TOML counts as a recipe, and its reader says what is wrong.
    const TypedFile wrong = typed_file("ior = 1,5\n", "b.toml", References());
    EXPECT_EQ(wrong.kind, FileKind::recipe);
    EXPECT_THAT(message_of<InputError>([&] { parse_recipe_file(wrong); }),
                HasSubstr("b.toml:1:8: ior: 1,5: a number has a decimal point"));
    for (const char* other : {"", "geometry,L,a,b\n45as15,1,2,3\n", "ply\nformat ascii 1.0\n"}) {
        EXPECT_EQ(typed_file(other, "c", References()).kind, file_kind(other)) << other;
    }
    // A pigment may name no files, whatever its file may.
    const std::string pigment = "name = \"chalk\"\nmaterial = \"chalk.csv\"\ndiameter_nm = 1000\n";
    const TypedFile chalk = typed_file(pigment, "chalk.toml", References::anywhere(""));
    EXPECT_EQ(chalk.kind, FileKind::pigment);
    EXPECT_EQ(message_of<InputError>([&] { parse_pigment_file(chalk, 0.1); }),
              message_of<InputError>([&] { parse_pigment_file(pigment, "chalk.toml", 0.1); }));
}

TEST(FileKind, ADecimalCommaInTomlIsPointedAt) {
    const auto complaint = [](const std::string& text) {
        return message_of<InputError>([&] { TomlDocument(text, "f", {}); });
    };
    EXPECT_EQ(complaint("a = 1\nvolume_fraction = 0,03  # 3 %\n"),
              "f:2:20: volume_fraction: 0,03: a number has a decimal point: 0.03");
    EXPECT_THAT(complaint("o = { law = \"beckmann\", alpha = -0,25 }\n"),
                HasSubstr("o: -0,25: a number has a decimal point: -0.25"));
    EXPECT_EQ(complaint("a = [0,3]\n"), "accepted") << "two numbers";
}

}  // namespace
}  // namespace nacre::io
