#include "nacre/io/named_files.h"

#include <algorithm>
#include <array>
#include <climits>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"

namespace nacre::io {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The most JSON of a glTF that is looked through, as render/mesh_file.cpp reads it.
constexpr std::size_t kMaxGltfBytes = std::size_t{1} << 28;

/// Reads a line, as an empty one if it is longer than a path with a few options before it.
/// @return whether there was one
bool next_line(std::istream& in, std::string& line) {
    std::array<char, 2 * PATH_MAX> text;
    in.getline(text.data(), text.size());
    const bool cut = in.fail() && in.gcount() + 1 == static_cast<std::streamsize>(text.size());
    if (cut) {
        in.clear();
        in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    line = cut ? "" : text.data();
    return cut || !in.fail();
}

/// The paths of files in the texts of a mesh.
class NamedFiles {
 public:
    void add_from(const fs::path& file, const References& references) {
        const std::string extension = extension_of(file);
        try {
            if (extension == ".gltf" || extension == ".glb") add_from_gltf(file);
            if (extension == ".obj") add_from_lines(file, references);
        } catch (const InputError&) {  // whoever reads it says what is wrong
        }
    }

    std::vector<fs::path> found;

 private:
    static std::string extension_of(const fs::path& file) {
        return lowercase(file.extension().string());
    }

    /// The file of this name, if there is one and it may be named.
    /// @return whether it is new
    bool add(const std::string& name, const References& references) {
        std::error_code ec;
        if (name.size() > PATH_MAX) return false;
        const std::optional<fs::path> file = [&]() -> std::optional<fs::path> {
            try {
                return references.resolve(name);
            } catch (const InputError&) {
                return std::nullopt;
            }
        }();
        if (!file || !fs::is_regular_file(*file, ec)) return false;
        if (std::ranges::find(found, *file) != found.end()) return false;
        found.push_back(*file);
        return true;
    }

    /// Of an OBJ, whose first lines name its materials, and of these, which name pictures.
    void add_from_lines(const fs::path& file, const References& references) {
        constexpr int kMaxLines = 1000;
        const bool is_obj = extension_of(file) == ".obj";
        std::ifstream in(file);
        std::string line;
        for (int i = 0; i < kMaxLines && next_line(in, line); ++i) {
            // KEY [OPTIONS] NAME; names may have spaces.
            const std::string_view text = trimmed(line);
            if (text.starts_with("newmtl ") || (is_obj && !text.starts_with("mtllib "))) continue;
            for (std::size_t at = text.find(' '); at != std::string_view::npos;
                 at = text.find(' ', at + 1)) {
                if (!add(std::string(trimmed(text.substr(at))), references) || !is_obj) continue;
                const fs::path materials = found.back();
                if (extension_of(materials) == ".mtl") {
                    add_from_lines(materials, references.beside(materials));
                }
            }
        }
    }

    void add_from_gltf(const fs::path& file);
};

/// The text of a .gltf, or the first chunk of a .glb.                       [khronos-gltf-2021]
std::string gltf_text(const fs::path& file) {
    constexpr std::size_t kHeadBytes = 20;  // of the container and of its first chunk
    std::ifstream in(file, std::ios::binary);
    std::array<unsigned char, kHeadBytes> head{};
    in.read(reinterpret_cast<char*>(head.data()), kHeadBytes);
    if (!std::equal(head.begin(), head.begin() + 4, "glTF")) return read_file(file, kMaxGltfBytes);
    const std::size_t size =
        head[12] | head[13] << 8 | head[14] << 16 | std::size_t{head[15]} << 24;
    std::error_code ec;
    std::string text(std::min({size, kMaxGltfBytes, std::size_t{fs::file_size(file, ec)}}), '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
}

/// "%20" as a space: names in a glTF are URIs.
std::string percent_decoded(const std::string& text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto digit = [&](std::size_t at) {
            return std::string_view("0123456789abcdef").find(lowercase(text.substr(at, 1)));
        };
        if (text[i] == '%' && i + 2 < text.size() && digit(i + 1) < 16 && digit(i + 2) < 16) {
            decoded += static_cast<char>(16 * digit(i + 1) + digit(i + 2));
            i += 2;
        } else {
            decoded += text[i];
        }
    }
    return decoded;
}

void NamedFiles::add_from_gltf(const fs::path& file) {
    /// Calls back for each text in a JSON, without a tree, which might be deep.
    struct Texts : json::json_sax_t {
        explicit Texts(std::function<void(const std::string&)> found) : found(std::move(found)) {}
        bool null() override { return true; }
        bool boolean(bool) override { return true; }
        bool number_integer(number_integer_t) override { return true; }
        bool number_unsigned(number_unsigned_t) override { return true; }
        bool number_float(number_float_t, const string_t&) override { return true; }
        bool string(string_t& text) override {
            found(text);
            return true;
        }
        bool binary(binary_t&) override { return true; }
        bool start_object(std::size_t) override { return true; }
        bool key(string_t&) override { return true; }
        bool end_object() override { return true; }
        bool start_array(std::size_t) override { return true; }
        bool end_array() override { return true; }
        bool parse_error(std::size_t, const std::string&, const json::exception&) override {
            return false;
        }
        std::function<void(const std::string&)> found;
    };
    // As render/mesh_file.cpp: from its folder and below.
    const References beside = References::within(file.parent_path());
    Texts texts([&](const std::string& text) {
        add(text, beside);
        if (text.find('%') != std::string::npos) add(percent_decoded(text), beside);
    });
    json::sax_parse(gltf_text(file), &texts);
}

}  // namespace

std::vector<fs::path> files_named_by(const fs::path& file, const References& references) {
    NamedFiles files;
    files.add_from(file, references);
    return std::move(files.found);
}

}  // namespace nacre::io
