#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/cli/options.h"
#include "nacre/io/described_toml.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/scene_description.h"

namespace nacre::cli {

namespace {

struct SceneOptions : CommonOptions {
    std::string name;
};

std::string scene_text(const std::string& name) {
    const render::SceneDescription scene = render::builtin_scene(name);
    return fmt::format("# {}.\n# The built-in scene {}, with every default written out.\n\n{}",
                       render::builtin_scene_caption(name), name,
                       io::write_described(paint::Described::to_inspect(scene)));
}

}  // namespace

Command add_scene(CLI::App& program) {
    auto options = std::make_shared<SceneOptions>();
    CLI::App* scene =
        program.add_subcommand("scene", "Write a built-in scene as a file to start from");
    scene
        ->add_option("NAME", options->name,
                     fmt::format("{}", fmt::join(render::builtin_scene_names(), ", ")))
        ->required();
    add_output(*scene, *options);
    scene->footer(
        "Writes TOML, whose every key docs/scene.md explains.\n\n"
        "Example:\n"
        "  nacre scene sphere > my.toml\n"
        "  nacre render my.toml --paint paints/ruby.toml -o ruby.exr");
    return {scene, [options] { return files_of(*options, {}); },
            [options] {
                emit(*options, scene_text(options->name));
                return ExitStatus::ok;
            }};
}

}  // namespace nacre::cli
