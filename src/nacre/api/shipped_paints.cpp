#include <fmt/format.h>

#include <map>
#include <system_error>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/io/measurement_file.h"
#include "nacre/nacre.h"

namespace nacre {

namespace fs = std::filesystem;

namespace {

std::map<std::string, fs::path> shipped_recipes() {
    std::map<std::string, fs::path> recipes;
    const fs::path folder = fs::absolute(data_directory()).lexically_normal().parent_path();
    std::error_code ec;
    for (fs::recursive_directory_iterator it(folder / "paints", ec), end; it != end;
         it.increment(ec)) {
        const fs::path& path = it->path();
        if (path.extension() == ".toml") recipes.emplace(path.stem().string(), path);
    }
    return recipes;
}

}  // namespace

std::vector<std::string> shipped_paints() {
    std::vector<std::string> names;
    for (const auto& [name, path] : shipped_recipes()) names.push_back(name);
    return names;
}

fs::path find_paint(const std::string& text) {
    std::error_code ec;
    const fs::path file = io::split_sample_name(text).file;
    if (is_stream(text) || fs::exists(fs::symlink_status(file, ec)) ||
        text.find('/') != std::string::npos) {
        return text;  // to be read, or to be complained of by who reads
    }
    std::map<std::string, fs::path> recipes;
    try {
        recipes = shipped_recipes();
    } catch (const InputError&) {  // the library stands alone, as in a Python wheel
    }
    if (const auto found = recipes.find(text); found != recipes.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, path] : recipes) names.push_back(name);
    const std::string meant = did_you_mean(fs::path(text).stem().string(), names);
    throw InputError(
        fmt::format("cannot read '{}': No such file or directory, and no shipped paint "
                    "is called so{}",
                    text, meant));
}

}  // namespace nacre
