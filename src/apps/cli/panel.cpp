#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/brdf_source.h"
#include "apps/cli/measured_sample.h"
#include "apps/cli/measured_source.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_source.h"
#include "apps/datasheet/datasheet.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/render/builtin_scenes.h"

namespace nacre::cli {

namespace {

namespace fs = std::filesystem;

struct PanelOptions : CommonOptions {
    std::string recipe, versus;
    std::string quality = "normal";
    std::string scene = "curved-panel";
    ModelOptions model{.model = sparkling_models().front()};
    InstrumentOptions instrument;
};

/// How much work goes into pictures.
struct Quality {
    int large_width, large_height, small_side, samples;
    measure::SparkleCamera camera;
};

Quality quality_of(const PanelOptions& options) {
    Quality quality =
        options.quality == "low" ? Quality{240, 160, 96, 16, {}} : Quality{600, 400, 300, 64, {}};
    quality.camera.seed = options.seed;
    if (options.quality == "low") {
        quality.camera.field_mm = 4;
        quality.camera.diffuse_samples = 8;
    }
    return quality;
}

/// Draws with a progress bar.
report::Picture picture(const PanelOptions& options, const PaintSurface& paint,
                        const std::string& caption, const datasheet::PictureSettings& settings) {
    ProgressBar bar(settings.scene, options.quiet);
    return {caption, datasheet::painted_picture(paint.surface, settings, bar.callback())};
}

std::vector<report::Picture> pictures(const PanelOptions& options, const PaintSurface& sample,
                                      const Quality& quality) {
    const datasheet::PictureSettings small{.scene = "sphere",
                                           .width = quality.small_side,
                                           .height = quality.small_side,
                                           .samples_per_pixel = quality.samples,
                                           .seed = options.seed};
    datasheet::PictureSettings large = small;
    large.scene = options.scene;
    large.width = quality.large_width;
    large.height = quality.large_height;
    const bool compares = !options.versus.empty() && !is_measured_file(options.versus);
    std::vector<report::Picture> all = {
        picture(options, sample, "", large),
        picture(options, sample, compares ? "Sample, ball of 100 mm" : "Ball of 100 mm", small)};
    if (compares) {
        const PaintSurface standard =
            is_measured_brdf_file(options.versus)
                ? load_surface(options.versus, models::default_model(), options)
                : load_surface(options.versus, parse_model_settings(options.model, options.seed),
                               options);
        all.push_back(picture(options, standard, "Standard", small));
    }
    return all;
}

measure::SparkleMeasurement sparkle(const PanelOptions& options, const PaintSurface& paint,
                                    const Quality& quality) {
    ProgressBar bar("sparkle", options.quiet);
    return measure::measure_pictures(
        quality.camera, measure::take_pictures(*paint.surface, quality.camera, bar.callback()));
}

void check_choices(const PanelOptions& options) {
    if (fs::path(options.output).extension() != ".html") {
        throw UsageError(fmt::format("--output = {}: must end in .html", options.output));
    }
    const fs::path folder = fs::path(options.output).parent_path();
    if (!folder.empty() && !fs::is_directory(folder)) {  // known before a minute of work
        throw InputError(fmt::format("{}: there is no such folder", folder.string()));
    }
    render::builtin_scene(options.scene);  // throws if there is none
    if (is_measured_file(options.recipe) || is_measured_brdf_file(options.recipe)) {
        throw InputError(fmt::format(
            "{}: holds measured values; a panel report needs a recipe, for its pictures and its "
            "composition",
            options.recipe));
    }
}

ExitStatus run(const PanelOptions& options) {
    const bsdf::Model model = parse_brdf_request(options.model, options.seed).model;
    const InstrumentRequest instrument = parse_instrument(options.instrument);
    check_choices(options);
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;

    const PaintSurface paint = load_surface(options.recipe, model, options);
    if (!paint.recipe) {
        throw InputError(
            fmt::format("{}: does not say what the paint is made of; a panel report needs a recipe",
                        options.recipe));
    }
    datasheet::PanelReport page;
    page.model = &model.info();
    page.recipe = *paint.recipe;
    page.recipe_sha256 = paint.recipe_sha256();
    if (options.versus.empty()) {
        page.sample =
            measure_sample(options.recipe, options.model, instrument, options).measurement;
    } else {
        auto [sample, standard] =
            measure_both(options.recipe, options.versus, options.model, instrument, options);
        page.sample = std::move(sample.measurement);
        const measure::Difference difference =
            measure::difference(standard.measurement, page.sample);
        page.standard = datasheet::PanelStandard{std::move(standard.measurement), difference,
                                                 standard.model.empty()};
    }
    page.title = page.sample.name;
    const Quality quality = quality_of(options);
    if (model.info().can.sparkle) page.sparkle = sparkle(options, paint, quality);
    page.pictures = pictures(options, paint, quality);
    emit(options, datasheet::panel_report_html(page));

    say(options, options.output);
    write_report(options, "panel",
                 {{"recipe", options.recipe},
                  {"recipe_sha256", page.recipe_sha256},
                  {"versus", options.versus},
                  {"model", options.model.model},
                  {"quality", options.quality},
                  {"seed", options.seed},
                  {"output", options.output},
                  {"total_s", watch.seconds()}});
    return ExitStatus::ok;
}

}  // namespace

Command add_panel(CLI::App& program) {
    auto options = std::make_shared<PanelOptions>();
    CLI::App* command = program.add_subcommand(
        "panel", "One page about a paint: pictures, colour by angle, metrics, composition");
    command->add_option("RECIPE", options->recipe, "Recipe (TOML) or solved paint (HDF5)")
        ->required();
    command->add_option("-o,--output", options->output, "Page to write")
        ->type_name("FILE.html")
        ->required();
    command->add_option(
        "--versus", options->versus,
        "Standard to compare with: a recipe, a measured file (CSV, JSON) or a measured "
        "BRDF (.bsdf, .binary)");
    command
        ->add_option("--quality", options->quality,
                     "normal, or low: small and noisy pictures, to see that all works")
        ->check(CLI::IsMember({"low", "normal"}))
        ->capture_default_str();
    command->add_option("--scene", options->scene, "Built-in scene of the large picture")
        ->capture_default_str();
    add_model_options(*command, options->model);
    add_instrument_options(*command, options->instrument);
    add_seed(*command, *options);
    add_threads(*command, *options);
    add_quiet(*command, *options);
    add_report(*command, *options);
    command->footer(
        "Writes one HTML file without scripts that needs no other file and prints to A4. Sparkle\n"
        "and graininess are on it if the model shows single flakes. docs/panel.md says what each\n"
        "number means.\n\n"
        "Example:\n"
        "  nacre panel paints/tio2-mica-80.toml -o gold.html --versus paints/red-gold.toml");
    return {command, [options] { return run(*options); }};
}

}  // namespace nacre::cli
