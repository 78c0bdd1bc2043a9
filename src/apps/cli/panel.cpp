#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/files.h"
#include "apps/cli/instrument_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "apps/cli/tolerance_options.h"
#include "apps/cli/uncertainty_options.h"
#include "apps/datasheet/datasheet.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/nacre.h"
#include "nacre/render/builtin_scenes.h"

namespace nacre::cli {

namespace {

namespace fs = std::filesystem;
using Surface = std::shared_ptr<const bsdf::Bsdf>;

struct PanelOptions : CommonOptions {
    std::string recipe, versus;
    std::string quality = "normal";
    std::string scene = "curved-panel";
    ModelOptions model{.model = std::string(models::default_picture_model().info().name)};
    InstrumentOptions instrument;
    UncertaintyRequest uncertainty;
    ToleranceRequest tolerance;
};

/// Sizes and samples of the pictures.
struct Quality {
    int large_width, large_height, small_side, samples;
    measure::SparkleCamera camera;
};

Quality quality_of(const PanelOptions& options) {
    Quality quality =
        options.quality == "low" ? Quality{240, 160, 96, 8, {}} : Quality{600, 400, 300, 64, {}};
    quality.camera.seed = options.seed;
    if (options.quality == "low") {
        quality.camera.field_mm = 2;
        quality.camera.diffuse_samples = 4;
    }
    return quality;
}

/// Renders with a progress bar.
report::Picture picture(const PanelOptions& options, const Surface& surface,
                        const std::string& caption, const datasheet::PictureSettings& settings) {
    ProgressBar bar(settings.scene, options.quiet);
    return {caption, datasheet::painted_picture(surface, settings, bar.callback())};
}

/// @param standard  null: not to be drawn
std::vector<report::Picture> pictures(const PanelOptions& options, const Surface& sample,
                                      const Surface& standard, const Quality& quality) {
    const datasheet::PictureSettings small{.scene = "sphere",
                                           .width = quality.small_side,
                                           .height = quality.small_side,
                                           .samples_per_pixel = quality.samples,
                                           .seed = options.seed};
    datasheet::PictureSettings large = small;
    large.scene = options.scene;
    large.width = quality.large_width;
    large.height = quality.large_height;
    std::vector<report::Picture> all = {
        picture(options, sample, render::builtin_scene_caption(options.scene), large),
        picture(options, sample, standard ? "Sample, ball of 100 mm" : "Ball of 100 mm", small)};
    if (standard) all.push_back(picture(options, standard, "Standard", small));
    return all;
}

measure::SparkleMeasurement sparkle(const PanelOptions& options, const Surface& surface,
                                    const Quality& quality) {
    ProgressBar bar("sparkle", options.quiet);
    return measure_sparkle(*surface, {quality.camera}, bar.callback()).measurement;
}

/// Refuses wrong options before a minute of work.
void check_choices(const PanelOptions& options) {
    if (fs::path(options.output).extension() != ".html" && !is_standard_output(options.output)) {
        throw UsageError(fmt::format(
            "--output = {}: must end in .html, or be - for the standard output", options.output));
    }
    render::builtin_scene(options.scene);  // throws if there is none
}

/// @throws InputError if the file holds no paint
Paint open_panel(const PanelOptions& options, const std::string& file) {
    const Paint paint = open_paint(options, file);
    if (paint.is_measured()) {
        throw InputError(fmt::format(
            "{}: holds measured values; a panel report needs a recipe, for its pictures and its "
            "composition",
            file));
    }
    return paint;
}

/// The surface of the standard; null without a standard, or where it has only colours.
Surface standard_surface(const PanelOptions& options, const std::optional<Paint>& standard,
                         const bsdf::Model& model) {
    if (!standard || standard->kind() == Kind::measured_colours) return nullptr;
    if (standard->is_measured()) return standard->appearance();
    ProgressBar bar("solve", options.quiet);
    return standard->appearance(model, {}, bar.callback());
}

/// How far the readings of the sample are spread, under the conditions in which they were made.
std::optional<Uncertainty> uncertainty_beside(const PanelOptions& options, const Paint& paint,
                                              const Measurement& sample, MeasureSettings settings) {
    std::vector<Geometry> geometries;
    for (const measure::Reading& reading : sample.readings) geometries.push_back(reading.geometry);
    settings.illuminant = sample.conditions.illuminant;
    settings.observer = sample.conditions.observer;
    settings.aperture = sample.conditions.aperture;
    auto found = uncertainty_of(options, options.uncertainty, paint, geometries, settings);
    if (found) say_uncertainty(options, *found);
    return found;
}

ExitStatus run(const PanelOptions& options) {
    const bsdf::Model model = parse_model_settings(options.model);
    require_values(model.info());
    InstrumentRequest instrument = parse_instrument(options.instrument);
    instrument.settings.model = model;
    check_choices(options);
    if (options.versus.empty() && options.tolerance.asks()) {
        throw UsageError("--formula and --tolerance belong to --versus");
    }
    parse_tolerance(options.tolerance);  // before any work
    const Paint paint = open_panel(options, options.recipe);
    std::optional<Paint> versus;
    if (!options.versus.empty()) versus = open_input(options, options.versus);
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;

    const Surface surface = [&] {
        ProgressBar bar("solve", options.quiet);
        return paint.appearance(model, {}, bar.callback());
    }();
    say_warnings(options, paint);
    if (!paint.has_recipe()) {
        throw InputError(
            fmt::format("{}: does not say what the paint is made of; a panel report needs a recipe",
                        options.recipe));
    }
    datasheet::PanelReport page;
    page.model = &model.info();
    page.recipe = paint.recipe();
    page.recipe_sha256 = paint.recipe_sha256();
    if (!versus) {
        ProgressBar bar("measure", options.quiet);
        page.sample =
            paint.measure(instrument.geometries, instrument.settings, bar.callback()).measurement;
    } else {
        ProgressBar bar("measure", options.quiet);
        auto [sample, standard] = measure_alike(paint, *versus, instrument.geometries,
                                                instrument.settings, bar.callback());
        say_warnings(options, *versus);
        page.sample = std::move(sample.measurement);
        const measure::Difference difference =
            measure::difference(standard.measurement, page.sample);
        page.standard = datasheet::PanelStandard{std::move(standard.measurement), difference,
                                                 versus->is_measured()};
        if (const auto tolerance = parse_tolerance(options.tolerance)) {
            page.standard->verdict = measure::judge(difference, *tolerance);
        }
    }
    warn_of_coarse_spectra(options, page.sample);
    page.title = page.sample.name;
    page.uncertainty = uncertainty_beside(options, paint, page.sample, instrument.settings);
    const Quality quality = quality_of(options);
    if (model.info().can.sparkle) page.sparkle = sparkle(options, surface, quality);
    const Surface of_standard = standard_surface(options, versus, model);
    if (page.sparkle && of_standard && versus->has_recipe()) {
        page.standard->sparkle = sparkle(options, of_standard, quality);
    }
    page.pictures = pictures(options, surface, of_standard, quality);
    emit(options, datasheet::panel_report_html(page));

    if (!is_standard_output(options.output)) say(options, options.output);
    write_report(options, "panel",
                 {{"recipe", options.recipe},
                  {"recipe_sha256", page.recipe_sha256},
                  {"versus", options.versus},
                  {"model", options.model.model},
                  {"quality", options.quality},
                  {"seed", options.seed},
                  {"output", options.output},
                  {"total_s", watch.seconds()}});
    return status_of(options, page.standard ? page.standard->verdict : std::nullopt);
}

}  // namespace

Command add_panel(CLI::App& program) {
    auto options = std::make_shared<PanelOptions>();
    CLI::App* command = program.add_subcommand(
        "panel", "One page about a paint: pictures, colour by angle, metrics, composition");
    command->add_option("RECIPE", options->recipe, "Recipe (TOML) or solved paint (HDF5)")
        ->required();
    command->add_option("-o,--output", options->output, "Page to write; -: to the standard output")
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
    add_tolerance_options(*command, options->tolerance);
    add_uncertainty_options(*command, options->uncertainty);
    add_seed(*command, *options);
    add_input_options(*command, *options);
    add_set(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "Writes one HTML file without scripts that needs no other file and prints to A4. Sparkle\n"
        "and graininess are on it if the model shows single flakes. docs/panel.md says what each\n"
        "number means.\n\n"
        "Example:\n"
        "  nacre panel paints/tio2-mica-80.toml -o gold.html --versus paints/red-gold.toml");
    return {command,
            [options] {
                return files_of(*options,
                                {options->recipe, options->versus, options->instrument.geometry});
            },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
