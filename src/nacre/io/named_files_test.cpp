#include "nacre/io/named_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/testing/files.h"

namespace nacre::io {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

TEST(NamedFiles, AreThoseOfARecipeAndOfWhatASceneNames) {
    const test::TempFolder folder;
    fs::create_directory(folder / "below");
    folder.write("glass.csv", "wavelength_nm,n,k\n");
    folder.write("mesh.obj", "");
    folder.write("paint.toml",
                 "name = \"mesh\"\nior = \"glass.csv\"\n[[layer]]\nthickness_um = 3\n"
                 "[[layer.flakes]]\ncoats = [ { material = \"none.csv\" } ]\n");
    folder.write("below/scene.toml",
                 "[[shapes]]\npath = \"../mesh.obj\"\n"
                 "[materials.paint]\nrecipe = \"../paint.toml\"\n");
    EXPECT_THAT(files_named_by(folder / "paint.toml"), UnorderedElementsAre(folder / "glass.csv"));
    const fs::path up = folder / "below" / "..";
    EXPECT_THAT(files_named_by(folder / "below/scene.toml"),
                UnorderedElementsAre(up / "mesh.obj", up / "paint.toml", up / "glass.csv"));
}

TEST(NamedFiles, WhatIsNoTomlNamesNone) {
    const test::TempFolder folder;
    folder.write("a.csv", "a.csv = [");
    folder.write("self.toml", "name = \"self.toml\"\n");
    EXPECT_THAT(files_named_by(folder / "a.csv"), IsEmpty());
    EXPECT_THAT(files_named_by(folder / "none.toml"), IsEmpty());
    EXPECT_THAT(files_named_by(folder), IsEmpty());
    EXPECT_THAT(files_named_by(folder / "self.toml"), UnorderedElementsAre(folder / "self.toml"));
}

}  // namespace
}  // namespace nacre::io
