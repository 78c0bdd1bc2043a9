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

TEST_F(NamedFiles, WhatIsNoMeshNamesNone) {
    write("a.csv", "any");
    write("a.toml", "ior = \"a.csv\"\n");
    EXPECT_THAT(named_by("a.csv"), IsEmpty());
    EXPECT_THAT(named_by("a.toml"), IsEmpty());
    EXPECT_THAT(named_by("none.obj"), IsEmpty());
    EXPECT_THAT(named_by("none.gltf"), IsEmpty());
    EXPECT_THAT(files_named_by(folder_.path(), References::anywhere(folder_.path())), IsEmpty());
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
}

TEST_F(NamedFiles, OutsideOfTheFolderOfAnUntrustedMeshAreLeftOut) {
    write("glass.mtl", "newmtl a\nmap_Kd wood.png\n");
    write("below/own.mtl", "newmtl a\nmap_Kd ../wood.png\nmap_Ks own.png\n");
    write("wood.png", "any");
    write("below/own.png", "any");
    const fs::path mesh = folder_ / "below/ball.obj";
    write("below/ball.obj",
          "mtllib ../glass.mtl\nmtllib " + (folder_ / "glass.mtl").string() + "\nmtllib own.mtl\n");
    EXPECT_THAT(files_named_by(mesh, References::of_untrusted_file(mesh)),
                UnorderedElementsAre(folder_ / "below/own.mtl", folder_ / "below/own.png"));
}

TEST_F(NamedFiles, AnObjNamesItsMaterialsAndTheirPictures) {
    write("ball.obj", "# a ball\nmtllib ball one.mtl\nv 0 0 0\nusemtl body\n");
    write("ball one.mtl", "newmtl body\nKd 1 1 1\nmap_Kd -s 1 1 1 wood.png\n");
    write("wood.png", "any");
    write("body", "any");
    EXPECT_THAT(named_by("ball.obj"),
                UnorderedElementsAre(folder_ / "ball one.mtl", folder_ / "wood.png"));
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
