#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/program_test_support.h"

// What the program writes: never over its inputs, never half, and never with success when it is
// lost.

namespace nacre::cli::testing {

namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Files : public Program {
 protected:
    /// The names in the test's folder that a command left there half made.
    std::vector<std::string> partial_files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_ / "")) {
            const std::string name = entry.path().filename().string();
            if (name.find(".partial") != std::string::npos) names.push_back(name);
        }
        return names;
    }

    /// Runs `nacre ARGUMENTS` where no file may hold a byte, as on a full disk. Its output goes
    /// through a pipe.
    Outcome nacre_without_space(const std::string& arguments) const {
        return shell("{ (ulimit -f 0; \"$NACRE\" " + arguments +
                     "); echo $? > .status; } 2>&1 | cat; exit $(cat .status)");
    }
};

TEST_F(Files, TwoOutputsAreTwoFiles) {
    fs::create_directory(folder_ / "d");
    fs::create_directory_symlink("d", folder_ / "link");
    for (const std::string& arguments :
         {kEval + "-o x.csv --report x.csv", kEval + "-o x.csv --report ./d/../x.csv",
          kEval + "-o d/x.csv --report link/x.csv", kRender + "-o k.exr --report k.exr",
          kRender + "-o k.exr --report k.png"}) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments << '\n' << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("is the same file as --")) << arguments;
    }
    for (const char* name : {"x.csv", "d/x.csv", "k.exr", "k.png"}) EXPECT_FALSE(exists(name));
    // What a command writes into a folder, there or not yet.
    const std::string measure = "measure gray.toml --geometry 45as15 --quiet ";
    for (const std::string& arguments :
         {measure + "--plots d -o d/lightness.svg", measure + "--plots d -o link/travel.png",
          measure + "--plots d --report d/spectra.svg", measure + "--plots link -o d/spectra.png",
          measure + "--plots new -o new/lightness.png",
          std::string("sparkle gray.toml --pictures d -o d/45s.exr"),
          std::string("sparkle gray.toml --lamp 22.5 --pictures d --report link/22.5s.png"),
          std::string("sparkle gray.toml --pictures d -o d/diffuse.png")}) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments << '\n' << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("is the same file as --")) << arguments;
    }
    for (const std::string& arguments :
         {measure + "--plots p --report p", measure + "--plots p -o p",
          measure + "--plots p/q/r -o p/q", std::string("sparkle gray.toml --pictures p -o p")}) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments << '\n' << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("is the folder for --")) << arguments;
    }
    EXPECT_TRUE(fs::is_empty(folder_ / "d"));
    EXPECT_FALSE(exists("p"));
    fs::create_directory(folder_ / "e");
    EXPECT_EQ(nacre(measure + "--plots e -o e/values.csv --report e/run.json").status, 0);
    EXPECT_TRUE(exists("e/lightness.svg") && exists("e/values.csv"));
    EXPECT_EQ(nacre(kEval + "-o x.csv --report x.json").status, 0);
    EXPECT_EQ(nacre(kEval + "-o /dev/null --report /dev/null").status, 0);
}

TEST_F(Files, ThePictureBesideAnExrIsReplacedOnlyIfItIsOneOfOurs) {
    ASSERT_EQ(nacre(kRender + "-o k.exr").status, 0);
    ASSERT_EQ(nacre(kRender + "-o k.exr").status, 0);  // over its own
    // A picture of another program: the same without its text chunks.
    const std::string own = contents(folder_ / "k.png");
    const std::size_t text = own.find("tEXt") - 4;
    ASSERT_LT(text, own.size());
    const std::string foreign = own.substr(0, text) + own.substr(own.find("IDAT") - 4);
    for (const std::string& picture : {foreign, std::string("no picture"), std::string()}) {
        write("k.png", picture);
        const std::string exr = contents(folder_ / "k.exr");
        const Outcome outcome = nacre(kRender + "-o k.exr");
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("cannot write 'k.png' beside the EXR"),
                                       HasSubstr("rename or remove it")));
        EXPECT_EQ(contents(folder_ / "k.png"), picture);
        EXPECT_EQ(contents(folder_ / "k.exr"), exr);
    }
    EXPECT_EQ(nacre("info k.exr").status, 0);
    // The same for pictures in a folder; here before the recipe is even read.
    fs::create_directory(folder_ / "seen");
    write("seen/diffuse.png", "mine");
    const Outcome sparkle = nacre("sparkle no-such.toml --pictures seen");
    EXPECT_EQ(sparkle.status, 2);
    EXPECT_THAT(sparkle.err, HasSubstr("seen/diffuse.png"));
}

/// Every command, with an input that is not there: whoever complains of its output has looked at
/// that before any work. %o stands for what is written.
const char* const kWriters[] = {
    "solve none.toml -o %o.h5",
    "eval none.toml --incident 45 --outgoing 0 -o %o.csv",
    "eval none.toml --incident 45 --outgoing 0 --report %o.json",
    "reference none.toml --incident 45 --outgoing 0 -o %o.csv",
    "render none.toml -o %o.exr",
    "render none.toml -o x.exr --report %o.json",
    "diff none.exr none.exr -o %o.exr",
    "sparkle none.toml -o %o.csv",
    "sparkle none.toml --report %o.json",
    "info none.toml -o %o.txt",
    "measure none.toml -o %o.csv",
    "atlas --film none.csv -o %o.svg",
    "panel none.toml -o %o.html",
    "export none.toml -o %o.bsdf",
    "fit none.toml --start none.toml -o %o.toml",
    "film --layer none.csv:80 -o %o.csv",
    "solve none.toml -o x.h5 --report %o.json",
    "reference none.toml --incident 45 --outgoing 0 --report %o.json",
    "diff none.exr none.exr --report %o.json",
    "diff none.exr none.exr -o %o.png",
    "measure none.toml --report %o.json",
    "atlas --film none.csv -o %o.png",
    "atlas --film none.csv -o %o.csv",
    "atlas --film none.csv --report %o.json",
    "panel none.toml -o x.html --report %o.json",
    "export none.toml -o %o.binary",
    "export none.toml -o x.bsdf --report %o.json",
    "fit none.toml --start none.toml --report %o.json",
};
/// And those that write into a folder.
const char* const kFolderWriters[] = {"measure none.toml --plots %o",
                                      "sparkle none.toml --pictures %o", "study flakes -o %o",
                                      "study mir-2022 -o %o", "study sparkle -o %o"};

std::string with_output(std::string arguments, const std::string& output) {
    return arguments.replace(arguments.find("%o"), 2, output);
}

TEST_F(Files, OutputsAreCheckedBeforeTheWork) {
    fs::create_directory(folder_ / "locked");
    ASSERT_EQ(::chmod((folder_ / "locked").c_str(), 0555), 0);
    write("file", "");
    for (const char* writer : kWriters) {
        for (const char* folder : {"nowhere", "locked", "file"}) {
            const Outcome outcome = nacre(with_output(writer, std::string(folder) + "/x"));
            EXPECT_EQ(outcome.status, 2) << writer << '\n' << outcome.err;
            EXPECT_THAT(outcome.err,
                        HasSubstr("nacre: cannot write '" + std::string(folder) + "/x"))
                << writer;
        }
    }
    for (const char* writer : kFolderWriters) {
        for (const char* folder : {"locked/x/y", "file", "file/x"}) {
            const Outcome outcome = nacre(with_output(writer, folder));
            EXPECT_EQ(outcome.status, 2) << writer << '\n' << outcome.err;
            EXPECT_THAT(outcome.err, HasSubstr(std::string("nacre: cannot write '") + folder))
                << writer;
        }
    }
    EXPECT_THAT(nacre(kEval + "-o nowhere/x").err, HasSubstr("there is no folder 'nowhere'"));
    EXPECT_THAT(nacre(kEval + "-o locked/x").err,
                HasSubstr("the folder 'locked' is write-protected"));
    EXPECT_TRUE(fs::is_empty(folder_ / "locked"));
}

TEST_F(Files, WhatCannotBeReplacedIsRefused) {
    fs::create_symlink("gone.csv", folder_ / "dangling.csv");
    write("locked.csv", "old");
    ASSERT_EQ(::chmod((folder_ / "locked.csv").c_str(), 0444), 0);
    fs::create_directory(folder_ / "folder.csv");
    for (const auto& [name, reason] : {std::pair{"dangling.csv", "a symbolic link that leads"},
                                       {"locked.csv", "is write-protected"},
                                       {"folder.csv", "the name of a file is expected"},
                                       {"none/", "the name of a file is expected"}}) {
        const Outcome outcome = nacre(kEval + "-o " + name);
        EXPECT_EQ(outcome.status, 2) << name;
        EXPECT_THAT(outcome.err,
                    AllOf(HasSubstr("cannot write '" + std::string(name)), HasSubstr(reason)));
    }
    EXPECT_TRUE(fs::is_symlink(folder_ / "dangling.csv"));
    EXPECT_FALSE(exists("gone.csv"));
    EXPECT_EQ(contents(folder_ / "locked.csv"), "old");
}

TEST_F(Files, NoOutputOfAnyCommandTakesAnOddPlace) {
    for (const char* writer : kWriters) {
        const std::string text = writer;
        const std::string extension =
            text.substr(text.find("%o") + 2, text.find(' ', text.find("%o")) - text.find("%o") - 2);
        const auto check = [&](const std::string& name, int status, const char* reason) {
            const Outcome outcome = nacre(with_output(writer, name));
            EXPECT_EQ(outcome.status, status) << writer << '\n' << outcome.err;
            EXPECT_THAT(outcome.err, HasSubstr(reason)) << writer;
            EXPECT_THAT(outcome.out, IsEmpty()) << writer;
        };
        fs::create_symlink("gone" + extension, folder_ / ("dangling" + extension));
        write("locked" + extension, "old");
        ASSERT_EQ(::chmod((folder_ / ("locked" + extension)).c_str(), 0444), 0);
        fs::create_directory(folder_ / ("folder" + extension));
        check("dangling", 2, "is a symbolic link that leads nowhere");
        check("locked", 2, "is write-protected");
        check("folder", 2, "the name of a file is expected");
        check("nowhere/x", 2, "there is no folder 'nowhere'");
        EXPECT_TRUE(fs::is_symlink(folder_ / ("dangling" + extension)));
        EXPECT_FALSE(exists("gone" + extension));
        EXPECT_EQ(contents(folder_ / ("locked" + extension)), "old");
        std::string nameless = text;
        nameless.replace(text.find("%o"), 2 + extension.size(), "''");
        const Outcome empty = nacre(nameless);
        EXPECT_EQ(empty.status, 1) << nameless << '\n' << empty.err;
        EXPECT_THAT(empty.err, HasSubstr("the name of a file is expected")) << nameless;
        for (const char* name : {"dangling", "locked", "folder"}) {
            fs::remove(folder_ / (name + extension));
        }
    }
    fs::create_symlink("gone", folder_ / "dangling");
    for (const char* writer : kFolderWriters) {
        const Outcome empty = nacre(with_output(writer, "''"));
        EXPECT_EQ(empty.status, 1) << writer << '\n' << empty.err;
        const Outcome dangling = nacre(with_output(writer, "dangling"));
        EXPECT_EQ(dangling.status, 2) << writer << '\n' << dangling.err;
        EXPECT_THAT(dangling.err, HasSubstr("is a symbolic link that leads nowhere")) << writer;
    }
    EXPECT_FALSE(exists("gone"));
}

TEST_F(Files, AFullDiskLeavesTheOldFile) {
    ASSERT_EQ(nacre(kRender + "-o a.exr").status, 0);
    for (const auto& [name, arguments] :
         {std::pair<std::string, std::string>{"k.exr", kRender + "-o k.exr"},
          {"d.exr", "diff a.exr a.exr -o d.exr"},
          {"d.png", "diff a.exr a.exr -o d.png"},
          {"s.h5", "solve gray.toml --wavelength 550 -o s.h5"},
          {"e.csv", kEval + "-o e.csv"},
          {"r.json", kEval + "--report r.json"},
          {"m.svg", kAtlas + "-o m.svg"},
          {"m.png", kAtlas + "-o m.png"}}) {
        write(name, "old");
        const Outcome outcome = nacre_without_space(arguments);
        EXPECT_EQ(outcome.status, 3) << arguments << '\n' << outcome.out;
        EXPECT_EQ(contents(folder_ / name), "old") << arguments;
        EXPECT_THAT(outcome.out,
                    AllOf(HasSubstr("nacre: cannot write '"), HasSubstr("': File too large")))
            << arguments;
        EXPECT_THAT(partial_files(), IsEmpty()) << arguments;
    }
    for (const char* extension : {"exr", "png"}) {
        const std::string name = std::string("full.") + extension;
        fs::create_symlink("/dev/full", folder_ / name);
        const Outcome outcome = nacre("diff a.exr a.exr -o " + name);
        EXPECT_EQ(outcome.status, 3) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("cannot write '" + name + "': No space left on device"));
    }
}

TEST_F(Files, PlotsNeedTheirLettersAndWhatDrawsThem) {
    write("fonts.conf",
          "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\">"
          "<fontconfig></fontconfig>");
    const Outcome fonts =
        shell("FONTCONFIG_FILE=\"$PWD/fonts.conf\" \"$NACRE\" " + kAtlas + "-o m.png");
    EXPECT_EQ(fonts.status, 3);
    EXPECT_THAT(fonts.err, HasSubstr("no font for its letters"));
    // The fewest with which the program starts: 4, or more where the test's parent left some open.
    const Outcome files = shell(
        "n=4; while ! (ulimit -n $n; \"$NACRE\" --version) >tried 2>&1; do n=$((n + 1)); done; "
        "ulimit -n $n; \"$NACRE\" " +
        kAtlas + "-o m.png");
    EXPECT_EQ(files.status, 3);
    EXPECT_THAT(files.err, HasSubstr("its letters need 8 open files"));
    const Outcome library = shell(
        "mkdir lib; echo none > lib/librsvg-2.so.2; LD_LIBRARY_PATH=\"$PWD/lib\" \"$NACRE\" " +
        kAtlas + "-o m.png");
    EXPECT_EQ(library.status, 3);
    EXPECT_THAT(library.err, AllOf(HasSubstr("a picture cannot be drawn: "),
                                   HasSubstr("/lib/librsvg-2.so.2: file too short")));
    EXPECT_FALSE(exists("m.png"));
    EXPECT_EQ(nacre(kAtlas + "-o m.png").status, 0);
    EXPECT_TRUE(exists("m.png"));
}

TEST_F(Files, TheSameInputGivesTheSameBytesAtAnyTime) {
    const std::string solve = "solve gray.toml --wavelength 500,600 --quiet ";
    const std::string bands = "solve gray.toml --wavelength 400:700:100 --quiet ";
    const std::vector<std::pair<std::string, std::string>> writers = {
        {solve + "-o ", ".h5"},    {bands + "--table svd -o ", "_svd.h5"},
        {kRender + "-o ", ".exr"}, {kAtlas + "-o ", "_atlas.png"},
        {kAtlas + "-o ", ".svg"},  {"panel gray.toml --quality low --quiet -o ", ".html"},
        {kEval + "-o ", ".csv"}};
    for (const char* name : {"one", "two"}) {
        for (const auto& [arguments, extension] : writers) {
            const Outcome outcome = nacre(arguments + name + extension);
            ASSERT_EQ(outcome.status, 0) << arguments << '\n' << outcome.err;
        }
        if (name == std::string_view("one")) shell("sleep 1.1");  // HDF5 counts seconds
    }
    for (const auto& [arguments, extension] : writers) {
        EXPECT_TRUE(contents(folder_ / ("one" + extension)) ==
                    contents(folder_ / ("two" + extension)))
            << arguments << "differs";
    }
    EXPECT_TRUE(contents(folder_ / "one.png") == contents(folder_ / "two.png"));
    EXPECT_FALSE(contents(folder_ / "one.png").empty());
}

}  // namespace

}  // namespace nacre::cli::testing
