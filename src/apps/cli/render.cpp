#include "nacre/render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/render/builtin_scenes.h"

namespace nacre::cli {

namespace {

namespace fs = std::filesystem;

struct RenderCommandOptions : CommonOptions {
    std::string scene;
    std::string paint;
    std::string brdf;  // measured, instead of the paint
    ModelOptions model;
    std::string size = "512x512";
    render::RenderOptions render;
    io::ToneMap tone_map;
};

/// "640x480".
void parse_size(const std::string& text, render::RenderOptions& options) {
    const std::vector<std::string_view> sides = split(text, 'x');
    const Range range{1, io::kMaxPixelsPerSide, "pixels"};
    if (sides.size() == 2) {
        const double width = parse_number("--size (width)", sides[0], range);
        const double height = parse_number("--size (height)", sides[1], range);
        options.width = static_cast<int>(width);
        options.height = static_cast<int>(height);
        if (options.width == width && options.height == height) return;
    }
    throw UsageError(
        fmt::format("--size = {}: must be WIDTHxHEIGHT in whole pixels, as in 512x512", text));
}

/// --brdf, which must name a measured BRDF; none if it was not given.
std::optional<Paint> open_brdf(const RenderCommandOptions& options) {
    if (options.brdf.empty()) return std::nullopt;
    if (!options.paint.empty()) throw UsageError("--paint and --brdf exclude each other");
    Paint brdf = open_input(options, options.brdf);
    if (brdf.kind() != Kind::measured_brdf) {
        throw InputError(fmt::format(
            "{}: holds no measured BRDF, neither of the RGL database (.bsdf) nor of MERL "
            "(.binary); recipes go with --paint",
            options.brdf));
    }
    return brdf;
}

/// The paint for materials without a recipe, if there are any: --brdf, or --paint.
std::optional<Paint> paint_for_slots(const render::SceneDescription& description,
                                     const RenderCommandOptions& options,
                                     std::optional<Paint> brdf) {
    const std::vector<std::string> slots = paint_slots(description);
    if (!brdf && options.paint.empty()) {
        if (slots.empty()) return std::nullopt;
        throw UsageError(
            fmt::format("the material {} of the scene {} has no recipe: name one with --paint, or "
                        "a measured BRDF with --brdf",
                        slots[0], options.scene));
    }
    if (slots.empty()) {
        throw UsageError(fmt::format("{} = {}: the scene {} has no material without a recipe",
                                     brdf ? "--brdf" : "--paint",
                                     brdf ? options.brdf : options.paint, options.scene));
    }
    return brdf ? brdf : open_paint(options, options.paint);
}

Scene painted_scene(const RenderCommandOptions& options) {
    const bsdf::Model model = parse_model_settings(options.model);
    if (options.paint.empty() && !options.set.empty()) {
        throw UsageError("--set belongs to --paint: it changes that recipe");
    }
    std::optional<Paint> brdf = open_brdf(options);
    render::SceneDescription description =
        find_scene(options.scene, references_of(options, options.scene));
    std::optional<Paint> slot = paint_for_slots(description, options, std::move(brdf));
    ProgressBar bar("prepare", options.quiet || !model.makes_table());
    try {
        return Scene(std::move(description), {std::move(slot), model}, bar.callback());
    } catch (const SettingError& error) {  // where the model does not go
        if (error.setting() != "model") throw;
        throw UsageError(fmt::format("{}: {}", choice_of(model.info()), error.reason()));
    }
}

/// Refuses model options where every paint is a measured BRDF, which takes no model.
void check_model(const RenderCommandOptions& options, const Scene& scene) {
    if (scene.paints().empty() || scene.shows_model()) return;
    if (options.model.model_given) {
        refuse_model(options.model.model, "every material of the scene " + options.scene);
    }
    const bsdf::Model model = parse_model_settings(options.model);
    if (model.makes_table()) {
        throw UsageError(
            fmt::format("{}: every material of the scene {} holds a measured BRDF; "
                        "tables are made of recipes",
                        choice_of_table(model), options.scene));
    }
}

ExitStatus run(RenderCommandOptions options) {
    parse_model_settings(options.model);  // before any work
    parse_size(options.size, options.render);
    options.render.seed = options.seed;
    render::check(options.render);
    const fs::path exr = options.output, png = io::png_beside(exr);
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;

    const Scene scene = painted_scene(options);
    for (const Paint& paint : scene.paints()) say_warnings(options, paint);
    check_model(options, scene);
    const double prepare_s = watch.seconds();
    Picture picture = [&] {
        ProgressBar bar("render", options.quiet);
        return scene.render(options.render, bar.callback());
    }();
    const render::RenderResult& result = picture.result;
    if (result.samples == 0) {
        throw Error("stopped before every pixel had a sample; nothing was written");
    }
    picture.metadata["nacre:scene"] = options.scene;
    io::write_exr_and_png(exr, picture.image(), options.tone_map);

    const double samples = static_cast<double>(result.samples) * result.width * result.height;
    const double msamples_per_s = samples / result.seconds / 1e6;
    say(options, fmt::format("{}{} and {}: {} x {} pixels, {} samples each, {} ({:.2f} Msamples/s)",
                             result.complete ? "" : "stopped early; partial picture in ",
                             exr.string(), png.string(), result.width, result.height,
                             result.samples, duration_text(result.seconds), msamples_per_s));
    write_report(options, "render",
                 {{"scene", options.scene},
                  {"model", scene.model_name()},
                  {"recipe_sha256", scene.recipe_sha256()},
                  {"output", {exr.string(), png.string()}},
                  {"width", result.width},
                  {"height", result.height},
                  {"samples_per_pixel", result.samples},
                  {"seed", options.seed},
                  {"specimen", scene.specimen() ? nlohmann::json(*scene.specimen()) : nullptr},
                  {"complete", result.complete},
                  {"prepare_s", prepare_s},
                  {"render_s", result.seconds},
                  {"msamples_per_s", msamples_per_s},
                  {"total_s", watch.seconds()}});
    return result.complete ? ExitStatus::ok : ExitStatus::failure;
}

CommandFiles files(const RenderCommandOptions& options) {
    const fs::path exr = options.output;
    if (exr.extension() != ".exr") {
        throw UsageError(fmt::format("--output = {}: must end in .exr", options.output));
    }
    CommandFiles files = files_of(options, {options.scene, options.paint, options.brdf});
    files.files.push_back({"--output", io::png_beside(exr).string(), true});
    return files;
}

std::string joined_scene_names() {
    std::string names;
    for (const std::string& name : render::builtin_scene_names()) {
        names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

}  // namespace

Command add_render(CLI::App& program) {
    auto options = std::make_shared<RenderCommandOptions>();
    CLI::App* command = program.add_subcommand("render", "Render a picture of a painted scene");
    command
        ->add_option("SCENE", options->scene,
                     "Scene file (TOML), or a built-in scene: " + joined_scene_names())
        ->required();
    command
        ->add_option("--paint", options->paint,
                     "Recipe (TOML) or solved paint (HDF5) for the scene's unnamed paint")
        ->type_name("RECIPE");
    command
        ->add_option("--brdf", options->brdf,
                     "Measured BRDF (.bsdf of the RGL database, .binary of MERL) for it instead")
        ->type_name("FILE");
    add_model_options(*command, options->model);
    command
        ->add_option("--footprint", options->render.footprint_pixels,
                     fmt::format("{}: side of a patch that each sample shows, pixels, for "
                                 "experiments; 0: the samples share out what the pixel shows",
                                 fmt::join(sparkling_models(), ", ")))
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    command->add_flag("--sparkle", options->render.sparkle,
                      "Keep the light of single flakes apart as well, in the EXR's channels "
                      "sparkle.R, .G, .B: what they send less their mean");
    command->add_option("--spp", options->render.samples_per_pixel, "Samples per pixel")
        ->check(CLI::Range(1, 1 << 24))
        ->capture_default_str();
    command->add_option("--size", options->size, "Pixels as WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--depth", options->render.max_depth, "Surface reflections along a path")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--spectral-bins", options->render.spectral_bins,
                     "Spectral channels over 400 to 700 nm in the EXR; 0: none")
        ->check(CLI::Range(0, 300))
        ->capture_default_str();
    command
        ->add_option("--exposure", options->tone_map.exposure_stops,
                     "Exposure of the PNG in stops; the EXR is not touched")
        ->check(CLI::Range(-50.0, 50.0))
        ->capture_default_str();
    command
        ->add_option("-o,--output", options->output, "File to write (.exr); the .png is put beside")
        ->required()
        ->type_name("FILE");
    add_seed(*command, *options);
    add_set(*command, *options);
    add_untrusted(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "The EXR holds linear Rec. 709 (1 is the perfect diffuser in full light), albedo and "
        "normal\n"
        "for denoisers, and the settings; the PNG is tone-mapped for looking at. With --sparkle,\n"
        "take sparkle from the picture, denoise the rest and add it again. For a given seed\n"
        "the picture does not depend on the number of threads. Ctrl-C writes what is there, marks\n"
        "it as partial and ends with status 3.\n\n"
        "Example:\n"
        "  nacre render sphere --paint paints/red-gold.toml --spp 256 --size 512x512 -o red.exr");
    return {command, [options] { return files(*options); }, [options] { return run(*options); }};
}

}  // namespace nacre::cli
