#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/datasheet/atlas.h"
#include "apps/datasheet/datasheet.h"
#include "apps/studio/answers.h"
#include "nacre/fit/fit.h"
#include "nacre/io/recipe_text.h"
#include "nacre/measure/difference.h"
#include "nacre/measure/sparkle_measurement.h"
#include "nacre/models/models.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/spectra/spectrum.h"

// Answers that take seconds, and tell how far they are.

namespace nacre::studio {

namespace {

/// Passes on whether to go on, and tells the page how far the work is, at most every 100 ms.
class ProgressReporter {
 public:
    ProgressReporter(const Context& context, const char* about)
        : context_(context), about_(about) {}

    /// For a part of the work, [from, to] of all of it.
    Progress part(double from, double to) {
        return [this, from, to](double fraction) {
            if (!context_.progress(fraction)) return false;
            const auto now = Clock::now();
            if (fraction != told_ && now - last_ >= std::chrono::milliseconds(100)) {
                last_ = now;
                told_ = fraction;
                context_.send("progress of " + about_,
                              {{dumped({{"type", "progress"},
                                        {"id", context_.id},
                                        {"about", about_},
                                        {"fraction", from + (to - from) * fraction}}),
                                {}}});
            }
            return true;
        };
    }

 private:
    using Clock = std::chrono::steady_clock;
    const Context& context_;
    const std::string about_;
    Clock::time_point last_{};
    double told_ = -1;
};

Tree estimate_json(const std::optional<Estimate>& estimate, double scale = 1) {
    if (!estimate) return nullptr;
    return {{"value", scale * estimate->value},
            {"standard_error", scale * estimate->standard_error}};  // null if it is not finite
}

Tree sparkle_json(const SparkleReadings& sparkle) {
    const measure::SparkleMeasurement& measurement = sparkle.measurement;
    Tree readings = Tree::array();
    for (std::size_t i = 0; i < measurement.by_lamp.size(); ++i) {
        const measure::Sparkle& s = measurement.by_lamp[i];
        readings.push_back({{"geometry", fmt::format("{}s", measurement.lamps_deg[i])},
                            {"theta_i", measurement.lamps_deg[i]},
                            {"Y", 100 * s.mean_y},
                            {"background_Y", 100 * s.background.y},
                            {"threshold_Y", 100 * s.background.threshold},
                            {"spots_per_cm2", estimate_json(s.density_per_cm2)},
                            {"intensity", estimate_json(s.intensity)},
                            {"contrast", estimate_json(s.contrast)},
                            {"area_percent", estimate_json(s.area_fraction, 100)},
                            {"sparkle", estimate_json(s.sparkle_per_cm2)},
                            {"pixel_contrast", estimate_json(s.pixel_contrast)}});
    }
    Tree json = {{"readings", std::move(readings)},
                 {"graininess", nullptr},
                 {"flakes_resolved", sparkle.pictures.flakes_resolved}};
    if (const auto& diffuse = measurement.diffuse) {
        json["graininess"] = estimate_json(diffuse->graininess);
    }
    return json;
}

Model sparkling_model(double specimen) {
    return NacreModel{.specimen = static_cast<std::uint64_t>(specimen)};
}

/// One composition that a fit found.
Tree match_json(const NamedPaint& start, const std::vector<fit::FittedParameter>& parameters,
                const std::vector<double>& values, double mean, double max, bool best) {
    Paint paint = start.paint;
    Tree numbers = Tree::array();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const fit::FittedParameter& fitted = parameters[i];
        const std::string& key = fitted.number.bounds.key;
        paint = paint.with(key, values[i]);
        const bool has_error = best && fitted.standard_error;
        numbers.push_back({{"key", key},
                           {"start", fitted.number.start},
                           {"value", values[i]},
                           {"unit", paint::find_parameter(paint.recipe(), key).range.unit},
                           {"sd", has_error ? Tree(*fitted.standard_error) : Tree(nullptr)},
                           {"bounds", {fitted.number.bounds.lo, fitted.number.bounds.hi}},
                           {"at_bound", best && (fitted.at_lower_bound || fitted.at_upper_bound)}});
    }
    const std::string toml = paint.recipe_text(References()).text;
    return {{"recipe", tree_of_toml(toml, "recipe.toml")},
            {"toml", toml},
            {"mean_delta_e", mean},
            {"max_delta_e", max},
            {"parameters", std::move(numbers)},
            {"text", fmt::format("mean Delta E 2000 {:.2f}, greatest {:.2f}", mean, max)}};
}

}  // namespace

Frames answer(const SparkleRequest& request, const Context& context) {
    const NamedPaint named = paint_of(request.recipe, context);
    ProgressReporter teller(context, "sparkle");
    const auto look =
        named.paint.appearance(sparkling_model(request.specimen), {}, teller.part(0, 0.1));
    Tree json = {{"type", "sparkle"}, {"id", context.id}};
    json.update(sparkle_json(measure_sparkle(*look, {}, teller.part(0.1, 1))));
    return {{dumped(json), {}}};
}

Frames answer(const FitRequest& request, const Context& context) {
    const auto standard = context.memory.standard();
    if (!standard) throw InputError("standard: is missing; a fit needs one to come near to");
    const NamedPaint named = paint_of(request.recipe, context);
    if (request.free.empty() && named.paint.bounds().empty()) {
        throw InputError("free: is empty; name the numbers that may change");
    }
    ProgressReporter teller(context, "fit");
    FitSettings settings;
    settings.starts = request.starts;
    const Model model = models::named_model(request.model);
    settings.target.hot_spot = shows_hot_spot(model);
    const Measurement wanted =
        standard->measure({}, {.model = model}, context.progress).measurement;
    const fit::FreeKeys free = named.paint.free_keys(request.free, settings, teller.part(0, 0.02));
    const Match found = named.paint.fit(wanted, free.keys, settings, teller.part(0.02, 1));

    std::vector<double> best;
    for (const fit::FittedParameter& parameter : found.parameters) best.push_back(parameter.value);
    Tree matches = Tree::array();
    matches.push_back(match_json(named, found.parameters, best, found.difference.mean_delta_e_2000,
                                 found.difference.max_delta_e_2000, true));
    for (const fit::Minimum& other : found.alternatives) {
        matches.push_back(match_json(named, found.parameters, other.values, other.mean_delta_e_2000,
                                     other.max_delta_e_2000, false));
    }
    Tree skipped = Tree::array();
    for (const fit::SkippedNumber& number : free.skipped) {
        skipped.push_back({{"key", number.key}, {"why", number.why}});
    }
    Tree remedies = Tree::array();
    for (const fit::Remedy& remedy : found.remedies) {
        remedies.push_back({{"key", remedy.key},
                            {"action", remedy.widens ? "widen" : "free"},
                            {"bounds", {remedy.bounds.lo, remedy.bounds.hi}},
                            {"value", remedy.value},
                            {"mean_delta_e", remedy.mean_delta_e_2000}});
    }
    return {{dumped({{"type", "matches"},
                     {"id", context.id},
                     {"model", request.model},
                     {"matched", found.matched()},
                     {"within", found.matched_delta_e},
                     {"converged", found.converged},
                     {"ended", found.ended},
                     {"at_start",
                      {{"mean_delta_e", found.at_start.mean_delta_e_2000},
                       {"max_delta_e", found.at_start.max_delta_e_2000}}},
                     {"matches", std::move(matches)},
                     {"skipped", std::move(skipped)},
                     {"remedies", std::move(remedies)},
                     {"solves", found.effort.solves},
                     {"seconds", found.effort.seconds}}),
             {}}};
}

Frames answer(const AtlasRequest& request, const Context& context) {
    const NamedPaint named = paint_of(request.recipe, context);
    ProgressReporter teller(context, "atlas");
    const MeasureSettings settings = settings_of(request.viewed);
    const auto read = [&](const paint::Recipe& recipe, const Progress& progress) {
        return Paint(recipe).measure(request.viewed.geometries, settings, progress).measurement;
    };
    const datasheet::Atlas atlas = datasheet::recipe_atlas(
        named.paint.recipe(), request.key, request.values, request.viewed.geometries,
        spectra::default_wavelengths_nm(),
        {.illuminant = request.viewed.illuminant, .observer = request.viewed.observer},
        teller.part(0, 1), read);
    Tree names = Tree::array(), lab = Tree::array(), rgb = Tree::array();
    for (std::size_t g = 0; g < atlas.geometries.size(); ++g) {
        names.push_back(atlas.geometries[g].name);
        Tree lab_row = Tree::array(), rgb_row = Tree::array();
        for (std::size_t v = 0; v < atlas.values.size(); ++v) {
            lab_row.push_back(atlas.at(g, v));
            rgb_row.push_back(measure::srgb_chip_at_full_light(atlas.at(g, v)));
        }
        lab.push_back(std::move(lab_row));
        rgb.push_back(std::move(rgb_row));
    }
    return {{dumped({{"type", "atlas"},
                     {"id", context.id},
                     {"key", request.key},
                     {"model", request.viewed.model},
                     {"quantity", atlas.quantity},
                     {"values", atlas.values},
                     {"geometries", std::move(names)},
                     {"lab", std::move(lab)},
                     {"rgb", std::move(rgb)}}),
             {}}};
}

Frames answer(const ReportRequest& request, const Context& context) {
    const NamedPaint named = paint_of(request.recipe, context);
    ProgressReporter teller(context, "report");
    const Model model = models::default_picture_model();
    const auto look = named.paint.appearance(model, {}, teller.part(0, 0.02));

    datasheet::PanelReport page;
    page.model = &model.info();
    page.reading_model = models::find_model(request.viewed.model);
    page.recipe = named.paint.recipe();
    page.recipe_sha256 = named.paint.recipe_sha256();
    page.sample =
        named.paint
            .measure(request.viewed.geometries, settings_of(request.viewed), context.progress)
            .measurement;
    page.title = page.sample.name;
    if (const auto standard = context.memory.standard()) {
        Measurement measurement = standard_readings(*standard, request.viewed);
        const measure::Difference difference = measure::difference(measurement, page.sample);
        page.standard =
            datasheet::PanelStandard{std::move(measurement), difference, standard->is_measured()};
        if (request.tolerance.has_limits()) {
            page.standard->verdict =
                measure::judge(difference, known_limits(request.tolerance, difference));
        }
    }
    SparkleSettings camera;
    if (request.draft) camera.camera.field_mm = 2;
    page.sparkle = measure_sparkle(*look, camera, teller.part(0.02, 0.3)).measurement;
    const auto picture = [&](const std::string& scene, int width, int height, Progress progress) {
        const int samples = request.draft ? 4 : 64;
        return report::Picture{
            render::builtin_scene_caption(scene),
            datasheet::painted_picture(look,
                                       {.scene = scene,
                                        .width = request.draft ? width / 4 : width,
                                        .height = request.draft ? height / 4 : height,
                                        .samples_per_pixel = samples},
                                       progress)};
    };
    page.pictures.push_back(picture("curved-panel", 600, 400, teller.part(0.3, 0.75)));
    page.pictures.push_back(picture("sphere", 300, 300, teller.part(0.75, 1)));
    return {{dumped({{"type", "report"},
                     {"id", context.id},
                     {"name", page.title},
                     {"html", datasheet::panel_report_html(page)}}),
             {}}};
}

}  // namespace nacre::studio
