#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/study/median.h"
#include "nacre/study/mir_parts.h"

// Time and memory of a picture of the ball against the number of flakes on it.

namespace nacre::study {
namespace {

constexpr const char* kPaint = "studies/mir-2022/flakes-570.toml";

/// One way to paint the ball, and what its pictures have cost, round by round.
struct Contender {
    std::string key, name;
    models::Model model;
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
            std::sqrt(contender.count / flakes_on_ball(recipe_of(job), kBallRadiusMm));
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
    std::vector<Contender> all = {{"microflake", "microflake", models::Model::microflake, 0}};
    for (int power :
         context.settings.quick ? std::vector{7, 12} : std::vector{7, 8, 9, 10, 11, 12}) {
        const double count = std::pow(10.0, power);
        all.push_back({fmt::format("1e{}", power),
                       fmt::format("nacre, {} flakes", power_of_ten(count)), models::Model::nacre,
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
    double least = 1e9, most = 0;
    for (const Contender& contender : all) {
        double seconds = 0;
        for (double s : contender.seconds) seconds += s;
        const double ratio = median(contender.ratio);
        const auto [lo, hi] = std::minmax_element(contender.ratio.begin(), contender.ratio.end());
        const bool flakes = contender.count > 0;
        if (flakes) {
            least = std::min(least, ratio);
            most = std::max(most, ratio);
        }
        table.rows.push_back(
            {report::number_cell(flakes ? power_of_ten(contender.count) : "their mean"),
             {fmt::format("`{}`", models::info(contender.model).name)},
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
    context.results["nacre"]["largest_ratio_to_microflake"] = most;
    context.results["nacre"]["dearest_over_cheapest_number"] = most / least;
    report.table(table);
    report.paragraph(fmt::format(
        "The dearest number of flakes takes {:.2f} times as long as their mean (the goal: at "
        "most 1.5), and {:.0f} % longer than the cheapest number (the goal: 20 %). Memory is "
        "that of the whole process: the picture, the scene, the solved paint; none of it grows "
        "with the flakes. Ratios are medians over the rounds, of processor time, which other "
        "programs disturb less.",
        most, 100 * (most / least - 1)));
}

}  // namespace nacre::study
