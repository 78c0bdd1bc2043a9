#include "apps/cli/program_test_support.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace nacre::cli::testing {

std::string contents(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

std::string triangle(const std::string& buffer) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":)"
           R"(0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
           buffer + "\"}]}";
}

std::string corners() {
    std::string bytes(36, '\0');
    for (const std::size_t at : {12, 28}) bytes.replace(at, 4, std::string("\0\0\x80\x3f", 4));
    return bytes;
}

void Program::SetUp() {
    write("gray.toml", R"(ior = 1.5
[[layer]]
thickness_um = 15
[[layer.flakes]]
area_density_per_um = 0.1
orientation = { distribution = "beckmann", alpha = 0.2 }
reflectance = 0.6
)");
}

Outcome Program::nacre(const std::string& arguments, const std::string& before) const {
    const std::string command = "cd '" + folder_.path().string() + "' && " + before +
                                " '" NACRE_PROGRAM "' " + arguments + " > .out 2> .err";
    const int code = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(code)) << arguments << " was ended by a signal";
    return {WEXITSTATUS(code), contents(folder_ / ".out"), contents(folder_ / ".err")};
}

Outcome Program::shell(const std::string& script) const {
    write(".script", script);
    const std::string command = "cd '" + (folder_ / "").string() +
                                "' && NACRE='" NACRE_PROGRAM "' sh .script > .out 2> .err";
    const int code = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(code)) << script << " was ended by a signal";
    return {WEXITSTATUS(code), contents(folder_ / ".out"), contents(folder_ / ".err")};
}

void Program::write(const std::string& name, const std::string& text) const {
    folder_.write(name, text);
}

bool Program::exists(const std::string& name) const {
    return std::filesystem::exists(folder_ / name);
}

std::string cell(const std::string& csv, int row, int column) {
    std::istringstream lines(csv);
    std::string line, value;
    for (int i = 0; i <= row; ++i) std::getline(lines, line);
    std::istringstream cells(line);
    for (int i = 0; i <= column; ++i) std::getline(cells, value, ',');
    return value;
}

double number(const std::string& csv, int row, int column) {
    return std::atof(cell(csv, row, column).c_str());
}

}  // namespace nacre::cli::testing
