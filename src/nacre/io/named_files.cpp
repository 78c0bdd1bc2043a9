#include "nacre/io/named_files.h"

#include <algorithm>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/table_reader.h"

namespace nacre::io {

namespace {

namespace fs = std::filesystem;

/// A scene names recipes, and they name materials.
constexpr int kMaxDepth = 2;

void collect_from(const fs::path& file, int depth, std::vector<fs::path>& found);

/// The files that texts below a node name.
void collect(const toml::node& node, const fs::path& folder, int depth,
             std::vector<fs::path>& found) {
    std::error_code ec;
    if (const auto* text = node.as_string()) {
        const fs::path file = folder / text->get();
        if (!fs::is_regular_file(file, ec) || std::ranges::find(found, file) != found.end()) return;
        found.push_back(file);
        if (depth < kMaxDepth) collect_from(file, depth + 1, found);
    } else if (const auto* table = node.as_table()) {
        for (const auto& [key, value] : *table) collect(value, folder, depth, found);
    } else if (const auto* array = node.as_array()) {
        for (const toml::node& value : *array) collect(value, folder, depth, found);
    }
}

void collect_from(const fs::path& file, int depth, std::vector<fs::path>& found) {
    try {
        const fs::path folder = file.parent_path();
        const TomlDocument document(read_file(file, kMaxTextBytes), file.string(), folder);
        collect(document.root(), folder, depth, found);
    } catch (const InputError&) {  // no TOML: whoever reads it as a recipe says what is wrong
    }
}

}  // namespace

std::vector<fs::path> files_named_by(const fs::path& file) {
    std::vector<fs::path> found;
    collect_from(file, 1, found);
    return found;
}

}  // namespace nacre::io
