#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/study/mir_2022.h"
#include "nacre/core/file.h"
#include "nacre/io/image_difference.h"
#include "nacre/io/recipe_file.h"
#include "nacre/measure/instrument.h"
#include "nacre/models/spectral_brdf.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

// Table 4 and Figure 4: the models on two pearls, and their colour against angle.

namespace nacre::study {
namespace {

struct Pearl {
    const char* key;
    const char* name;
    const char* file;
};
constexpr Pearl kPearls[] = {{"tio2-80", "80 nm of TiO₂", "paints/tio2-mica-80.toml"},
                             {"tio2-110", "110 nm of TiO₂", "paints/tio2-mica-110.toml"}};

std::vector<bsdf::Model> all_four() {
    return {named_model("microflake"), named_model("thin-film"), named_model("special-effect"),
            named_model("nacre")};
}

void add_pictures(MirContext& context) {
    report::Table table{.caption = "The models on two pearls",
                        .columns = {"paint", "model", "preparation", "time", "Msamples/s",
                                    "peak memory", "published time"}};
    std::vector<report::Picture> pictures;
    const std::vector<bsdf::Model> models = all_four();
    for (const Pearl& pearl : kPearls) {
        for (const bsdf::Model& model : models) {
            const std::string name{model.info().name};
            const Picture picture = context.gallery.make(
                context.job(fmt::format("table-4-{}-{}", pearl.key, name),
                            fmt::format("{}: {}", pearl.name, name), pearl.file, model));
            table.rows.push_back({{model == models.front() ? pearl.name : ""},
                                  {"`" + name + "`"},
                                  report::number_cell(duration(picture.prepare_s)),
                                  report::number_cell(duration(picture.render_s)),
                                  report::number_cell(number(picture.msamples_per_s)),
                                  report::number_cell(number(picture.peak_mib) + " MiB"),
                                  {name == "nacre" ? "not in the paper" : "—"}});
            pictures.push_back({fmt::format("{}, `{}`", pearl.name, name), picture.png});
            context.results["table_4"][pearl.key][name] = {
                {"prepare_s", picture.prepare_s},
                {"render_s", picture.render_s},
                {"msamples_per_s", picture.msamples_per_s},
                {"peak_mib", picture.peak_mib}};
        }
    }
    context.report.table(table);
    context.report.pictures(pictures, 4,
                            "Figure 4. `microflake`, `thin-film`, `special-effect` and `nacre`.");
}

/// The colour of a paint by one model, from the mirror direction to far behind the normal.
void add_colour(MirContext& context, const std::string& name, const std::string& file,
                const bsdf::Model& model, report::Plot& travel, report::Plot& lightness) {
    bsdf::ModelInput paint{.recipe = io::read_recipe(shipped_file(file))};
    const std::vector<double> wavelengths = spectra::default_wavelengths_nm();
    if (model.info().solution != bsdf::Solution::none) {
        paint.solved = std::make_shared<const solver::SolvedPaint>(
            solver::solve(paint.recipe, wavelengths, {}));
    }
    const auto surface = model.make(paint);
    const models::SpectralBrdf brdf(*surface, wavelengths);
    std::vector<measure::Geometry> geometries;
    for (int a = 0; a <= 110; a += 5) geometries.push_back(measure::in_plane(45, a));
    const measure::Measurement measurement = measure::measure(
        name,
        [&](double theta_i, double theta_o, double phi) { return brdf(theta_i, theta_o, phi); },
        wavelengths, geometries,
        {spectra::Illuminant::D65, spectra::Observer::cie1931_2deg, measure::Aperture{}});
    report::Series ab{.name = name, .dots = true}, l{.name = name};
    nlohmann::json& results = context.results["colour"][name];
    for (const measure::Reading& reading : measurement.readings) {
        const double aspecular_deg = reading.geometry.aspecular_deg;
        ab.x.push_back(reading.lab[1]);
        ab.y.push_back(reading.lab[2]);
        ab.point_colours.push_back(
            spectra::css_colour(measure::srgb_chip_at_full_light(reading.lab)));
        l.x.push_back(aspecular_deg);
        l.y.push_back(reading.lab[0]);
        results.push_back({{"aspecular_deg", aspecular_deg}, {"lab", reading.lab}});
    }
    travel.series.push_back(ab);
    lightness.series.push_back(l);
}

void add_colours(MirContext& context) {
    report::Report& report = context.report;
    report.heading(2, "Colour against angle", "colour-against-angle");
    report.paragraph(
        "Lit from 45°, seen in the same plane from 0° to 110° away from the mirror direction, "
        "every 5°. Each dot has the colour it stands for (brightest lobes are shown at full "
        "light).");
    struct Group {
        const char* title;
        std::vector<std::tuple<std::string, std::string, bsdf::Model>> series;
    };
    std::vector<Group> groups = {
        {"Metallic gray and cadmium red",
         {{"metallic gray", "paints/metallic-gray.toml", named_model("microflake")},
          {"cadmium red", "paints/cadmium-red.toml", named_model("microflake")}}},
        {"Facets of Table 2",
         {{"570 nm", "studies/mir-2022/facets-570.toml", named_model("thin-film")},
          {"665 nm", "studies/mir-2022/facets-665.toml", named_model("thin-film")}}}};
    for (const Pearl& pearl : kPearls) {
        groups.push_back(
            {pearl.name,
             {{fmt::format("{}, microflake", pearl.name), pearl.file, named_model("microflake")},
              {fmt::format("{}, thin-film", pearl.name), pearl.file, named_model("thin-film")}}});
    }
    for (const Group& group : groups) {
        report::Plot travel{.title = std::string(group.title) + ": colour travel",
                            .x = {.label = "a*"},
                            .y = {.label = "b*"},
                            .equal_scale = true};
        report::Plot lightness{.title = std::string(group.title) + ": lightness",
                               .x = {.label = "aspecular angle, degrees"},
                               .y = {.label = "L*"}};
        for (const auto& [name, file, model] : group.series) {
            add_colour(context, name, file, model, travel, lightness);
        }
        report.plot(travel);
        report.plot(lightness);
    }
    report.paragraph(
        "`special-effect` has the colours of `thin-film` in the mean; its facets scatter about "
        "them. So do the flakes of `nacre` about the colours of `microflake`.");
}

double root_mean_square_error(const io::Image& a, const io::Image& b) {
    return std::sqrt(io::image_difference(a, b, "picture", "converged picture").mean_square_error);
}

/// Noise against samples: each model against its own converged picture.
void add_convergence(MirContext& context) {
    report::Plot plot{
        .title = "Error against samples",
        .caption =
            "Root mean square over linear R, G, B, against the same model's picture with four "
            "times the samples of the last point and other random numbers. 80 nm of TiO₂. The "
            "sparkle of facets and flakes is part of their picture, not of their error: footprints "
            "are the same at every number of samples.",
        .x = {.label = "samples per pixel", .logarithmic = true},
        .y = {.label = "error", .logarithmic = true}};
    const int max_samples = context.settings.quick ? 8 : 256;
    std::vector<bsdf::Model> models = all_four();
    models.push_back(named_model("volume"));
    for (const bsdf::Model& model : models) {
        const std::string name{model.info().name};
        PictureJob job = context.job({}, {}, kPearls[0].file, model);
        job.render.width = job.render.height = std::max(16, context.settings.size / 4);
        job.render.footprint_pixels = 0.25;
        const auto picture = [&](int samples, std::uint64_t seed) {
            job.key = fmt::format("convergence-{}-{}-{}", name, samples, seed);
            job.title = fmt::format("convergence of {}: {} samples", name, samples);
            job.render.samples_per_pixel = samples;
            job.render.seed = context.settings.seed + seed;
            return context.gallery.make(job).image;
        };
        const io::Image converged = picture(4 * max_samples, 1);
        report::Series series{.name = name, .dots = true};
        for (int samples = 1; samples <= max_samples; samples *= 4) {
            series.x.push_back(samples);
            series.y.push_back(root_mean_square_error(picture(samples, 0), converged));
        }
        context.results["convergence"][name] = {{"samples", series.x}, {"rms_error", series.y}};
        plot.series.push_back(series);
    }
    context.report.heading(2, "Error against samples", "error-against-samples");
    context.report.plot(plot);
}

}  // namespace

void add_table_4(MirContext& context) {
    context.report.heading(1, "Table 4 and Figure 4: the models side by side", "table-4");
    context.report.paragraph(
        "Titania on mica, 80 nm (gold) and 110 nm (violet), over black under a clearcoat. "
        "`microflake` and `nacre` take the flakes in their layer, the one their mean, the other "
        "each of them; `thin-film` and `special-effect` take one film of the same thickness on "
        "mica, as microfacets under the same coat.");
    add_pictures(context);
    context.report.paragraph(
        "*What the paper leaves out, and what we chose.* The amount and orientation of the flakes, "
        "their spread, the coat and the ground: those of the recipes `paints/tio2-mica-80.toml` "
        "and `paints/tio2-mica-110.toml`. The microfacet models know neither the far side of the "
        "flake nor other flakes: hence their paler colour and their black where flakes would "
        "scatter on. `nacre` has the colour of `microflake` and, from nearer, the sparkle of "
        "`special-effect`: 10⁸ flakes of 18 µm are some 400 in a pixel here, and few pixels hold "
        "one that outshines them.");
    add_colours(context);
    add_convergence(context);
}

}  // namespace nacre::study
