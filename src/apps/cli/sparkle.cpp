#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "apps/study/folder.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/io/file_kind.h"
#include "nacre/io/panel_image.h"
#include "nacre/measure/sparkle_measurement.h"
#include "nacre/nacre.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct SparkleOptions : CommonOptions {
    std::string recipe, versus;
    ModelOptions model;
    std::string lamps = "15,45,75";
    measure::SparkleCamera camera;
    measure::Viewing viewing;
    std::string format = "csv";
    std::string pictures;
};

/// The model, which must show single flakes and have values.
bsdf::Model parse_sparkling_model(const SparkleOptions& options) {
    const bsdf::ModelInfo& model = parse_model(options.model);
    if (!model.can.sparkle) {
        throw UsageError(
            fmt::format("--model = {}: shows no single flakes, so that there is no sparkle to be "
                        "measured; must be {}",
                        model.name, fmt::join(sparkling_models(), " or ")));
    }
    bsdf::Model chosen = parse_model_settings(options.model);
    require_values(chosen.info());
    return chosen;
}

/// "45s", "22.5s".
std::string lamp_name(double lamp_deg) { return fmt::format("{}s", lamp_deg); }

// Fewer spots are warned of: the standard error of their number is above 30 % of it.
constexpr double kFewSpots = 10;

constexpr const char* kHeader =
    "geometry,theta_i,Y,background_Y,threshold_Y,spots_per_cm2,spots_per_cm2_se,intensity,"
    "intensity_se,contrast,contrast_se,area_percent,area_percent_se,sparkle,sparkle_se,"
    "graininess,graininess_se,pixel_contrast,pixel_contrast_se\n";

/// A number that may be missing, and its error.
std::string cells(const std::optional<Estimate>& estimate, double scale = 1) {
    if (!estimate) return ",,";
    const double error = scale * estimate->standard_error;
    return fmt::format(",{:.6g},{}", scale * estimate->value,
                       std::isfinite(error) ? fmt::format("{:.6g}", error) : "");
}

std::string csv_of(const measure::SparkleMeasurement& measurement) {
    std::string table = kHeader;
    for (std::size_t i = 0; i < measurement.by_lamp.size(); ++i) {
        const measure::Sparkle& s = measurement.by_lamp[i];
        const double lamp = measurement.lamps_deg[i];
        table += fmt::format("{},{},{:.6g},{:.6g},{:.6g}", lamp_name(lamp), lamp, 100 * s.mean_y,
                             100 * s.background.y, 100 * s.background.threshold);
        table += cells(s.density_per_cm2) + cells(s.intensity) + cells(s.contrast) +
                 cells(s.area_fraction, 100) + cells(s.sparkle_per_cm2) + ",," +
                 cells(s.pixel_contrast) + "\n";
    }
    if (const auto& diffuse = measurement.diffuse) {
        table += fmt::format("diffuse,,{:.6g},,,,,,,,,,,,", 100 * diffuse->mean_y);
        table += cells(diffuse->graininess) + cells(diffuse->pixel_contrast) + "\n";
    }
    return table;
}

json json_of(const std::optional<Estimate>& estimate, double scale = 1) {
    if (!estimate) return nullptr;
    // What is not finite becomes null.
    return {{"value", scale * estimate->value},
            {"standard_error", scale * estimate->standard_error}};
}

/// Whether the panel that is seen is of another thickness at each place than the camera takes it for.
bool has_spread(const Paint& paint) {
    return paint.has_recipe() && paint.recipe().coat_spread() > 0;
}

json json_of(const SparkleOptions& options, const Paint& paint,
             const measure::SparkleMeasurement& measurement) {
    const measure::SparkleCamera& camera = options.camera;
    json readings = json::array();
    for (std::size_t i = 0; i < measurement.by_lamp.size(); ++i) {
        const measure::Sparkle& s = measurement.by_lamp[i];
        readings.push_back({{"geometry", lamp_name(measurement.lamps_deg[i])},
                            {"theta_i", measurement.lamps_deg[i]},
                            {"Y", 100 * s.mean_y},
                            {"background_Y", 100 * s.background.y},
                            {"threshold_Y", 100 * s.background.threshold},
                            {"eye_blur_um", 1e3 * s.blur_mm},
                            {"area_mm2", s.area_mm2},
                            {"spots_per_cm2", json_of(s.density_per_cm2)},
                            {"intensity", json_of(s.intensity)},
                            {"contrast", json_of(s.contrast)},
                            {"area_percent", json_of(s.area_fraction, 100)},
                            {"sparkle", json_of(s.sparkle_per_cm2)},
                            {"pixel_contrast", json_of(s.pixel_contrast)}});
    }
    if (const auto& diffuse = measurement.diffuse) {
        readings.push_back({{"geometry", "diffuse"},
                            {"Y", 100 * diffuse->mean_y},
                            {"graininess", json_of(diffuse->graininess)},
                            {"pixel_contrast", json_of(diffuse->pixel_contrast)}});
    }
    return {{"format", io::kSparkleFormat},
            {"recipe", options.recipe},
            {"recipe_sha256", paint.recipe_sha256()},
            {"model", options.model.model},
            {"seed", options.seed},
            {"of_mean_coat_thickness", has_spread(paint)},
            {"pixel_um", camera.pixel_um},
            {"field_mm", camera.field_mm},
            {"lamp_half_angle_deg", camera.lamp_half_angle_deg},
            {"distance_mm", options.viewing.distance_mm},
            {"illuminance_lx", options.viewing.illuminance_lx},
            {"readings", readings}};
}

void write_lamp_picture(const SparkleOptions& options, const std::string& name,
                        const measure::PanelPicture& picture) {
    throw_if_stopped();
    const io::ToneMap tone_map{io::display_stops(picture)};
    io::Image image = io::image_of(
        picture, {{"nacre:recipe", options.recipe},
                  {"nacre:model", options.model.model},
                  {"nacre:geometry", name},
                  {"nacre:pixel_um", fmt::format("{}", 1e3 * picture.pixel_mm)},
                  {"nacre:png_stops", fmt::format("{:.4g}", tone_map.exposure_stops)}});
    io::write_exr_and_png(fs::path(options.pictures) / (name + ".exr"), std::move(image), tone_map);
}

/// The mean of the two halves of the samples, for less noise.
measure::PanelPicture mean_of(const std::vector<measure::PanelPicture>& halves) {
    measure::PanelPicture mean = halves[0];
    for (std::size_t i = 0; i < mean.xyz.size(); ++i) {
        mean.xyz[i] = 0.5f * (halves[0].xyz[i] + halves[1].xyz[i]);
    }
    return mean;
}

std::vector<double> parse_lamps(const SparkleOptions& options) {
    std::vector<double> lamps_deg =
        parse_numbers("--lamp", options.lamps, SparkleCamera::kLampRange);
    if (lamps_deg.size() > SparkleCamera::kMaxLamps) {
        throw UsageError(fmt::format("--lamp: {} lamps are too many: at most {}", lamps_deg.size(),
                                     SparkleCamera::kMaxLamps));
    }
    return lamps_deg;
}

/// Says by which options the camera has too few pixels or too many.
void check_field(const measure::SparkleCamera& camera) {
    const double pixels = camera.field_mm * 1e3 / camera.pixel_um;
    if (!(camera.pixel_um > 0) || measure::kPixelsAcross.contains(pixels)) return;
    throw InputError(
        fmt::format("--field = {}: field of the camera in pixels = {} (of --pixel = {}): must be "
                    "a number in {}",
                    camera.field_mm, pixels, camera.pixel_um, measure::kPixelsAcross.text()));
}

CommandFiles files(const SparkleOptions& options) {
    std::set<std::string> pictures = {"diffuse"};
    for (double lamp_deg : parse_lamps(options)) pictures.insert(lamp_name(lamp_deg));
    CommandFiles files = files_of(options, {options.recipe, options.versus},
                                  options.format == "json" ? "JSON" : "CSV");
    files.folders = {{"--pictures", options.pictures}};
    for (const std::string& picture : pictures) {
        for (const char* extension : {".exr", ".png"}) {
            files.folders[0].files.push_back(picture + extension);
        }
    }
    return files;
}

/// What the camera saw of one paint.
struct Seen {
    Paint paint;
    measure::PanelPictures pictures;
    measure::SparkleMeasurement measurement;
    double prepare_s = 0, pictures_s = 0;
};

Seen see(const SparkleOptions& options, const Paint& paint, const bsdf::Model& model) {
    const Stopwatch watch;
    if (paint.kind() == Kind::measured_brdf) {
        throw InputError(fmt::format(
            "{}: holds a measured BRDF, which has no flakes; a recipe or a solved paint is needed "
            "here",
            paint.file()));
    }
    const auto look = [&] {
        ProgressBar bar("solve", options.quiet);
        return paint.appearance(model, {}, bar.callback());
    }();
    say_warnings(options, paint);
    if (paint.has_recipe() && paint.recipe().orange_peel() && !look->coat_waves()) {
        say(options,
            fmt::format("nacre: note: {}: clearcoat.orange_peel: {} shows a flat coat; only "
                        "nacre and microflake show its waves",
                        paint.name(), model.info().name));
    }
    Seen seen{.paint = paint, .pictures = {}, .measurement = {}, .prepare_s = watch.seconds()};
    ProgressBar bar("sparkle", options.quiet);
    seen.pictures = measure::take_pictures(*look, options.camera, bar.callback());
    seen.pictures_s = watch.seconds() - seen.prepare_s;
    seen.measurement =
        measure::measure_pictures(options.camera, seen.pictures, options.viewing, bar.callback());
    return seen;
}

void print_warnings(const SparkleOptions& options, const Seen& seen) {
    if (has_spread(seen.paint)) {
        say(options,
            fmt::format("nacre: note: {}: clearcoat.thickness_spread_um = {}: the camera sees "
                        "the mean thickness everywhere",
                        seen.paint.name(), seen.paint.recipe().clearcoat->thickness_spread_um));
    }
    if (!seen.pictures.flakes_resolved) {
        say(options,
            "nacre: flakes lie in heaps too dense to be told apart; graininess is too large");
    }
    for (std::size_t i = 0; i < seen.measurement.by_lamp.size(); ++i) {
        const measure::Sparkle& s = seen.measurement.by_lamp[i];
        const double spots = s.density_per_cm2.value * s.area_mm2 / 100;
        if (spots < kFewSpots) {
            say(options,
                fmt::format("nacre: {}: {}: only {:.0f} spots were seen; a larger --field "
                            "counts more",
                            seen.paint.name(), lamp_name(seen.measurement.lamps_deg[i]), spots));
        }
    }
}

/// A quantity of both panels, and their difference.
struct Compared {
    std::string geometry, quantity;
    std::optional<Estimate> standard, sample;

    /// Sample less standard; the panels' flakes are independent.
    std::optional<Estimate> difference() const {
        if (!standard || !sample) return std::nullopt;
        return Estimate{sample->value - standard->value,
                        std::hypot(sample->standard_error, standard->standard_error)};
    }
};

std::vector<Compared> compared(const measure::SparkleMeasurement& standard,
                               const measure::SparkleMeasurement& sample) {
    std::vector<Compared> rows;
    for (std::size_t i = 0; i < sample.by_lamp.size(); ++i) {
        const measure::Sparkle &a = standard.by_lamp[i], &b = sample.by_lamp[i];
        const std::string lamp = lamp_name(sample.lamps_deg[i]);
        rows.push_back({lamp, "spots_per_cm2", a.density_per_cm2, b.density_per_cm2});
        rows.push_back({lamp, "intensity", a.intensity, b.intensity});
        rows.push_back({lamp, "contrast", a.contrast, b.contrast});
        rows.push_back({lamp, "sparkle", a.sparkle_per_cm2, b.sparkle_per_cm2});
    }
    if (standard.diffuse && sample.diffuse) {
        rows.push_back(
            {"diffuse", "graininess", standard.diffuse->graininess, sample.diffuse->graininess});
    }
    return rows;
}

std::string csv_of(const std::vector<Compared>& rows) {
    std::string table =
        "geometry,quantity,standard,standard_se,sample,sample_se,difference,difference_se\n";
    for (const Compared& row : rows) {
        table += row.geometry + "," + row.quantity + cells(row.standard) + cells(row.sample) +
                 cells(row.difference()) + "\n";
    }
    return table;
}

json json_of(const std::vector<Compared>& rows) {
    json list = json::array();
    for (const Compared& row : rows) {
        list.push_back({{"geometry", row.geometry},
                        {"quantity", row.quantity},
                        {"standard", json_of(row.standard)},
                        {"sample", json_of(row.sample)},
                        {"difference", json_of(row.difference())}});
    }
    return list;
}

void write_pictures(const SparkleOptions& options, const measure::PanelPictures& pictures) {
    study::make_folder(options.pictures);
    for (std::size_t i = 0; i < pictures.by_lamp.size(); ++i) {
        write_lamp_picture(options, lamp_name(options.camera.lamps_deg[i]), pictures.by_lamp[i]);
    }
    if (!pictures.diffuse.empty())
        write_lamp_picture(options, "diffuse", mean_of(pictures.diffuse));
}

ExitStatus run(SparkleOptions options) {
    if (options.format == "json") refuse_table_options(options);
    const bsdf::Model model = parse_sparkling_model(options);
    options.camera.seed = options.seed;
    options.camera.lamps_deg = parse_lamps(options);
    check_field(options.camera);
    measure::check(options.camera);
    measure::check(options.viewing);
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;
    const Paint paint = open_paint(options, options.recipe);
    std::optional<Paint> versus;
    if (!options.versus.empty()) versus = open_input(options, options.versus);
    const Seen sample = see(options, paint, model);
    print_warnings(options, sample);
    std::vector<Compared> rows;
    if (versus) {
        bsdf::Model other = model;  // flakes of its own, or equal panels would err alike
        other.set_specimen(model.specimen().value_or(0) + 1);
        const Seen standard = see(options, *versus, other);
        print_warnings(options, standard);
        rows = compared(standard.measurement, sample.measurement);
    }
    if (!options.pictures.empty()) write_pictures(options, sample.pictures);
    if (options.format == "json") {
        json document = json_of(options, sample.paint, sample.measurement);
        if (!options.versus.empty()) {
            document["standard"] = options.versus;
            document["comparison"] = json_of(rows);
        }
        emit(options, document.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
    } else {
        emit_table(options, options.versus.empty() ? csv_of(sample.measurement) : csv_of(rows));
    }
    write_report(options, "sparkle",
                 {{"recipe", options.recipe},
                  {"recipe_sha256", sample.paint.recipe_sha256()},
                  {"versus", options.versus},
                  {"model", options.model.model},
                  {"seed", options.seed},
                  {"of_mean_coat_thickness", has_spread(sample.paint)},
                  {"prepare_s", sample.prepare_s},
                  {"pictures_s", sample.pictures_s},
                  {"total_s", watch.seconds()}});
    return ExitStatus::ok;
}

}  // namespace

Command add_sparkle(CLI::App& program) {
    auto options = std::make_shared<SparkleOptions>();
    options->model.model = sparkling_models().front();
    CLI::App* sparkle = program.add_subcommand(
        "sparkle", "Measure sparkle and graininess of a paint with a virtual camera");
    sparkle->add_option("RECIPE", options->recipe, "Recipe (TOML) or solved paint")->required();
    sparkle->add_option("--versus", options->versus,
                        "Standard to compare with: a recipe (TOML) or solved paint");
    add_model_options(*sparkle, options->model);
    sparkle->add_option("--lamp", options->lamps, "Lamps, deg from the normal")
        ->capture_default_str();
    sparkle
        ->add_option("--lamp-half-angle", options->camera.lamp_half_angle_deg,
                     "Angular radius of the lamps, deg; 0 is a point, the sun has 0.27")
        ->capture_default_str();
    sparkle->add_option("--field", options->camera.field_mm, "Side of what the camera sees, mm")
        ->capture_default_str();
    sparkle->add_option("--pixel", options->camera.pixel_um, "Side of a pixel on the panel, um")
        ->capture_default_str();
    sparkle
        ->add_option("--diffuse-samples", options->camera.diffuse_samples,
                     "Directions a pixel for the picture in diffuse light; even; 0: none")
        ->capture_default_str();
    sparkle
        ->add_option("--distance", options->viewing.distance_mm,
                     "From which the panel is looked at, mm")
        ->capture_default_str();
    sparkle->add_option("--illuminance", options->viewing.illuminance_lx, "On the panel, lx")
        ->capture_default_str();
    sparkle
        ->add_option("--panel", options->camera.unit_square_mm,
                     fmt::format("{}: side of the panel over which the recipe's facets lie, mm",
                                 fmt::join(unit_square_models(), ", ")))
        ->capture_default_str();
    sparkle->add_option("--format", options->format, "csv or json")
        ->check(CLI::IsMember({"csv", "json"}))
        ->capture_default_str();
    sparkle
        ->add_option("--pictures", options->pictures,
                     "Folder for what the camera saw: an EXR and a PNG for each lamp and for "
                     "diffuse light")
        ->type_name("DIR");
    add_table_output(*sparkle, *options);
    add_seed(*sparkle, *options);
    add_input_options(*sparkle, *options);
    add_set(*sparkle, *options);
    add_run_options(*sparkle, *options);
    sparkle->footer(
        "The camera looks along the normal of a flat panel. One row a lamp (15s, 45s, 75s) and "
        "one\n"
        "for diffuse light; columns ending in _se are standard errors. Luminances Y are 100 for "
        "the\n"
        "perfect diffuser; intensity, graininess and sparkle are in thresholds of seeing:\n"
        "docs/sparkle.md defines them. Instruments' own scales are not public: do not compare.\n"
        "With --versus: both panels' numbers and the difference, sample less standard, one row a\n"
        "lamp and quantity; --pictures are the sample's.\n\n"
        "Examples:\n  nacre sparkle paints/metallic-silver.toml\n"
        "  nacre sparkle paints/glitter-100um.toml --lamp 15:75:15 --pictures seen -o sparkle.csv");
    return {sparkle, [options] { return files(*options); }, [options] { return run(*options); }};
}

}  // namespace nacre::cli
