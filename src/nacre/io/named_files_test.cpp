#include "nacre/io/named_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace nacre::io {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class NamedFiles : public ::testing::Test {
 protected:
    void SetUp() override {
        folder_ = fs::path(::testing::TempDir()) /
                  (std::string("nacre_named_files_test_") +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder_ / "below");
    }
    void TearDown() override { fs::remove_all(folder_); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }

    fs::path folder_;
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
    EXPECT_THAT(files_named_by(folder_ / "paint.toml"),
                UnorderedElementsAre(folder_ / "glass.csv"));
    const fs::path up = folder_ / "below" / "..";
    EXPECT_THAT(files_named_by(folder_ / "below/scene.toml"),
                UnorderedElementsAre(up / "mesh.obj", up / "paint.toml", up / "glass.csv"));
}

TEST_F(NamedFiles, WhatIsNoTomlNamesNone) {
    write("a.csv", "a.csv = [");
    write("self.toml", "name = \"self.toml\"\n");
    EXPECT_THAT(files_named_by(folder_ / "a.csv"), IsEmpty());
    EXPECT_THAT(files_named_by(folder_ / "none.toml"), IsEmpty());
    EXPECT_THAT(files_named_by(folder_), IsEmpty());
    EXPECT_THAT(files_named_by(folder_ / "self.toml"), UnorderedElementsAre(folder_ / "self.toml"));
}

}  // namespace
}  // namespace nacre::io
