#include "nacre/render/scene_file.h"

#include <fmt/format.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/described_toml.h"
#include "nacre/io/file_kind.h"
#include "nacre/io/image.h"
#include "nacre/render/scene_description.h"

namespace nacre::render {

namespace {

/// Colours that a display does not have are negative in its primaries: so little light that it may
/// be left out, unlike that of a difference of pictures.
constexpr double kMaxNegativeLight = 0.01;

/// 16384 x 8192 pixels: what an environment, or a material's picture, may have.
constexpr std::size_t kMaxPictureValues = std::size_t{3} << 27;

/// The picture that a table names by `path` is read along with it.
/// @return the picture's file
std::string read_picture(const io::TableReader& table, int& width, int& height,
                         std::vector<float>& rgb) {
    try {
        const std::filesystem::path path =
            table.document().references().resolve(table.text("path", paint::kMaxPathLength));
        const io::Image image = io::read_image(path, kMaxPictureValues);
        width = image.width;
        height = image.height;
        rgb = interleaved_rgb(image, path.string());
        return path.string();
    } catch (const Error& error) {
        table.fail("path", error.what());
    }
}

void read_pictures(const io::TableReader& table, SceneDescription& scene) {
    for (auto& [name, material] : scene.materials) {
        if (auto* picture = std::get_if<DiffusePictureMaterial>(&material)) {
            read_picture(table.table("materials", {}).table(name, {}), picture->width,
                         picture->height, picture->rgb);
        }
    }
    if (!scene.environment) return;
    if (auto* picture = std::get_if<ImageEnvironment>(&*scene.environment)) {
        const std::string file = read_picture(table.table("environment", {}), picture->width,
                                              picture->height, picture->rgb);
        const std::string note = without_negative_light(picture->rgb, file);
        if (!note.empty()) scene.notes.push_back(note);
    }
}

/// Notes where files are named that are read later.
void note_places(const io::TableReader& table, SceneDescription& scene) {
    const auto place = [&](const io::TableReader& reader, const char* key) {
        const std::string path = reader.path_of(key);
        return NamedAt{table.document().location(path) + path + ": "};
    };
    for (auto& [name, material] : scene.materials) {
        if (auto* paint = std::get_if<PaintMaterial>(&material)) {
            paint->named_at = place(table.table("materials", {}).table(name, {}), "recipe");
        }
    }
    if (scene.shapes.empty()) return;
    const std::vector<io::TableReader> shapes = table.tables("shapes", kMaxShapes, {});
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        if (auto* mesh = std::get_if<MeshFile>(&scene.shapes[i].geometry)) {
            mesh->named_at = place(shapes[i], "path");
        }
    }
}

}  // namespace

std::string without_negative_light(std::vector<float>& rgb, const std::string& name) {
    double light = 0, negative = 0;
    std::size_t count = 0;
    for (const float value : rgb) {
        (value < 0 ? negative : light) += std::abs(value);
        count += value < 0;
    }
    if (count == 0 || !(negative <= kMaxNegativeLight * light)) return {};
    for (float& value : rgb) value = value < 0 ? 0 : value;
    return fmt::format(
        "{}: {} of {} values are negative, colours that Rec. 709 does not have; they "
        "count as 0, which leaves out {:.2g} % of the light",
        name, count, rgb.size(), 100 * negative / light);
}

SceneDescription parse_scene(std::string_view text, const std::string& filename,
                             const References& references) {
    return parse_scene(io::typed_file(std::string(text), filename, references));
}

SceneDescription parse_scene(const io::TypedFile& file) {
    const std::shared_ptr<io::TomlDocument> parsed = io::TomlDocument::of(file);
    io::TomlDocument& document = *parsed;
    if (file.kind == io::FileKind::recipe && document.root().contains("ior")) {
        throw InputError(fmt::format(
            "{}: is a recipe; needed here is a scene, whose paint it may be", file.name));
    }
    SceneDescription scene;
    scene.references = file.references;
    const paint::Described described(scene);
    const io::TableReader table(document, keys_of(described));
    io::read_described(table, described);
    read_pictures(table, scene);
    note_places(table, scene);
    if (scene.shapes.empty()) {
        table.fail("shapes",
                   fmt::format("is missing; a scene needs 1 to {} tables [[shapes]]", kMaxShapes));
    }
    if (scene.lights.empty() && !scene.environment) {
        table.fail("environment",
                   "is missing; a scene needs an [environment] or at least one of [[lights]]");
    }
    try {
        validate(scene);
    } catch (const DomainError& error) {
        rethrow_with_location(document, error.what());
    }
    return scene;
}

SceneDescription read_scene(const std::filesystem::path& path) {
    return read_scene(path, References::of_file(path));
}

SceneDescription read_scene(const std::filesystem::path& path, const References& references) {
    return parse_scene(
        io::typed_file(read_file(path, io::kMaxTextBytes), path.string(), references));
}

}  // namespace nacre::render
