#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/study/equal_time.h"
#include "apps/study/mir_2022.h"
#include "apps/study/query_cost.h"
#include "nacre/core/estimate.h"
#include "nacre/core/file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/montecarlo/discs/disc.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

// Cost and error of the fourth model, compared with `microflake` and `special-effect`.

namespace nacre::study {

void add_nacre(MirContext& context) {
    report::Report& report = context.report;
    report.heading(1, "The fourth model: cost and error", "nacre");
    report.paragraph(
        "`nacre` is to show the sparkle of `special-effect` at the price of `microflake`. Three "
        "measurements: what a picture costs by the number of flakes, what one query costs by the "
        "number in its footprint, and how far a picture of a given time is from the converged one. "
        "Models that are compared take turns in one run; times that are compared are processor "
        "times, and medians where they are short, so that what else the machine does matters "
        "little.");
    add_cost_by_number(context);
    add_query_costs(context);
    add_equal_time_errors(context);
}

// Table 3: what each model can show, from the models' own description of themselves.

void add_table_3(MirContext& context) {
    context.report.heading(1, "Table 3: what the models can show", "table-3");
    report::Table table{.columns = {"model", "after", "what it is", "goniochromism", "sparkle",
                                    "multiple scattering"}};
    const auto cell = [](bool can) {
        return report::Cell{.text = can ? "yes" : "no", .strong = can};
    };
    for (const bsdf::ModelInfo* model : models::all_models()) {
        const bsdf::Capabilities& can = model->can;
        table.rows.push_back({{"`" + std::string(model->name) + "`"},
                              {std::string(model->source)},
                              {std::string(model->summary)},
                              cell(can.goniochromism),
                              cell(can.sparkle),
                              cell(can.multiple_scattering)});
        context.results["table_3"][std::string(model->name)] = {
            {"goniochromism", can.goniochromism},
            {"sparkle", can.sparkle},
            {"multiple_scattering", can.multiple_scattering},
            {"reference_only", can.reference_only}};
    }
    context.table("table-3", table);
    context.report.paragraph(
        "The rows come from the program's list of its models; a test measures each entry. The two "
        "walks are references: unbiased, without values to ask for, hence slow to converge.");
}

// Time and memory of a picture of the ball against the number of flakes on it.

namespace {

constexpr const char* kPaint = "studies/mir-2022/flakes-570.toml";

/// One way to paint the ball, and the times of its pictures, round by round.
struct Contender {
    std::string key, name;
    bsdf::Model model;
    double count;  ///< flakes on the ball; 0: their mean
    std::vector<double> seconds = {}, processor_s = {}, ratio = {};
    double peak_mib = 0;
};

PictureJob job_of(const MirContext& context, const Contender& contender, int round, int rounds) {
    PictureJob job =
        context.job(fmt::format("nacre-number-{}-{}", contender.key, round),
                    fmt::format("{}, round {} of {}", contender.name, round + 1, rounds), kPaint,
                    contender.model);
    // Flakes of one size on a larger ball: the picture stays the same, its pixels see more.
    if (contender.count > 0) {
        job.scene_scale =
            std::sqrt(contender.count / flakes_on_ball(recipe_of(job), kBallRadius_mm));
    }
    // Together the rounds are the picture at the study's samples.
    const int samples = context.settings.samples;
    job.render.samples_per_pixel = samples / rounds;
    job.render.footprint_pixels = 1 / std::sqrt(static_cast<double>(samples));
    job.render.seed = context.settings.seed + static_cast<std::uint64_t>(round);
    return job;
}

}  // namespace

void add_cost_by_number(MirContext& context) {
    report::Report& report = context.report;
    const int rounds = context.settings.quick ? 2 : 8;
    std::vector<Contender> all = {{"microflake", "microflake", named_model("microflake"), 0}};
    for (int power :
         context.settings.quick ? std::vector{7, 12} : std::vector{7, 8, 9, 10, 11, 12}) {
        const double count = std::pow(10.0, power);
        all.push_back({fmt::format("1e{}", power),
                       fmt::format("nacre, {} flakes", power_of_ten(count)), named_model("nacre"),
                       count});
    }
    for (int round = 0; round < rounds; ++round) {
        for (Contender& contender : all) {
            const Picture picture = context.gallery.make(job_of(context, contender, round, rounds));
            contender.seconds.push_back(picture.render_s);
            contender.processor_s.push_back(picture.processor_s);
            contender.ratio.push_back(picture.processor_s / all[0].processor_s.back());
            contender.peak_mib = std::max(contender.peak_mib, picture.peak_mib);
        }
    }

    report.heading(2, "Pictures by the number of flakes", "number-of-flakes");
    report.paragraph(fmt::format(
        "The ball, painted with flakes of 20 µm as in Figure 3, and made so large, with the way to "
        "the camera, that it carries from 10⁷ flakes (32 mm across) to 10¹² (10 m). {} rounds of "
        "{} samples a pixel, each round all pictures in turn; a sample stands for the {}th part "
        "of a pixel, as in a picture of {} samples.",
        rounds, context.settings.samples / rounds, context.settings.samples,
        context.settings.samples));
    report::Table table{.columns = {"flakes on the ball", "model", "time of all rounds",
                                    "times `microflake`", "from round to round", "peak memory"}};
    double smallest = 1e9, largest = 0;
    for (const Contender& contender : all) {
        double seconds = 0;
        for (double s : contender.seconds) seconds += s;
        const double ratio = median(contender.ratio);
        const auto [lo, hi] = std::minmax_element(contender.ratio.begin(), contender.ratio.end());
        const bool flakes = contender.count > 0;
        if (flakes) {
            smallest = std::min(smallest, ratio);
            largest = std::max(largest, ratio);
        }
        table.rows.push_back(
            {report::number_cell(flakes ? power_of_ten(contender.count) : "their mean"),
             {fmt::format("`{}`", contender.model.info().name)},
             report::number_cell(duration(seconds)),
             report::number_cell(fmt::format("{:.2f}", ratio)),
             report::number_cell(flakes ? fmt::format("{:.2f} to {:.2f}", *lo, *hi) : "—"),
             report::number_cell(fmt::format("{:.1f} MiB", contender.peak_mib))});
        context.results["nacre"]["by_number"][contender.key] = {
            {"seconds", seconds},
            {"ratio_to_microflake", ratio},
            {"ratio_of_rounds", contender.ratio},
            {"peak_mib", contender.peak_mib}};
    }
    context.results["nacre"]["largest_ratio_to_microflake"] = largest;
    context.results["nacre"]["dearest_over_cheapest_number"] = largest / smallest;
    context.table("by-number", table);
    report.paragraph(fmt::format(
        "The dearest number of flakes takes {:.2f} times as long as their mean (the goal: at "
        "most 1.5), and {:.0f} % longer than the cheapest number (the goal: 20 %). Memory is "
        "that of the whole process: the picture, the scene, the solved paint; none of it grows "
        "with the flakes. Ratios are medians over the rounds, of processor time, which other "
        "programs disturb less.",
        largest, 100 * (largest / smallest - 1)));
}

// Time of one query against the number of flakes or facets in its footprint.

namespace {

constexpr double kFacets = 1e9;

/// One curve: a surface, and the kind of query.
struct Curve {
    std::string name;
    const QuerySubject* subject;
    QueryKind kind;
    bool on_patch;
    std::vector<double> median_ns = {};
};

struct Surfaces {
    std::shared_ptr<const bsdf::Bsdf> facets, flakes, mean;
    double flakes_per_mm2;
};

Surfaces make_surfaces(std::uint64_t seed, const Progress& progress) {
    paint::Recipe facets = io::read_recipe(shipped_file("studies/mir-2022/facets-570.toml"));
    facets.microfacet->facets->count = kFacets;
    const paint::Recipe flakes = io::read_recipe(shipped_file("studies/mir-2022/flakes-570.toml"));
    const auto solved = std::make_shared<const solver::SolvedPaint>(
        solver::solve(flakes, spectra::default_wavelengths_nm(), {}, nullptr, progress));
    constexpr double kUmPerMm = 1e3;
    const auto surface = [&](const char* name, const paint::Recipe& recipe) {
        bsdf::Model model = named_model(name);
        model.set_specimen(seed);
        return model.make({recipe, solved}, progress);
    };
    return {surface("special-effect", facets), surface("nacre", flakes),
            surface("microflake", flakes),
            montecarlo::expected_discs(flakes, {kUmPerMm, kUmPerMm})};
}

void measure(std::vector<Curve>& curves, const std::vector<double>& footprints,
             double flakes_per_mm2, int queries, int rounds, const Progress& progress) {
    SharedProgress work(progress, static_cast<double>(footprints.size() * curves.size()) * rounds);
    for (double count : footprints) {
        const auto patches = square_patches(count / flakes_per_mm2, count / kFacets, queries);
        std::vector<std::vector<double>> times(curves.size());
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < curves.size(); ++i) {
                const Curve& curve = curves[i];
                times[i].push_back(
                    curve.subject
                        ->measure(curve.on_patch ? patches : std::vector<bsdf::Patch>{}, curve.kind)
                        .nanoseconds);
                work.add();
                work.throw_if_stopped("the study");
            }
        }
        for (std::size_t i = 0; i < curves.size(); ++i) {
            curves[i].median_ns.push_back(median(times[i]));
        }
    }
}

void add_table(MirContext& context, const std::vector<Curve>& curves,
               const std::vector<double>& footprints) {
    report::Table table{.caption = "Time of one query, ns", .columns = {"in the footprint"}};
    for (const Curve& curve : curves) table.columns.push_back(curve.name);
    table.columns.push_back("ratio: value");
    table.columns.push_back("and sample");
    table.columns.push_back("further");
    for (std::size_t f = 0; f < footprints.size(); ++f) {
        std::vector<report::Cell> row = {report::number_cell(fmt::format("{:g}", footprints[f]))};
        for (const Curve& curve : curves) {
            row.push_back(report::number_cell(fmt::format("{:.0f}", curve.median_ns[f])));
        }
        const auto ratio = [&](int facets, int flakes) {
            row.push_back(report::number_cell(
                fmt::format("{:.1f}", curves[facets].median_ns[f] / curves[flakes].median_ns[f])));
        };
        ratio(0, 2);
        ratio(1, 3);
        ratio(0, 4);
        table.rows.push_back(std::move(row));
    }
    context.table("query-by-footprint", table);
}

}  // namespace

void add_query_costs(MirContext& context) {
    report::Report& report = context.report;
    const bool quick = context.settings.quick;
    const std::vector<double> footprints =
        quick ? std::vector<double>{0.05, 5, 1e4}
              : std::vector<double>{0.05, 0.2, 1, 5, 20, 100, 1e3, 3e3, 1e4, 1e5, 1e6};
    const int queries = quick ? 256 : 4096, rounds = quick ? 3 : 15;
    std::vector<Curve> curves;
    context.gallery.stage()("queries by their footprint", [&](const Progress& progress) {
        const Surfaces surfaces = make_surfaces(context.settings.seed, progress);
        const QuerySubject facets(*surfaces.facets, queries), flakes(*surfaces.flakes, queries),
            mean(*surfaces.mean, queries);
        curves = {{"facets: value", &facets, QueryKind::value, true},
                  {"and sample", &facets, QueryKind::value_and_sample, true},
                  {"flakes: value", &flakes, QueryKind::value, true},
                  {"and sample", &flakes, QueryKind::value_and_sample, true},
                  {"further", &flakes, QueryKind::repeated_value, true},
                  {"their mean: value", &mean, QueryKind::value, false},
                  {"and sample", &mean, QueryKind::value_and_sample, false}};
        measure(curves, footprints, surfaces.flakes_per_mm2, queries, rounds, progress);
    });

    report.heading(2, "A query by its footprint", "query");
    report.paragraph(fmt::format(
        "What a renderer asks a surface: its value (with the density of sampling) for light from "
        "anywhere above, towards where its mean sends it; and the same with a sample to go on, "
        "which is one vertex of a path. {} facets with the paper's `alpha = 0.07` and cone of 3°, "
        "against flakes of 20 µm with the same `alpha`; {} patches anywhere on the ball, each new; "
        "eight wavelengths; processor time of one core; medians of {} rounds. `microflake` is "
        "what `nacre` is over all patches: it knows no footprint.",
        power_of_ten(kFacets), queries, rounds));
    add_table(context, curves, footprints);
    report::Plot plot{.title = "Time of a query against its footprint",
                      .x = {.label = "flakes or facets in the footprint", .logarithmic = true},
                      .y = {.label = "ns", .logarithmic = true}};
    const char* names[] = {"special-effect, value",
                           "special-effect, value and sample",
                           "nacre, value",
                           "nacre, value and sample",
                           "nacre, further value",
                           "microflake, value",
                           "microflake, value and sample"};
    for (std::size_t i = 0; i < curves.size(); ++i) {
        plot.series.push_back(
            {.name = names[i], .x = footprints, .y = curves[i].median_ns, .dots = true});
        context.results["nacre"]["query_ns"][names[i]] = curves[i].median_ns;
    }
    context.results["nacre"]["query_ns"]["footprints"] = footprints;
    report.plot(plot);
    report.paragraph(
        "The goal: 20 times faster at equal footprints. With 10⁹ facets on the ball a pixel of "
        "512 holds some 3000 of them, and a sample's patch, the 1024th part of that, three. Of "
        "whole pixels facets have to be counted by the thousand, and there `nacre` gains most. "
        "With few of them neither has much to count: what is left is finding the patch's flakes "
        "and what does not depend on flakes: Fresnel terms, layers and multiple scattering, which "
        "`special-effect` does not have.");
}

// Error against a converged picture by time: single flakes against single facets.

namespace {

constexpr int kFullSize = 512;  // pixels: cases are stated for pictures of this size

struct Case {
    const char* key;
    const char* scene;
    const char* light;  ///< in words
    double area_mm2;    ///< painted
    double count;       ///< flakes or facets on it, at 512 pixels; at other sizes as many a pixel
    int patches;        ///< a pixel's side over that of the patch over which a sample averages
};
constexpr double kBallMm2 = 4 * std::numbers::pi * kBallRadius_mm * kBallRadius_mm;
constexpr Case kCases[] = {{"ball-1e8-32", "sphere", "ball, soft boxes", kBallMm2, 1e8, 32},
                           {"ball-1e9-32", "sphere", "ball, soft boxes", kBallMm2, 1e9, 32},
                           {"ball-1e9-4", "sphere", "ball, soft boxes", kBallMm2, 1e9, 4},
                           {"panel-1e8-4", "panel-sun", "panel, sun and sky", 150 * 100, 1e8, 4},
                           {"panel-1e8-32", "panel-sun", "panel, sun and sky", 150 * 100, 1e8, 32}};
// In slopes inside the coat, the lobe of a flake has the effective area  1 / Int (e K)^2 = 5/9 pi (r/e)^2,
// r/e = 1.26 lambda' / (2 d)  (docs/nacre-model.md); in the cone of gamma = 3 deg those facets
// reflect whose normals lie within gamma / 2. At this mean diameter, and 550 nm, the two are equal:
// as many flakes reflect as facets, and the pictures sparkle alike.
constexpr double kLikeTheCone_um = 6.6;

/// The two models that are compared, by index.
bsdf::Model model_number(int m) { return named_model(m == 0 ? "special-effect" : "nacre"); }

PictureJob job_of(const MirContext& context, const Case& c, const bsdf::Model& model) {
    const bool flakes = model.info().ingredients == bsdf::Ingredients::layers;
    PictureJob job = context.job(
        {}, {}, flakes ? "studies/mir-2022/flakes-570.toml" : "studies/mir-2022/facets-570.toml",
        model);
    job.scene = c.scene;
    const int size = std::max(32, context.settings.size / 4);
    job.render.width = job.render.height = size;
    job.render.footprint_pixels = 1.0 / c.patches;
    const double scale = static_cast<double>(size) / kFullSize;
    const double count = std::round(c.count * scale * scale);
    if (flakes) {
        job.flake_scale = kLikeTheCone_um / recipe_of(job).layers[0].flakes[0].diameter_um;
        const double on_scene =
            flakes_on_ball(recipe_of(job), kBallRadius_mm) * c.area_mm2 / kBallMm2;
        job.scene_scale = std::sqrt(count / on_scene);
    } else {
        job.facet_count = count;
    }
    return job;
}

/// Samples a pixel of the last point of a curve.
int max_samples(const MirContext& context) { return context.settings.quick ? 16 : 64; }

/// The results for one model.
struct Outcome {
    ErrorCurve relative, absolute;
    double us_per_sample = 0;
    std::string max_png, converged_png;  ///< the picture of most samples, and the converged one
};

/// Both models in turn, by growing sample counts.
std::array<Outcome, 2> measure(const MirContext& context, const Case& c) {
    const int max_count = max_samples(context), converged_at = 16 * max_count;
    std::array<Outcome, 2> out;
    std::array<std::vector<double>, 2> samples, seconds_per_sample;
    const auto picture = [&](int m, int count, std::uint64_t seed) {
        const std::string name{model_number(m).info().name};
        PictureJob job = job_of(context, c, model_number(m));
        job.key = fmt::format("nacre-error-{}-{}-{}-{}", c.key, name, count, seed);
        job.title = fmt::format("error of {} ({}): {} samples", name, c.key, count);
        job.render.samples_per_pixel = count;
        job.render.seed = context.settings.seed + seed;
        Picture made = context.gallery.make(job);
        seconds_per_sample[m].push_back(made.processor_s / count);
        return made;
    };
    std::array<Picture, 2> converged;
    for (int m : {0, 1}) {
        converged[m] = picture(m, converged_at, 1);
        out[m].converged_png = converged[m].png;
    }
    for (int count = 1; count <= max_count; count *= 4) {
        for (int m : {0, 1}) {
            const Picture made = picture(m, count, 0);
            samples[m].push_back(count);
            out[m].relative.error.push_back(relative_square_error(made.image, converged[m].image));
            out[m].absolute.error.push_back(
                square_error_over_square_mean(made.image, converged[m].image));
            out[m].max_png = made.png;
        }
    }
    for (int m : {0, 1}) {
        const double each = median(seconds_per_sample[m]);
        const int size = job_of(context, c, model_number(m)).render.width;
        out[m].us_per_sample = 1e6 * each / size / size;
        for (double count : samples[m]) out[m].relative.seconds.push_back(count * each);
        out[m].absolute.seconds = out[m].relative.seconds;
    }
    return out;
}

std::string times(std::optional<double> ratio) {
    return ratio ? fmt::format("{:.{}f} ×", *ratio, *ratio < 10 ? 1 : 0) : "no time in common";
}

}  // namespace

void add_equal_time_errors(MirContext& context) {
    report::Report& report = context.report;
    report.heading(2, "Error at equal time", "equal-time");
    report.paragraph(
        "Each model against its own converged picture: the same flakes or facets, seen through "
        "the same patches, with 16 times the samples of the last point and other random numbers. "
        "Facets are those of Table 2, which answer within a cone of 3°. Flakes are so small, 6.6 "
        "µm, that as many of them answer, and there are as many in a pixel: the two sparkle "
        "alike. *Relative* error: mean square of the difference over the converged value plus "
        "0.01, so that dark pixels count as much as bright ones. *Absolute*: mean square of "
        "the difference over the square of the picture's mean. Ratios are geometric means over "
        "the times that both models reach. The light that `nacre` mirrors at the coat and "
        "scatters many times is smooth and bright; it is part of its picture and of what its "
        "errors are divided by.");
    report::Table table{.columns = {"scene", "flakes or facets", "in a sample's patch",
                                    "time a sample", "relative error", "absolute error"}};
    std::vector<report::Plot> plots;
    std::vector<report::Picture> pictures;
    for (const Case& c : kCases) {
        if (context.settings.quick && &c != kCases && &c != std::end(kCases) - 1) continue;
        const std::array<Outcome, 2> out = measure(context, c);
        const auto relative = equal_time_ratio(out[0].relative, out[1].relative),
                   absolute = equal_time_ratio(out[0].absolute, out[1].absolute);
        const std::string patch = fmt::format("1/{} of a pixel's side", c.patches);
        table.rows.push_back(
            {{c.light},
             report::number_cell(power_of_ten(c.count)),
             {patch},
             report::number_cell(fmt::format("{} / {} µs", number(out[0].us_per_sample),
                                             number(out[1].us_per_sample))),
             report::number_cell(times(relative)),
             report::number_cell(times(absolute))});
        report::Plot plot{.title = fmt::format("Error against time: {}, {}, patches of {}", c.light,
                                               power_of_ten(c.count), patch),
                          .x = {.label = "seconds of processor time", .logarithmic = true},
                          .y = {.label = "error", .logarithmic = true}};
        nlohmann::json& results = context.results["nacre"]["equal_time"][c.key];
        for (int m : {0, 1}) {
            const std::string name{model_number(m).info().name};
            plot.series.push_back({.name = name + ", relative",
                                   .x = out[m].relative.seconds,
                                   .y = out[m].relative.error,
                                   .dots = true});
            plot.series.push_back({.name = name + ", absolute",
                                   .x = out[m].absolute.seconds,
                                   .y = out[m].absolute.error,
                                   .dots = true,
                                   .dashed = true});
            results[name] = {{"seconds", out[m].relative.seconds},
                             {"relative_square_error", out[m].relative.error},
                             {"square_error_over_square_mean", out[m].absolute.error},
                             {"us_per_sample", out[m].us_per_sample}};
            if (&c == kCases) {
                pictures.push_back(
                    {fmt::format("`{}`, {} samples", name, max_samples(context)), out[m].max_png});
                pictures.push_back({fmt::format("`{}`, converged", name), out[m].converged_png});
            }
        }
        if (relative) results["relative_ratio"] = *relative;
        if (absolute) results["absolute_ratio"] = *absolute;
        plots.push_back(std::move(plot));
    }
    context.table("equal-time", table);
    report.pictures(
        pictures, 4,
        fmt::format("{} flakes or facets on the ball, seen through patches of 1/{} of a "
                    "pixel, small pictures.",
                    power_of_ten(kCases[0].count), kCases[0].patches));
    for (const report::Plot& plot : plots) report.plot(plot);
    report.paragraph(
        "With few facets in a patch, `special-effect` draws directions from all normals, and most "
        "find no facet; the few that do carry the light of all. `nacre` draws from the flakes that "
        "are there. With many in a patch the two draw alike, and what is left is the time.");
}

}  // namespace nacre::study
