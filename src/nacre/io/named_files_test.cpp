#include "nacre/io/named_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/testing/files.h"

namespace nacre::io {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class NamedFiles : public ::testing::Test {
 protected:
    NamedFiles() { fs::create_directory(folder_ / "below"); }
    void write(const std::string& name, const std::string& text) const {
        folder_.write(name, text);
    }
    std::vector<fs::path> named_by(const std::string& name) const {
        return files_named_by(folder_ / name, References::of_file(folder_ / name));
    }

    const test::TempFolder folder_;
};

TEST_F(NamedFiles, AreThoseOfARecipeAndOfWhatASceneNames) {
    write("glass.csv", "wavelength_nm,n,k\n");
    write("mesh.obj", "");
    write("paint.toml",
          "name = \"mesh\"\nior = \"glass.csv\"\n[[layer]]\nthickness_um = 3\n"
          "[[layer.flakes]]\ncoats = [ { material = \"none.csv\" } ]\n");
    write("below/scene.toml",
          "[[shapes]]\npath = \"../mesh.obj\"\n"
          "[materials.paint]\nrecipe = \"../paint.toml\"\n");
    EXPECT_THAT(named_by("paint.toml"), UnorderedElementsAre(folder_ / "glass.csv"));
    const fs::path up = folder_ / "below" / "..";
    EXPECT_THAT(named_by("below/scene.toml"),
                UnorderedElementsAre(up / "mesh.obj", up / "paint.toml", up / "glass.csv"));
}

TEST_F(NamedFiles, WhatIsNoTomlNamesNone) {
    write("a.csv", "a.csv = [");
    write("self.toml", "name = \"self.toml\"\n");
    EXPECT_THAT(named_by("a.csv"), IsEmpty());
    EXPECT_THAT(named_by("none.toml"), IsEmpty());
    EXPECT_THAT(files_named_by(folder_.path(), References::anywhere(folder_.path())), IsEmpty());
    EXPECT_THAT(named_by("self.toml"), UnorderedElementsAre(folder_ / "self.toml"));
}

/// A .glb: header, the chunk of JSON, and that of its buffer.
std::string glb(const std::string& json) {
    const auto number = [](std::size_t n) {
        std::string bytes;
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(n >> (8 * i) & 0xff);
        return bytes;
    };
    return "glTF" + number(2) + number(12 + 8 + json.size()) + number(json.size()) + "JSON" + json;
}

TEST_F(NamedFiles, OfAMeshAreTheBuffersAndPicturesOfAGltf) {
    const std::string json =
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":"a%20buffer.bin"},{"uri":"none.bin"},)"
        R"({"uri":"data:;base64,AAAA"}],"images":[{"uri":"below/wood.png"},{"uri":"../x.png"}]})";
    for (const char* name : {"a buffer.bin", "below/wood.png", "x.png"}) write(name, "any");
    write("mesh.gltf", json);
    write("mesh.glb", glb(json));
    write("deep.gltf", std::string(100'000, '['));
    write("cut.glb", glb(json).substr(0, 40));
    const fs::path buffer = folder_ / "a buffer.bin", picture = folder_ / "below/wood.png";
    EXPECT_THAT(named_by("mesh.gltf"), UnorderedElementsAre(buffer, picture));
    EXPECT_THAT(named_by("mesh.glb"), UnorderedElementsAre(buffer, picture));
    EXPECT_THAT(named_by("deep.gltf"), IsEmpty());
    EXPECT_THAT(named_by("cut.glb"), IsEmpty());
    write("scene.toml", "[[shapes]]\npath = \"mesh.gltf\"\n");
    EXPECT_THAT(named_by("scene.toml"),
                UnorderedElementsAre(folder_ / "mesh.gltf", buffer, picture));
}

TEST_F(NamedFiles, OutsideOfTheFolderOfAnUntrustedFileAreLeftOut) {
    write("glass.csv", "any");
    write("below/own.csv", "any");
    write("below/paint.toml", "ior = \"../glass.csv\"\nname = \"own.csv\"\n");
    write("below/scene.toml",
          "a = \"paint.toml\"\nb = \"" + (folder_ / "glass.csv").string() + "\"\n");
    const fs::path scene = folder_ / "below/scene.toml";
    EXPECT_THAT(files_named_by(scene, References::of_untrusted_file(scene)),
                UnorderedElementsAre(folder_ / "below/paint.toml", folder_ / "below/own.csv"));
}

TEST_F(NamedFiles, AnObjNamesItsMaterialsAndTheirPictures) {
    write("ball.obj", "# a ball\nmtllib ball one.mtl\nv 0 0 0\nusemtl body\n");
    write("ball one.mtl", "newmtl body\nKd 1 1 1\nmap_Kd -s 1 1 1 wood.png\n");
    write("wood.png", "any");
    write("body", "any");
    EXPECT_THAT(named_by("ball.obj"),
                UnorderedElementsAre(folder_ / "ball one.mtl", folder_ / "wood.png"));
    write("scene.toml", "[[shapes]]\npath = \"ball.obj\"\n");
    EXPECT_THAT(
        named_by("scene.toml"),
        UnorderedElementsAre(folder_ / "ball.obj", folder_ / "ball one.mtl", folder_ / "wood.png"));
}

TEST_F(NamedFiles, LinesLongerThanAPathAreNotLookedThrough) {
    std::string names;
    for (int i = 0; i < 1'000'000; ++i) names += " a";
    write("ball.obj", "mtllib" + names + "\nmtllib ball.mtl\n");
    write("ball.mtl", "newmtl a\n");
    write("a", "any");
    EXPECT_THAT(named_by("ball.obj"), UnorderedElementsAre(folder_ / "ball.mtl"));
}

}  // namespace
}  // namespace nacre::io
