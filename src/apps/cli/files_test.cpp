#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <map>
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
using ::testing::Not;

const std::string kEval = "eval gray.toml --incident 45 --outgoing 0 --wavelength 550 ";
const std::string kRender = "render sphere --paint gray.toml --spp 1 --size 2x2 --quiet ";
const std::string kAtlas = "atlas --film mica --thickness 100,200 --quiet ";

class Files : public Program {
 protected:
    void SetUp() override {
        Program::SetUp();
        write("glass.csv", "wavelength_nm,n,k\n380,1.5,0\n780,1.51,0\n");
        write("glass.toml",
              "ior = \"glass.csv\"\n[[layer]]\nthickness_um = 15\n[[layer.pigment]]\n"
              "scattering_per_mm = 200\n");
    }

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

TEST_F(Files, AnOutputIsNoInput) {
    write("set.toml", "name = \"set\"\n");
    write("a.png", "any");
    // Read before the recipe, which names glass.csv.
    ASSERT_EQ(nacre(kRender + "-o b.exr").status, 0);
    const std::string environment = contents(folder_ / "b.exr");
    write("any.bsdf", "any");
    write("any.html", "any");
    write("ball.obj", "any");
    fs::create_directory(folder_ / "below");
    write("below/scene.toml",
          "[[shapes]]\ntype = \"mesh\"\npath = \"../mesh.exr\"\nmaterial = \"paint\"\n"
          "[materials.paint]\ntype = \"paint\"\nrecipe = \"../glass.toml\"\n"
          "[environment]\ntype = \"image\"\npath = \"../b.exr\"\n");
    write("mesh.exr", "any");
    write("ground.csv", "wavelength_nm,reflectance\n400,0.2\n700,0.4\n");
    write("below/beside.csv", "any");
    write("ball.mtl", "any");
    write("ball.obj", "mtllib ball.mtl\n");
    write("corners.bin", corners());
    write("triangle.gltf", triangle("corners.bin"));
    fs::create_symlink("ball.obj", folder_ / "ball.toml");
    fs::create_symlink("gray.toml", folder_ / "link.csv");
    fs::create_hard_link(folder_ / "gray.toml", folder_ / "same.csv");
    for (const std::string mesh : {"triangle.gltf", "ball.obj"}) {
        write("below/" + mesh + ".toml", "[[shapes]]\ntype = \"mesh\"\npath = \"../" + mesh +
                                             "\"\nmaterial = \"paint\"\n[materials.paint]\n"
                                             "type = \"diffuse\"\nreflectance = 0.5\n"
                                             "[environment]\ntype = \"constant\"\n");
    }
    const std::string walk = " --incident 45 --outgoing 0 --samples 2 ";
    for (const std::string arguments :
         {"solve gray.toml -o gray.toml",
          "solve gray.toml -o ./gray.toml",
          "solve gray.toml -o link.csv",
          "solve gray.toml -o same.csv",
          "solve link.csv -o gray.toml",
          "solve gray.toml -o x.h5 --report gray.toml",
          "solve glass.toml -o glass.csv",
          "info gray.toml -o gray.toml",
          "eval gray.toml --incident 45 --outgoing 0 -o gray.toml",
          "eval gray.toml --incident 45 --outgoing 0 --report gray.toml",
          "measure gray.toml -o gray.toml",
          "measure gray.toml --versus glass.toml -o glass.toml",
          "measure gray.toml --versus glass.toml -o glass.csv",
          "measure gray.toml --geometry set.toml -o set.toml",
          "measure gray.toml --set substrate.reflectance=ground.csv -o ground.csv",
          "measure gray.toml --set 'substrate.reflectance=\"ground.csv\"' -o ground.csv",
          "measure gray.toml --set 'clearcoat={ior=\"glass.csv\"}' --report glass.csv",
          "measure below/scene.toml --set substrate.reflectance=beside.csv -o below/beside.csv",
          "solve gray.toml --set substrate.reflectance=ground.csv -o x.h5 --report ground.csv",
          "info gray.toml --set substrate.reflectance=ground.csv -o ground.csv",
          "scene ball.obj -o ball.obj",
          "scene ball.obj -o ball.toml",
          "scene ball.obj -o ball.mtl",
          "scene triangle.gltf -o corners.bin",
          "diff a.png b.exr -o a.png",
          "diff a.png b.exr -o b.exr",
          "fit gray.toml --start glass.toml -o glass.toml",
          "fit gray.toml --start glass.toml -o gray.toml",
          "export any.bsdf -o any.bsdf",
          "panel gray.toml --versus any.html -o any.html",
          "panel gray.toml --versus glass.toml -o x.html --report glass.csv",
          "fit gray.toml --start glass.toml --free layer[0].thickness_um -o glass.csv",
          "fit glass.toml --start gray.toml --free layer[0].thickness_um -o glass.csv",
          "export glass.toml -o x.bsdf --report glass.csv",
          "reference glass.toml --incident 45 --outgoing 0 --report glass.csv",
          "atlas --recipe glass.toml --key layer[0].thickness_um --values 1,2 -o glass.csv",
          "sparkle gray.toml --versus glass.toml -o glass.csv",
          "info glass.toml -o glass.csv",
          "info below/scene.toml -o glass.csv",
          "sparkle gray.toml -o gray.toml",
          "film --layer glass.csv:80 -o glass.csv",
          "film --ambient glass.csv -o glass.csv",
          "atlas --film glass.csv -o glass.csv",
          "atlas --film mica --core glass.csv:500:60 -o "
          "glass.csv",
          "render below/scene.toml -o b.exr",
          "render below/scene.toml -o mesh.exr",
          "render below/scene.toml -o x.exr --report glass.toml",
          "render below/scene.toml -o x.exr --report glass.csv",
          "render below/triangle.gltf.toml -o x.exr --report corners.bin",
          "render below/ball.obj.toml -o x.exr --report ball.mtl",
          "render sphere --paint gray.toml -o x.exr --report gray.toml"}) {
        const std::string recipe = contents(folder_ / "gray.toml");
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments << '\n' << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("would replace an input, '")) << arguments;
        EXPECT_THAT(outcome.out, IsEmpty());
        EXPECT_EQ(contents(folder_ / "gray.toml"), recipe) << arguments;
    }
    const Outcome reference = nacre("reference gray.toml" + walk + "-o gray.toml");
    EXPECT_EQ(reference.status, 1) << reference.err;
    fs::create_directory(folder_ / "plots");
    write("plots/travel.svg", "any");
    write("plots/45s.exr", "any");
    for (const char* arguments : {"measure gray.toml --versus plots/travel.svg --plots plots",
                                  "sparkle plots/45s.exr --pictures plots"}) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("would replace an input, 'plots/"));
    }
    const Outcome constants = shell("\"$NACRE\" film --layer -:80 -o glass.csv < glass.csv");
    EXPECT_EQ(constants.status, 1) << constants.err;
    const Outcome piped = shell("\"$NACRE\" info /dev/stdin -o gray.toml < gray.toml");
    EXPECT_EQ(piped.status, 1) << piped.err;
    for (const char* name : {"a.png", "any.bsdf", "any.html", "mesh.exr"}) {
        EXPECT_EQ(contents(folder_ / name), "any");
    }
    EXPECT_TRUE(contents(folder_ / "b.exr") == environment);
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.csv"));
    EXPECT_THAT(nacre("solve glass.toml -o glass.csv").err,
                HasSubstr("--output = glass.csv: would replace an input, 'glass.csv', which "
                          "'glass.toml' names"));
    // Devices and pipes may be both.
    EXPECT_EQ(shell("\"$NACRE\" info gray.toml -o /dev/stdout | cat").status, 0);
}

/// How often files of a folder are opened, by their names.
class Opened {
 public:
    explicit Opened(const fs::path& folder) : queue_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
        // Closings too: events that repeat the one before are dropped.
        watches_ = queue_ >= 0 &&
                   ::inotify_add_watch(queue_, folder.c_str(), IN_OPEN | IN_CLOSE_NOWRITE) >= 0;
    }
    ~Opened() { ::close(queue_); }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    bool watches() const { return watches_; }
    /// Since the last call.
    std::map<std::string, int> counts() const {
        std::map<std::string, int> counts;
        alignas(inotify_event) char bytes[1 << 16];
        for (ssize_t size = 0; (size = ::read(queue_, bytes, sizeof bytes)) > 0;) {
            for (ssize_t at = 0; at < size;) {
                const auto* event = reinterpret_cast<const inotify_event*>(bytes + at);
                if (event->len > 0 && (event->mask & IN_OPEN) != 0) ++counts[event->name];
                at += static_cast<ssize_t>(sizeof *event + event->len);
            }
        }
        return counts;
    }

 private:
    int queue_;
    bool watches_ = false;
};

TEST_F(Files, EachInputIsReadOnce) {
    const Opened opened(folder_);
    if (!opened.watches()) GTEST_SKIP() << "this system does not tell which files are opened";
    write("scene.toml",
          "[[shapes]]\ntype = \"sphere\"\nmaterial = \"paint\"\n[materials.paint]\n"
          "type = \"paint\"\nrecipe = \"glass.toml\"\n[environment]\ntype = \"constant\"\n");
    ASSERT_EQ(nacre("measure gray.toml -q -o colours.csv").status, 0);
    ASSERT_EQ(nacre("solve gray.toml -q -o gray.h5").status, 0);
    ASSERT_EQ(nacre("solve gray.toml --table raw -q -o table.h5").status, 0);
    ASSERT_EQ(nacre("export gray.toml -q -o gray.bsdf").status, 0);
    const std::string quick = " --spp 1 --size 2x2 -q ", angles = " --incident 45 --outgoing 0 ";
    const std::vector<std::pair<std::string, std::vector<std::string>>> commands = {
        {"solve glass.toml -q -o x.h5", {"glass.toml", "glass.csv"}},
        {"eval glass.toml" + angles + "-q -o x.csv", {"glass.toml", "glass.csv"}},
        {"reference glass.toml" + angles + "--samples 2 -q -o x.csv", {"glass.toml", "glass.csv"}},
        {"export glass.toml -q -o x.three.js", {"glass.toml", "glass.csv"}},
        {"measure glass.toml --versus gray.toml -q -o x.csv",
         {"glass.toml", "glass.csv", "gray.toml"}},
        {"measure gray.h5 -q -o x.csv", {"gray.h5"}},
        {"measure table.h5 -q -o x.csv", {"table.h5"}},
        {"measure gray.bsdf -q -o x.csv", {"gray.bsdf"}},
        {"measure colours.csv -q -o x.csv", {"colours.csv"}},
        {"panel gray.toml --versus glass.toml --quality low -q -o x.html",
         {"gray.toml", "glass.toml", "glass.csv"}},
        {"fit colours.csv --start gray.toml --free layer[0].thickness_um --starts 1 -q --report "
         "x.json",
         {"colours.csv", "gray.toml"}},
        {"atlas --recipe glass.toml --key layer[0].thickness_um --values 10,20 -q -o x.csv",
         {"glass.toml", "glass.csv"}},
        {"film --layer glass.csv:80 -o x.csv", {"glass.csv"}},
        {"info glass.toml -o x.txt", {"glass.toml", "glass.csv"}},
        {"info gray.h5 -o x.txt", {"gray.h5"}},
        {"info scene.toml -o x.txt", {"scene.toml", "glass.toml", "glass.csv"}},
        {"render scene.toml -o x.exr" + quick, {"scene.toml", "glass.toml", "glass.csv"}},
        {"render scene.toml -o y.exr --turntable shape --frames 1:3" + quick,
         {"scene.toml", "glass.toml", "glass.csv"}},
        {"render sphere --paint glass.toml -o x.exr" + quick, {"glass.toml", "glass.csv"}}};
    for (const auto& [arguments, inputs] : commands) {
        opened.counts();
        const Outcome outcome = nacre(arguments);
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 4) << arguments << '\n' << outcome.err;
        const std::map<std::string, int> counts = opened.counts();
        for (const std::string& input : inputs) {
            const auto found = counts.find(input);
            EXPECT_EQ(found == counts.end() ? 0 : found->second, 1) << arguments << ": " << input;
        }
    }
}

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

TEST_F(Files, MessagesThatNobodyCanReadEndNothing) {
    for (const char* sink : {"2>&-", "2>/dev/full"}) {
        const auto status = [&](const std::string& arguments) {
            return shell("\"$NACRE\" " + arguments + " " + sink).status;
        };
        EXPECT_EQ(status("info none.toml"), 2) << sink;
        EXPECT_EQ(status("nonsense"), 1) << sink;
        EXPECT_EQ(status("solve gray.toml --wavelength 550 -o s.h5"), 0) << sink;
        EXPECT_EQ(nacre("info s.h5").status, 0) << sink;  // no message went into it
        ASSERT_EQ(nacre(kRender + "-o a.exr").status, 0);
        EXPECT_EQ(status("diff a.exr a.exr --min-psnr 1 --max-relative -1"), 4) << sink;
    }
    EXPECT_EQ(shell("\"$NACRE\" solve gray.toml -o s.h5 --wavelength 550 <&- >&- 2>&-").status, 0);
    EXPECT_EQ(nacre("info s.h5").status, 0);
}

TEST_F(Files, DataThatAreLostAreAnError) {
    ASSERT_EQ(nacre(kRender + "-o a.exr").status, 0);
    for (const std::string& arguments :
         {kEval, std::string("info gray.toml"), std::string("film"), kAtlas,
          std::string("diff a.exr a.exr"), std::string("--help"), std::string("--version"),
          std::string("eval --help")}) {
        const Outcome full = shell("\"$NACRE\" " + arguments + " > /dev/full");
        EXPECT_EQ(full.status, 3) << arguments;
        EXPECT_EQ(full.err, "nacre: cannot write to standard output: No space left on device\n");
        const Outcome closed = shell("\"$NACRE\" " + arguments + " >&-");
        EXPECT_EQ(closed.status, 3) << arguments;
        EXPECT_EQ(closed.err, "nacre: cannot write to standard output: Bad file descriptor\n");
    }
}

TEST_F(Files, AReaderThatHasGoneEndsTheProgramSilentlyOnceItsFilesAreWritten) {
    // A pipe, open for writing as 4, whose reader has gone.
    const std::string pipe = "mkfifo pipe; (exec 3< pipe) & exec 4> pipe; wait; ";
    const Outcome data =
        shell(pipe + "\"$NACRE\" " + kEval + "--report r.json >&4; echo $?; rm pipe");
    EXPECT_EQ(data.out, "141\n");  // 128 + SIGPIPE, as of any program
    EXPECT_THAT(data.err, Not(HasSubstr("nacre:")));
    EXPECT_TRUE(exists("r.json"));
    const Outcome ignored =
        shell(pipe + "trap '' PIPE; \"$NACRE\" " + kEval + ">&4; echo $?; rm pipe");
    EXPECT_EQ(ignored.out, "3\n");
    EXPECT_THAT(ignored.err, HasSubstr("cannot write to standard output"));
    // Of messages, the program goes on.
    const Outcome messages =
        shell(pipe + "\"$NACRE\" solve gray.toml --wavelength 550 -o s.h5 2>&4; echo $?; rm pipe");
    EXPECT_EQ(messages.out, "0\n");
    EXPECT_EQ(nacre("info s.h5").status, 0);
}

TEST_F(Files, AnOpenFileIsAppendedTo) {
    const Outcome outcome =
        shell("echo old > log; \"$NACRE\" " + kEval + "-o /dev/stdout >> log; echo $?");
    EXPECT_EQ(outcome.out, "0\n");
    EXPECT_THAT(contents(folder_ / "log"), AllOf(HasSubstr("old\ntheta_i"), HasSubstr("\n45,")));
}

TEST_F(Files, OneOutputGoesToTheStandardOutput) {
    write("a.png", "any");
    const std::string fit = "fit gray.toml --start gray.toml --free alpha --starts 1 -q ";
    for (const std::string& arguments :
         {fit + "-o -", fit + "-o /dev/stdout", fit + "-o fitted.toml --report /dev/fd/1",
          std::string("measure gray.toml -q --report -"),
          std::string("measure gray.toml -q -o - --report /dev/stdout"),
          std::string("measure gray.toml -q --uncertainty alpha=1% --contributions -"),
          std::string("diff a.png a.png --report -")}) {
        for (const char* into : {"> out", ">> out", "| cat > out"}) {
            const Outcome outcome =
                shell("rm -f out; { \"$NACRE\" " + arguments + "; echo $? >&2; } " + into);
            EXPECT_THAT(outcome.err, HasSubstr("\n1\n")) << arguments << into;
            EXPECT_THAT(outcome.err,
                        ::testing::AnyOf(HasSubstr("another output of the same command"),
                                         HasSubstr("is the same file as")))
                << arguments;
            EXPECT_THAT(contents(folder_ / "out"), IsEmpty()) << arguments << into;
        }
    }
    // The file to which it is redirected.
    EXPECT_EQ(shell("\"$NACRE\" " + fit + "-o out.toml > out.toml").status, 1);
    EXPECT_EQ(shell("\"$NACRE\" measure gray.toml -q -o /dev/null > /dev/null").status, 0);
}

TEST_F(Files, WhatIsInTheStandardOutputStays) {
    const std::string table = nacre(kEval).out;
    for (const char* into : {"> out", ">> out", "1<> out"}) {
        write("out", "");
        const Outcome outcome =
            shell("{ echo first; \"$NACRE\" " + kEval + "-o /dev/stdout; \"$NACRE\" " + kEval +
                  "; echo last; } " + into);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(contents(folder_ / "out"), "first\n" + table + table + "last\n") << into;
    }
}

}  // namespace

}  // namespace nacre::cli::testing
