#include "nacre/core/references.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/testing/files.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

class ReferencesTest : public testing::Test {
 protected:
    void SetUp() override {
        fs::create_directories(folder_ / "scene" / "parts");
        fs::create_directory(folder_ / "scene-2");
        for (const char* file : {"secret.csv", "scene/own.csv", "scene/parts/part.csv"}) {
            folder_.write(file, "x");
        }
        fs::create_symlink("../secret.csv", folder_ / "scene" / "leading-out.csv");
        fs::create_symlink("parts/part.csv", folder_ / "scene" / "staying.csv");
    }

    test::TempFolder folder_;
};

TEST_F(ReferencesTest, WithinAFolderNothingLeadsOut) {
    const References references = References::within(folder_ / "scene");
    for (const char* name :
         {"own.csv", "parts/part.csv", "parts/../own.csv", "staying.csv", "absent.csv"}) {
        EXPECT_EQ(references.resolve(name), folder_ / "scene" / name);
    }
    EXPECT_NO_THROW(references.resolve(folder_ / "scene" / "own.csv"));
    for (const fs::path& name :
         {fs::path("../secret.csv"), fs::path("leading-out.csv"), folder_ / "secret.csv",
          fs::path("/etc/passwd"), fs::path("../scene-2/x.csv"),
          fs::path("absent/../../secret.csv"), fs::path("/dev/fd/0")}) {
        EXPECT_THAT([&] { references.resolve(name); },
                    ThrowsMessage<InputError>(HasSubstr("is outside the folder")))
            << name;
    }
}

TEST_F(ReferencesTest, WhatIsNamedHasTheSamePermission) {
    const References references =
        References::within(folder_ / "scene").beside(folder_ / "scene" / "parts" / "part.toml");
    EXPECT_EQ(references.resolve("part.csv"), folder_ / "scene" / "parts" / "part.csv");
    EXPECT_NO_THROW(references.resolve("../own.csv"));
    EXPECT_THROW(references.resolve("../../secret.csv"), InputError);
    EXPECT_THROW(References().beside(folder_ / "x.toml").resolve("x.csv"), InputError);
}

TEST_F(ReferencesTest, OnlyWhatNobodyNamedMayBeQuoted) {
    EXPECT_TRUE(References().may_quote());
    const References scene = References::of_file(folder_ / "scene" / "scene.toml");
    EXPECT_TRUE(scene.may_quote());
    EXPECT_FALSE(scene.beside(folder_ / "secret.csv").may_quote());
}

TEST_F(ReferencesTest, EachFileThatIsNamedAndPermittedIsCheckedBeforeItIsRead) {
    std::vector<fs::path> seen;
    const References within = References::within(folder_ / "scene");
    const References checked = within.checked_by([&](const fs::path& path) {
        seen.push_back(path);
        if (path.filename() == "absent.csv") throw std::runtime_error("is an output");
    });
    EXPECT_EQ(checked.resolve("own.csv"), within.resolve("own.csv"));
    EXPECT_EQ(checked.beside(folder_ / "scene/parts/part.toml").resolve("part.csv"),
              folder_ / "scene/parts/part.csv");
    EXPECT_THROW(checked.resolve("../secret.csv"), InputError);
    EXPECT_THAT([&] { checked.resolve("absent.csv"); },
                ThrowsMessage<std::runtime_error>("is an output"));
    EXPECT_THAT(seen,
                testing::ElementsAre(folder_ / "scene/own.csv", folder_ / "scene/parts/part.csv",
                                     folder_ / "scene/absent.csv"));
}

TEST_F(ReferencesTest, OfAnUntrustedFileStayInItsFolder) {
    const fs::path scene = folder_ / "scene" / "scene.toml";
    const References references = References::of_untrusted_file(scene);
    EXPECT_EQ(references.resolve("own.csv"), folder_ / "scene" / "own.csv");
    EXPECT_THROW(references.resolve("../secret.csv"), InputError);
    EXPECT_EQ(References::of_untrusted_file("violet.toml"), References::within("."));
    EXPECT_EQ(References::of_untrusted_file("-"), References());
}

TEST(References, OfTheUsersOwnFileAreAnywhereAndOfAStreamNone) {
    EXPECT_EQ(References::of_file("paints/violet.toml").resolve("../x.csv"), "paints/../x.csv");
    EXPECT_EQ(References::of_file("violet.toml").resolve("x.csv"), "x.csv");
    EXPECT_EQ(References("paints").resolve("/etc/x.csv"), "/etc/x.csv");
    for (const References& none : {References(), References(""), References::of_file("-"),
                                   References::of_file("/dev/stdin")}) {
        EXPECT_THAT([&] { none.resolve("x.csv"); },
                    ThrowsMessage<InputError>(HasSubstr("may name none")));
    }
}

TEST_F(ReferencesTest, FilesAreReadOnceForAllCopies) {
    const fs::path own = folder_ / "scene" / "own.csv";
    const References references = References::within(folder_ / "scene");
    const References copy = references.beside(folder_ / "scene" / "parts" / "part.csv");
    EXPECT_EQ(*references.read(own, 100), "x");
    folder_.write("scene/own.csv", "other");
    EXPECT_EQ(*copy.read(own, 100), "x");
    EXPECT_EQ(*References::within(folder_ / "scene").read(own, 100), "other");
    EXPECT_EQ(references, References::within(folder_ / "scene"));
    // What could not be read is tried again.
    const fs::path late = folder_ / "scene" / "late.csv";
    EXPECT_THROW(references.read(late, 100), InputError);
    folder_.write("scene/late.csv", "there");
    EXPECT_THROW(references.read(late, 4), InputError);
    EXPECT_EQ(*references.read(late, 5), "there");
    EXPECT_THROW(references.read(late, 4), InputError);
}

}  // namespace
}  // namespace nacre
