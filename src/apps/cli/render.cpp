#include "nacre/render/render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/measured_source.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_source.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/io/recipe_file.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/render_image.h"
#include "nacre/render/scene_file.h"

namespace nacre::cli {

namespace {

namespace fs = std::filesystem;

constexpr int kMaxPixelsPerSide = 32768;  // as in render::RenderOptions

struct RenderCommandOptions : CommonOptions {
    std::string scene;
    std::string paint;
    std::string brdf;  // measured: in the place of the paint
    ModelOptions model;
    std::string size = "512x512";
    render::RenderOptions render;
    io::ToneMap tone_map;
};

/// "640x480".
void parse_size(const std::string& text, render::RenderOptions& options) {
    const std::vector<std::string> sides = split(text, 'x');
    const Range range{1, kMaxPixelsPerSide, "pixels"};
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

/// A scene file, or a built-in scene by its name; a file of that name comes first.
render::SceneDescription load_scene(const std::string& name) {
    if (fs::exists(name) || fs::path(name).has_extension()) return render::read_scene(name);
    return render::builtin_scene(name);
}

/// What a paint lies on, for models that must know it.
std::vector<bsdf::PaintedShape> painted_shapes(const render::SceneDescription& scene,
                                               const std::string& material) {
    using Kind = bsdf::PaintedShape::Kind;
    std::vector<bsdf::PaintedShape> shapes;
    for (const render::Shape& shape : scene.shapes) {
        if (shape.material != material) continue;
        const double scale = shape.transform.scale;
        if (const auto* sphere = std::get_if<render::Sphere>(&shape.geometry)) {
            shapes.push_back({.kind = Kind::sphere, .radius_mm = sphere->radius_mm * scale});
        } else if (const auto* panel = std::get_if<render::FlatPanel>(&shape.geometry)) {
            shapes.push_back({.kind = Kind::panel,
                              .width_mm = scale * panel->width_mm,
                              .height_mm = scale * panel->height_mm});
        } else {
            shapes.push_back({});
        }
    }
    return shapes;
}

/// Makes each paint once for all materials that it is on.
class PaintMaker {
 public:
    explicit PaintMaker(const RenderCommandOptions& options)
        : options_(options), model_(parse_model_settings(options.model, options.seed)) {}

    const PaintSurface& make(const render::SceneDescription& scene, const std::string& material,
                             const fs::path& path) {
        if (is_measured_brdf_file(path)) return made(path, models::default_model());
        model_used_ = true;
        bsdf::Model model = model_;
        try {
            model.lie_on(material, painted_shapes(scene, material));
        } catch (const DomainError& error) {
            throw UsageError(fmt::format("{}: {}", choice_of(model.info()), error.what()));
        }
        return made(path, model);
    }

    /// Whether a recipe was among them.
    bool model_used() const { return model_used_; }

 private:
    const PaintSurface& made(const fs::path& path, const bsdf::Model& model) {
        for (const Made& known : made_) {
            if (known.path == path && known.model == model) return known.paint;
        }
        made_.push_back({path, model, load_surface(path, model, options_)});
        return made_.back().paint;
    }

    const RenderCommandOptions& options_;
    bsdf::Model model_;
    bool model_used_ = false;
    struct Made {
        fs::path path;
        bsdf::Model model;
        PaintSurface paint;
    };
    std::deque<Made> made_;  // keeps what was handed out in its place
};

/// Every paint of the scene, the slot without a recipe being filled by --paint.
struct Paints {
    render::PaintTable table;
    std::map<std::string, std::string> recipe_sha256;  // by name of the material
    bool model_used = false;                           // false: all are measured
};

/// What --brdf names must be a measured BRDF, and no model has a part in it.
void check_brdf(const RenderCommandOptions& options) {
    if (options.brdf.empty()) return;
    if (!options.paint.empty()) throw UsageError("--paint and --brdf exclude each other");
    if (!is_measured_brdf_file(options.brdf)) {
        throw InputError(fmt::format(
            "{}: holds no measured BRDF, neither of the RGL database (.bsdf) nor of MERL "
            "(.binary); recipes go with --paint",
            options.brdf));
    }
}

Paints make_paints(const render::SceneDescription& scene, const RenderCommandOptions& options) {
    Paints paints;
    PaintMaker maker(options);
    bool slot_found = false;
    for (const auto& [name, material] : scene.materials) {
        const auto* description = std::get_if<render::PaintMaterial>(&material);
        if (!description) continue;
        const bool is_slot = description->recipe.empty();
        slot_found |= is_slot;
        const std::string& slot = options.brdf.empty() ? options.paint : options.brdf;
        const fs::path path = is_slot ? fs::path(slot) : description->recipe;
        if (path.empty()) {
            throw UsageError(fmt::format(
                "the material {} of the scene {} has no recipe: name one with --paint, or "
                "a measured BRDF with --brdf",
                name, options.scene));
        }
        const PaintSurface& paint = maker.make(scene, name, path);
        paints.table[name] = paint.surface;
        if (paint.recipe) paints.recipe_sha256[name] = paint.recipe_sha256();
    }
    if (!(options.paint.empty() && options.brdf.empty()) && !slot_found) {
        throw UsageError(fmt::format("{} = {}: the scene {} has no material without a recipe",
                                     options.brdf.empty() ? "--paint" : "--brdf",
                                     options.brdf.empty() ? options.paint : options.brdf,
                                     options.scene));
    }
    paints.model_used = maker.model_used();
    if (!paints.model_used && !paints.table.empty()) {
        refuse_model_of_measured(options.model.model_given, options.model.model,
                                 "every material of the scene " + options.scene);
        if (parse_model_settings(options.model, options.seed).makes_table()) {
            throw UsageError(
                fmt::format("--table = {}: every material of the scene {} holds a measured BRDF; "
                            "tables are made of recipes",
                            options.model.value("--table"), options.scene));
        }
    }
    return paints;
}

/// A picture of measured surfaces alone owes nothing to a model.
std::string model_name(const RenderCommandOptions& options, const Paints& paints) {
    return paints.model_used || paints.table.empty() ? options.model.model : "measured";
}

std::map<std::string, std::string> metadata(const RenderCommandOptions& options,
                                            const Paints& paints) {
    std::map<std::string, std::string> data = {{"nacre:scene", options.scene},
                                               {"nacre:model", model_name(options, paints)},
                                               {"nacre:seed", fmt::format("{}", options.seed)}};
    for (const auto& [name, hash] : paints.recipe_sha256) {
        data["nacre:recipe_sha256:" + name] = hash;
    }
    return data;
}

ExitStatus run(RenderCommandOptions options) {
    parse_model_settings(options.model, options.seed);  // before any work
    parse_size(options.size, options.render);
    options.render.seed = options.seed;
    const fs::path exr = options.output;
    if (exr.extension() != ".exr") {
        throw UsageError(fmt::format("--output = {}: must end in .exr", options.output));
    }
    const fs::path png = fs::path(exr).replace_extension(".png");
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;

    check_brdf(options);
    const render::SceneDescription description = load_scene(options.scene);
    const Paints paints = make_paints(description, options);
    const render::Scene scene(description, paints.table);
    const double prepare_s = watch.seconds();
    render::RenderResult result;
    {
        ProgressBar bar("render", options.quiet);
        result = render::render(scene, options.render, bar.callback());
    }
    const io::Image image = render::image_of(result, metadata(options, paints));
    io::write_exr(exr, image);
    io::write_png(png, image, options.tone_map);

    const double samples = static_cast<double>(result.samples) * result.width * result.height;
    const double msamples_per_s = samples / result.seconds / 1e6;
    say(options, fmt::format("{}{} and {}: {} x {} pixels, {} samples each, {} ({:.2f} Msamples/s)",
                             result.complete ? "" : "stopped early; partial picture in ",
                             exr.string(), png.string(), result.width, result.height,
                             result.samples, duration_text(result.seconds), msamples_per_s));
    write_report(options, "render",
                 {{"scene", options.scene},
                  {"model", model_name(options, paints)},
                  {"recipe_sha256", paints.recipe_sha256},
                  {"output", {exr.string(), png.string()}},
                  {"width", result.width},
                  {"height", result.height},
                  {"samples_per_pixel", result.samples},
                  {"seed", options.seed},
                  {"complete", result.complete},
                  {"prepare_s", prepare_s},
                  {"render_s", result.seconds},
                  {"msamples_per_s", msamples_per_s},
                  {"total_s", watch.seconds()}});
    return result.complete ? ExitStatus::ok : ExitStatus::failure;
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
                     fmt::format("{}: side of the patch that a sample stands for, pixels; 0: the "
                                 "samples of a pixel share out what it shows",
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
    add_threads(*command, *options);
    add_quiet(*command, *options);
    add_report(*command, *options);
    command->footer(
        "The EXR holds linear Rec. 709 (1 is the perfect diffuser in full light), albedo and "
        "normal\n"
        "for denoisers, and the settings; the PNG is tone-mapped for looking at. With --sparkle,\n"
        "take sparkle from the picture, denoise the rest and add it again. For a given seed\n"
        "the picture does not depend on the number of threads. Ctrl-C writes what is there, marks\n"
        "it as partial and ends with status 3.\n\n"
        "Example:\n"
        "  nacre render sphere --paint paints/red-gold.toml --spp 256 --size 512x512 -o red.exr");
    return {command, [options] { return run(*options); }};
}

}  // namespace nacre::cli
