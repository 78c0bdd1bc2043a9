#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "apps/cli/options.h"
#include "nacre/core/text.h"
#include "nacre/io/described_toml.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/mesh_scene.h"
#include "nacre/render/scene_description.h"

namespace nacre::cli {

namespace {

struct SceneOptions : CommonOptions {
    std::string name;
    render::MeshSceneOptions mesh;
};

bool names_mesh(const std::string& name) {
    const std::string extension = lowercase(std::filesystem::path(name).extension().string());
    return extension == ".obj" || extension == ".ply" || extension == ".stl" ||
           extension == ".gltf" || extension == ".glb";
}

/// The name of a file in a scene that is written to `output`, in whose folder names start.
std::filesystem::path name_in_scene(const std::filesystem::path& file, const std::string& output) {
    namespace fs = std::filesystem;
    const bool has_folder = !output.empty() && !is_stream(output) && !is_standard_output(output);
    if (!has_folder || file.is_absolute()) return file;
    const auto folder_of = [](const fs::path& path) {
        return path.has_parent_path() ? path.parent_path() : fs::path(".");
    };
    std::error_code ec;
    const fs::path way = fs::relative(folder_of(file), folder_of(output), ec);
    if (ec || way.empty()) return fs::absolute(file);
    return (way / file.filename()).lexically_normal();
}

std::string text_of(const render::SceneDescription& scene, const std::string& heading) {
    return fmt::format("# {}\n\n{}", heading,
                       io::write_described(paint::Described::to_inspect(scene)));
}

std::string scene_text(const SceneOptions& options) {
    const std::string& name = options.name;
    if (names_mesh(name)) {
        render::SceneDescription scene = render::scene_of_mesh(name, options.mesh);
        for (const std::string& note : scene.notes) warn(options, note);
        for (render::Shape& shape : scene.shapes) {
            if (auto* mesh = std::get_if<render::MeshFile>(&shape.geometry)) {
                mesh->path = name_in_scene(mesh->path, options.output);
            }
        }
        return text_of(scene, "A scene of the mesh " + name + ", with every default written out.");
    }
    if (!options.mesh.painted.empty() || !options.mesh.camera.empty()) {
        throw UsageError(fmt::format("--painted and --camera are for meshes, not '{}'", name));
    }
    const render::SceneDescription scene = render::builtin_scene(name);
    return text_of(scene,
                   fmt::format("{}.\n# The built-in scene {}, with every default written out.",
                               render::builtin_scene_caption(name), name));
}

}  // namespace

Command add_scene(CLI::App& program) {
    auto options = std::make_shared<SceneOptions>();
    CLI::App* scene = program.add_subcommand(
        "scene", "Write a built-in scene, or one of a mesh, as a file to start from");
    scene
        ->add_option("NAME", options->name,
                     fmt::format("{}, or a mesh: .obj, .ply, .stl, .gltf, .glb",
                                 fmt::join(render::builtin_scene_names(), ", ")))
        ->required();
    scene->add_option("--painted", options->mesh.painted,
                      "Of a mesh: a part that is painted, by the name of its material; repeatable");
    scene->add_option("--camera", options->mesh.camera,
                      "Of a glTF: the camera of this name; else its first");
    add_output(*scene, *options);
    scene->footer(
        "Writes TOML, whose every key docs/scene.md explains.\n\n"
        "Example:\n"
        "  nacre scene sphere > my.toml\n"
        "  nacre scene car.glb --painted body -o my.toml\n"
        "  nacre render my.toml --paint paints/ruby.toml -o ruby.exr");
    return {scene, [options] { return files_of(*options, {options->name}); },
            [options] {
                emit(*options, scene_text(*options));
                return ExitStatus::ok;
            }};
}

}  // namespace nacre::cli
