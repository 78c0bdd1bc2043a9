#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nacre/study/equal_time.h"
#include "nacre/study/median.h"
#include "nacre/study/mir_parts.h"

// Error against a converged picture by time: single flakes against single facets.

namespace nacre::study {
namespace {

constexpr int kFullSize = 512;  // pixels: cases are told as they look there

struct Case {
    const char* key;
    const char* scene;
    const char* light;  ///< in words
    double area_mm2;    ///< painted
    double count;       ///< flakes or facets on it, at 512 pixels; at other sizes as many a pixel
    int patches;        ///< a pixel's side over that of the patch that a sample stands for
};
constexpr double kBallMm2 = 4 * std::numbers::pi * kBallRadiusMm * kBallRadiusMm;
constexpr Case kCases[] = {{"ball-1e8-32", "sphere", "ball, soft boxes", kBallMm2, 1e8, 32},
                           {"ball-1e9-32", "sphere", "ball, soft boxes", kBallMm2, 1e9, 32},
                           {"ball-1e9-4", "sphere", "ball, soft boxes", kBallMm2, 1e9, 4},
                           {"panel-1e8-4", "panel-sun", "panel, sun and sky", 150 * 100, 1e8, 4},
                           {"panel-1e8-32", "panel-sun", "panel, sun and sky", 150 * 100, 1e8, 32}};
// In slopes inside the coat, the lobe of a flake has the effective area  1 / Int K^2 = 5/9 pi w^2,
// w = 1.26 lambda' / (2 d)  (docs/nacre-model.md); the cone of gamma = 3 deg lets normals within
// gamma / 2 answer. At this mean diameter, and 550 nm, the two are equal: as many flakes answer as
// facets, and the pictures sparkle alike.
constexpr double kLikeTheConeUm = 6.6;

constexpr models::Model kModels[] = {models::Model::special_effect, models::Model::nacre};

PictureJob job_of(const MirContext& context, const Case& c, models::Model model) {
    const bool flakes = model == models::Model::nacre;
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
        job.flake_scale = kLikeTheConeUm / recipe_of(job).layers[0].flakes[0].diameter_um;
        const double on_scene =
            flakes_on_ball(recipe_of(job), kBallRadiusMm) * c.area_mm2 / kBallMm2;
        job.scene_scale = std::sqrt(count / on_scene);
    } else {
        job.facet_count = count;
    }
    return job;
}

/// Of the last point of a curve.
int most_samples(const MirContext& context) { return context.settings.quick ? 16 : 64; }

/// What came out for one model.
struct Outcome {
    ErrorCurve relative, absolute;
    double us_per_sample = 0;
    std::string most_png, converged_png;  ///< the picture of most samples, and the converged one
};

/// Both models in turn, by growing sample counts.
std::array<Outcome, 2> measure(const MirContext& context, const Case& c) {
    const int most = most_samples(context), converged_at = 16 * most;
    std::array<Outcome, 2> out;
    std::array<std::vector<double>, 2> samples, seconds_per_sample;
    const auto picture = [&](int m, int count, std::uint64_t seed) {
        const std::string name{models::info(kModels[m]).name};
        PictureJob job = job_of(context, c, kModels[m]);
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
    for (int count = 1; count <= most; count *= 4) {
        for (int m : {0, 1}) {
            const Picture made = picture(m, count, 0);
            samples[m].push_back(count);
            out[m].relative.error.push_back(relative_square_error(made.image, converged[m].image));
            out[m].absolute.error.push_back(
                square_error_over_square_mean(made.image, converged[m].image));
            out[m].most_png = made.png;
        }
    }
    for (int m : {0, 1}) {
        const double each = median(seconds_per_sample[m]);
        const int size = job_of(context, c, kModels[m]).render.width;
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
            const std::string name{models::info(kModels[m]).name};
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
                pictures.push_back({fmt::format("`{}`, {} samples", name, most_samples(context)),
                                    out[m].most_png});
                pictures.push_back({fmt::format("`{}`, converged", name), out[m].converged_png});
            }
        }
        if (relative) results["relative_ratio"] = *relative;
        if (absolute) results["absolute_ratio"] = *absolute;
        plots.push_back(std::move(plot));
    }
    report.table(table);
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
