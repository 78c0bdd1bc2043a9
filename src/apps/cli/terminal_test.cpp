#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "apps/cli/program_test_support.h"

// What the program shows on a terminal of names that stand in files from elsewhere.

namespace nacre::cli::testing {
namespace {

/// The control characters in a text, lines and tabs apart.
std::size_t controls(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < 0x20 && c != '\n' && c != '\t' && c != '\r') || byte == 0x7f;
    }));
}

class Terminal : public Program {
 protected:
    void SetUp() override {
        Program::SetUp();
        master_ = ::posix_openpt(O_RDWR | O_NOCTTY);
        ASSERT_GE(master_, 0);
        ASSERT_EQ(::grantpt(master_), 0);
        ASSERT_EQ(::unlockpt(master_), 0);
        ASSERT_EQ(::fcntl(master_, F_SETFL, O_NONBLOCK), 0);
        slave_ = ::open(::ptsname(master_), O_RDWR | O_NOCTTY);  // or the text goes with its writer
    }
    void TearDown() override {
        ::close(slave_);
        ::close(master_);
    }

    /// What a command shows on a terminal, on which both of its streams end.
    std::string shown(const std::string& arguments) const {
        const std::string to = std::string(" > ") + ::ptsname(master_) + " 2>&1";
        std::string text;
        // A terminal holds few kilobytes: somebody has to read along.
        std::atomic<bool> ended = false;
        std::thread reader([&] {
            std::string piece(4096, '\0');
            for (bool last = false; !last;) {
                last = ended;
                pollfd waiting{master_, POLLIN, 0};
                while (::poll(&waiting, 1, 10) > 0) {
                    const ssize_t size = ::read(master_, piece.data(), piece.size());
                    if (size <= 0) break;
                    text.append(piece, 0, static_cast<std::size_t>(size));
                }
            }
        });
        EXPECT_GE(shell("\"$NACRE\" " + arguments + to).status, 0);
        ended = true;
        reader.join();
        return text;
    }

    int master_ = -1, slave_ = -1;
};

TEST_F(Terminal, GetsNoControlCharactersOfNames) {
    const std::string gray = contents(folder_ / "gray.toml");
    const std::string evil = "\\u001b]0;evil\\u0007\\u007f";  // TOML
    const std::string raw = "\x1b]0;evil\x07\x7f";
    std::string named = "name = \"" + evil + "\"\n" + gray;
    named +=
        "name = \"" + evil + "\"\n[fit]\n\"layer[0].flakes[0].orientation.alpha\" = [0.1, 0.3]\n";
    write(raw + ".toml", named);
    write("named.toml", named);
    write("key.toml", "\"" + evil + "\" = 1\n" + gray);
    write("value.toml", gray + "[substrate]\nreflectance = \"" + evil + "\"\n");
    write("material.toml", "ior = \"" + evil + ".csv\"\n" + gray.substr(gray.find('\n')));
    write("garbage.toml", raw + " = .5\n");
    write("bounds.toml", gray + "[fit]\n\"" + evil + "\" = [1, 2]\n");
    write("uncertain.toml", gray + "[uncertainty]\n\"layer[0].thickness_um\" = \"" + evil + "\"\n");
    write("set.toml", "name = \"s\"\n[[geometry]]\nname = \"" + evil +
                          "\"\nlamp_deg = 45\naspecular_deg = 25\n");
    write("sets.toml", contents(folder_ / "set.toml") + "[[geometry]]\nname = \"" + evil +
                           "\"\nlamp_deg = 45\naspecular_deg = 35\n");
    write("scene.toml", "name = \"" + evil + "\"\n[materials.\"" + evil +
                            "\"]\ntype = \"paint\"\n[[shapes]]\ntype = \"sphere\"\nmaterial = \"" +
                            evil + "\"\n[environment]\ntype = \"constant\"\n");
    write("lost.toml", "[materials.a]\ntype = \"paint\"\nrecipe = \"" + evil +
                           ".toml\"\n[[shapes]]\ntype = \"sphere\"\nmaterial = \"" + evil +
                           "\"\n[environment]\ntype = \"image\"\npath = \"" + evil + "\"\n");
    std::string node = triangle("bad.bin");
    node.insert(node.find("\"mesh\":0"), "\"name\":\"" + evil + "\",");
    node.insert(node.find("\"primitives\""), "\"name\":\"" + evil + "\",");
    write("node.gltf", node);
    write("bad.bin", std::string("\xff\xff\xff\x7f", 4) + corners().substr(4));
    write("extension.gltf",
          "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"" + evil + "\"]}");
    write("type.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + raw + " x\nend_header\n");
    const std::vector<std::pair<std::string, std::string>> meshes = {
        {"node.toml", "node.gltf"},
        {"extension.toml", "extension.gltf"},
        {"type.toml", "type.ply"},
        {"absent.toml", evil + ".obj"}};
    for (const auto& [scene, mesh] : meshes) {
        write(scene,
              "[materials.a]\ntype = \"diffuse\"\nreflectance = 0.5\n[[shapes]]\ntype = \"mesh\"\n"
              "path = \"" +
                  mesh + "\"\nmaterial = \"a\"\n[environment]\ntype = \"constant\"\n");
    }
    ASSERT_EQ(nacre("measure named.toml -o named.csv").status, 0);
    std::string table = contents(folder_ / "named.csv");
    write("cell.csv", table.replace(table.find("\n45as") + 1, 2, raw));
    write("head.csv", "geometry," + raw + "\n" + raw + ",1\n");
    write("head.json",
          "{\"format\":\"nacre-measurement\",\"format_version\":1,\"wavelengths_nm\":\"" + evil +
              "\"}");
    write("glass.csv", "wavelength_nm," + raw + "\n" + raw + ",1\n");
    write("glass.yml", "DATA:\n  - type: " + raw + "\n");
    write("garbage.exr", "\x76\x2f\x31\x01" + raw);
    write("garbage.hdr", "#?RADIANCE\nFORMAT=" + raw + "\n\n" + raw);
    const std::string draw = " --spp 1 --size 2x2 --model walk -o x.exr";
    std::vector<std::string> commands = {
        "render scene.toml" + draw,
        "render scene.toml --paint named.toml -q" + draw,
        "render scene.toml --brdf named.toml" + draw,
        "render lost.toml" + draw,
        "render node.toml" + draw,
        "render extension.toml" + draw,
        "render type.toml" + draw,
        "render absent.toml" + draw,
        "render '" + raw + "'" + draw,
        "info scene.toml",
        "info x.exr",
        "info x.png",
        "measure named.toml --geometry set.toml",
        "measure named.toml --geometry sets.toml",
        "measure named.toml --geometry set.toml --versus gray.toml",
        "measure cell.csv",
        "measure head.csv",
        "measure head.json",
        "measure named.csv --versus cell.csv",
        "measure named.csv --format json",
        "measure gray.toml --versus named.toml --weights '" + raw + "=1'",
        "fit named.csv --start named.toml --starts 1",
        "fit named.csv --start gray.toml --free '" + raw + "'",
        "film --layer '" + raw + ":80'",
        "film --ambient glass.csv",
        "film --ambient glass.yml",
        "atlas --film '" + raw + "'",
        "diff garbage.exr garbage.hdr",
        "diff garbage.hdr garbage.exr",
        "diff '" + raw + "' '" + raw + "'",
        "study '" + raw + "' -o s",
        "study flakes -o '" + raw + ".toml/x'",
        "eval gray.toml --incident '" + raw + "' --outgoing 0",
        "eval gray.toml --incident 0 --outgoing 0 --wavelength '" + raw + "'",
        "eval gray.toml --incident 0 --outgoing 0 --model '" + raw + "'",
        "eval gray.toml --incident 0 --outgoing 0 --at '" + raw + "' --footprint 1 --model nacre",
        "solve gray.toml -o x.h5 --threads '" + raw + "'",
        "solve gray.toml -o '" + raw + "/x'",
        "solve '" + raw + ".toml' --wavelength 550 -o '" + raw + ".h5'",
        "info '" + raw + ".h5'",
        "panel '" + raw + ".toml' --quality low -o '" + raw + ".html'",
        "measure gray.toml --illuminant '" + raw + "'",
        "measure gray.toml --geometry '" + raw + "'",
        "panel gray.toml --scene '" + raw + "' -o x.html",
        "'" + raw + "'",
        "info gray.toml '" + raw + "'",
        "export gray.toml -o '" + raw + "'",
        "render sphere --paint gray.toml --size '" + raw + "' -o x.exr"};
    for (const char* file :
         {"named.toml", "key.toml", "value.toml", "material.toml", "garbage.toml", "bounds.toml",
          "uncertain.toml", "nowhere.toml", "cell.csv", "head.csv"}) {
        const std::string name = std::string(file) == "nowhere.toml" ? raw + "nowhere.toml" : file;
        for (const std::string reader :
             {"info @", "solve @ --wavelength 550 -o x.h5",
              "eval @ --incident 45 --outgoing 0 --wavelength 550",
              "atlas --recipe @ --key alpha --values 0.1,0.2",
              "fit gray.toml --start @ --starts 1 --free alpha", "measure @ --geometry 45as15",
              "export @ --cells 4,4,4 -o x.binary",
              "reference @ --incident 45 --outgoing 0 --wavelength 550 --samples 2"}) {
            std::string command = reader;
            command.replace(command.find('@'), 1, "'" + name + "'");
            commands.push_back(command);
        }
    }
    std::size_t silent = 0;
    for (const std::string& command : commands) {
        const std::string text = shown(command);
        silent += text.empty();
        std::string clean = text;
        // The program's own: to clear the rest of a line of progress.
        for (std::size_t at; (at = clean.find("\x1b[K")) != std::string::npos;) clean.erase(at, 3);
        EXPECT_EQ(controls(clean), 0u) << command << '\n' << clean;
    }
    EXPECT_LT(silent, commands.size() / 4);
}

}  // namespace
}  // namespace nacre::cli::testing
