#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/program_test_support.h"

// What commands read: once, and never what they write.

namespace nacre::cli::testing {

namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Inputs : public Program {
 protected:
    void SetUp() override {
        Program::SetUp();
        write("glass.csv", "wavelength_nm,n,k\n380,1.5,0\n780,1.51,0\n");
        write("glass.toml",
              "ior = \"glass.csv\"\n[[layer]]\nthickness_um = 15\n[[layer.pigment]]\n"
              "scattering_per_mm = 200\n");
    }
};

TEST_F(Inputs, AnOutputIsNoInput) {
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

TEST_F(Inputs, EachInputIsReadOnce) {
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
        {"measure glass.toml --set layer[0].thickness_um=20 -q -o x.csv",
         {"glass.toml", "glass.csv"}},
        {"measure glass.toml --set scattering_per_mm=150 -q -o x.csv", {"glass.toml", "glass.csv"}},
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

}  // namespace

}  // namespace nacre::cli::testing
