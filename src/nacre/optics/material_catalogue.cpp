#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <map>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/suggest.h"
#include "nacre/optics/material_file.h"
#include "nacre/optics/number_text.h"
#include "nacre/optics/shipped_materials.h"

namespace nacre::optics {

namespace {

const std::map<std::string, Material>& catalogue() {
    static const std::map<std::string, Material> materials = [] {
        std::map<std::string, Material> all;
        for (const ShippedMaterial& shipped : shipped_materials()) {
            const std::string name(shipped.name);
            all.emplace(name, parse_material_csv(shipped.csv, name));
        }
        return all;
    }();
    return materials;
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return result;
}

/// "n", "n+ki" or "n-ki".
std::optional<ComplexIndex> parse_index(std::string_view text) {
    const auto n = take_number(text);
    if (!n) return std::nullopt;
    if (text.empty()) return ComplexIndex(*n, 0);
    if (text.front() != '+' && text.front() != '-') return std::nullopt;
    const auto k = take_number(text);
    if (!k || text != "i") return std::nullopt;
    return ComplexIndex(*n, *k);
}

bool is_material_file(const std::filesystem::path& path) {
    const std::string extension = lower_case(path.extension().string());
    return extension == ".csv" || extension == ".yml" || extension == ".yaml";
}

}  // namespace

Material read_material_file(const std::filesystem::path& path) {
    const std::string name = path.string();
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        throw InputError(fmt::format("{}: there is no such file", name));
    }
    const auto size = std::filesystem::file_size(path, error);
    if (error || size > kLargestMaterialFile) {
        throw InputError(fmt::format("{}: larger than {} bytes, the most that a material may have",
                                     name, kLargestMaterialFile));
    }
    std::ifstream file(path, std::ios::binary);
    std::string text(size, '\0');
    if (!file.read(text.data(), static_cast<std::streamsize>(size))) {
        throw InputError(fmt::format("{}: cannot be read", name));
    }
    return lower_case(path.extension().string()) == ".csv" ? parse_material_csv(text, name)
                                                           : parse_material_yaml(text, name);
}

Material find_material(const std::string& text, const std::filesystem::path& base_directory) {
    const std::string_view wanted = trimmed(text);
    if (const auto index = parse_index(wanted)) {
        try {
            return Material(*index);
        } catch (const DomainError& error) {
            throw InputError(error.what());
        }
    }
    if (const auto found = catalogue().find(std::string(wanted)); found != catalogue().end()) {
        return found->second;
    }
    if (const std::filesystem::path path(wanted); is_material_file(path)) {
        return read_material_file(base_directory / path);
    }
    throw InputError(fmt::format(
        "material \"{}\" is not an index (as 1.5 or 3.18+3.33i), not the path of a .csv, .yml or "
        ".yaml file, and not a shipped material{}; those are: {}",
        excerpt(wanted), did_you_mean(excerpt(wanted), material_names()),
        fmt::join(material_names(), ", ")));
}

std::vector<std::string> material_names() {
    std::vector<std::string> names;
    for (const auto& [name, material] : catalogue()) names.push_back(name);
    return names;
}

}  // namespace nacre::optics
