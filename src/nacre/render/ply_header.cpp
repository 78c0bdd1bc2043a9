#include "nacre/render/ply_header.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>

namespace nacre::render {
namespace {

/// Bytes of a scalar in a binary file; empty for an unknown type.
std::optional<int> scalar_size(const std::string& type) {
    static const std::map<std::string, int> kSizes{
        {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
        {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = kSizes.find(type);
    if (found == kSizes.end()) return std::nullopt;
    return found->second;
}

}  // namespace

std::optional<std::string> ply_fault(const std::filesystem::path& path) {
    constexpr int kLongestHeader = 1000;  // lines
    std::ifstream in(path, std::ios::binary);
    std::string line;
    bool binary = false, ended = false;
    double count = 0, element_bytes = 0, least_bytes = 0;  // doubles: counts may overflow integers
    for (int number = 1; number <= kLongestHeader && !ended && std::getline(in, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        std::istringstream words(line);
        std::string key, a, b;
        words >> key;
        if (number == 1 && key != "ply") return "line 1: does not begin with 'ply'";
        if (key == "format") {
            words >> a;
            binary = a != "ascii";
        } else if (key == "element") {
            least_bytes += count * element_bytes;
            element_bytes = 0;
            if (!(words >> a >> count) || count < 0) {
                return fmt::format("line {}: '{}' is not 'element NAME COUNT'", number, line);
            }
        } else if (key == "property") {
            words >> a;
            if (a == "list") words >> a >> b;  // at least its length is there
            const auto size = scalar_size(a);
            if (!size) return fmt::format("line {}: unknown type '{}'", number, a);
            // As text: one digit and one space.
            element_bytes += binary ? *size : 2;
        }
        ended = key == "end_header";
    }
    if (!ended) return "has no end_header";
    least_bytes += count * element_bytes;
    const auto body = static_cast<double>(in.tellg());
    std::error_code status;
    const auto size = static_cast<double>(std::filesystem::file_size(path, status));
    // The last number of a text file may do without its space.
    if (least_bytes > size - body + 1) {
        return fmt::format(
            "is cut short: its header asks for at least {:.0f} bytes of data, there "
            "are {:.0f}",
            least_bytes, size - body);
    }
    return std::nullopt;
}

}  // namespace nacre::render
