#include "nacre/render/scene_file.h"

#include <fmt/format.h>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/described_toml.h"
#include "nacre/io/image.h"
#include "nacre/render/scene_description.h"

namespace nacre::render {

namespace {

/// 16384 x 8192 pixels: what an environment may have.
constexpr std::size_t kMaxEnvironmentValues = std::size_t{3} << 27;

/// The picture of an environment is read along with its table.
void read_picture(const io::TableReader& table, ImageEnvironment& environment) {
    try {
        const std::filesystem::path path =
            table.document().references().resolve(table.text("path", kMaxPathLength));
        const io::Image image = io::read_image(path, kMaxEnvironmentValues);
        environment.width = image.width;
        environment.height = image.height;
        environment.rgb = interleaved_rgb(image, path.string());
    } catch (const Error& error) {
        table.fail("path", error.what());
    }
}

}  // namespace

SceneDescription parse_scene(std::string_view text, const std::string& filename,
                             const References& references) {
    io::TomlDocument document(text, filename, references);
    SceneDescription scene;
    scene.references = references;
    const paint::Described described(scene);
    const io::TableReader table(document, keys_of(described));
    io::read_described(table, described);
    if (scene.environment) {
        if (auto* picture = std::get_if<ImageEnvironment>(&*scene.environment)) {
            read_picture(table.table("environment", {}), *picture);
        }
    }
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

bool looks_like_scene(std::string_view text, const std::string& filename) {
    const io::TomlDocument document(text, filename, {});
    for (std::string_view key : {"camera", "materials", "shapes", "lights", "environment"}) {
        if (document.root().contains(key)) return true;
    }
    return false;
}

SceneDescription read_scene(const std::filesystem::path& path) {
    return read_scene(path, References::of_file(path));
}

SceneDescription read_scene(const std::filesystem::path& path, const References& references) {
    return parse_scene(read_file(path, io::kMaxTextBytes), path.string(), references);
}

}  // namespace nacre::render
