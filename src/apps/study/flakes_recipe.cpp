#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/study/flakes.h"
#include "apps/study/mir_2022.h"
#include "nacre/spectra/lab.h"

// One recipe: pictures, contrast against footprint, histogram, colour.

namespace nacre::study {
namespace {

constexpr Way kCompared[] = {Way::discs, Way::hashed};

/// Pixels a side, and samples a pixel: more for discs, whose paths meet the lamp by chance.
struct Effort {
    int pixels, disc_samples, hashed_samples;
};
constexpr Effort kContrast{64, 512, 128}, kPicture{96, 2048, 256}, kCloseUp{128, 1024, 256};
constexpr Effort kQuick{16, 16, 8};

struct Taken {
    Pixels pixels;
    Estimate mean;
};

class Look {
 public:
    Look(FlakesContext& context, FlakePaint& paint) : context_(context), paint_(paint) {}

    /// A picture whose pixels hold `flakes_per_pixel` flakes on average.
    Pixels take(Way way, double flakes_per_pixel, const std::string& what, Effort effort,
                std::uint64_t noise) const {
        if (context_.settings.quick) effort = kQuick;
        const double foreshortened = std::cos(kEye_deg * std::numbers::pi / 180);
        const double pixel_mm =
            std::sqrt(flakes_per_pixel * foreshortened / paint_.flakes_per_mm2());
        const double side = panel_side_mm(pixel_mm, effort.pixels);
        CloseUpJob job;
        job.key =
            fmt::format("{}-{}-{}-{}-{}", paint_.key(), what, flakes_per_pixel, name(way), noise);
        job.title = fmt::format("{}, {} flakes a pixel, {}", paint_.recipe().name, flakes_per_pixel,
                                name(way));
        job.surface = paint_.identity(way, side);
        job.pixel_mm = pixel_mm;
        job.pixels = effort.pixels;
        const bool traced = way == Way::discs || way == Way::mirrors;
        job.samples = traced ? effort.disc_samples : effort.hashed_samples;
        job.seed = context_.settings.seed + noise;
        return context_.close_ups.take(
            job, [&](const Progress& progress) { return paint_.surface(way, side, progress); });
    }

 private:
    FlakesContext& context_;
    FlakePaint& paint_;
};

std::string of_name(Way way) {
    switch (way) {
        case Way::discs:
            return "explicit discs";
        case Way::no_hot_spot:
            return "nacre without its hot spot";
        default:
            return "nacre, hashed flakes";
    }
}

void add_pictures(FlakesContext& context, const FlakePaint& paint, const Look& look) {
    std::vector<report::Picture> pictures;
    for (const double flakes_per_pixel : {1 / 64.0, 1.0}) {
        const bool close = flakes_per_pixel < 1;
        double exposure = 0;
        for (Way way : kCompared) {
            const Pixels p = look.take(way, flakes_per_pixel, close ? "close-up" : "picture",
                                       close ? kCloseUp : kPicture, 0);
            if (way == Way::discs) exposure = std::max(1e-12, mean_luminance(p, p).value);
            const std::string key =
                fmt::format("{}-{}-{}", paint.key(), close ? "close-up" : "picture", name(way));
            pictures.push_back(
                {.caption = fmt::format("{}, {}", of_name(way),
                                        close ? "64 pixels a flake" : "one flake a pixel"),
                 .png_bytes = context.close_ups.png(p, exposure, key)});
        }
    }
    context.report.pictures(pictures, 4,
                            "Lamp and eye near each other's mirror direction, under the clearcoat; "
                            "all shown with the exposure of the discs.");
}

std::string with_error(const Estimate& m) {
    return fmt::format("{} ± {}", number(m.value), number(m.standard_error, 1));
}

/// The results of one way over those of the discs, over all footprints.
struct Ratios {
    double log_sum = 0, worst = 1, mean = 0, mean_variance = 0, weights = 0;
    int counted = 0;

    void add(double flakes_per_pixel, const Estimate (&contrast)[2], const Estimate (&means)[2]) {
        if (contrast[0].value > 0 && contrast[1].value > 0) {
            const double ratio = contrast[1].value / contrast[0].value;
            log_sum += std::log(ratio);
            ++counted;
            if (std::abs(std::log(ratio)) > std::abs(std::log(worst))) worst = ratio;
        }
        // The mean over footprints is weighted by their area.
        if (!(means[0].value > 0 && means[1].value > 0)) return;
        const double ratio = means[1].value / means[0].value;
        const double error = ratio * std::hypot(means[0].standard_error / means[0].value,
                                                means[1].standard_error / means[1].value);
        mean += flakes_per_pixel * ratio;
        mean_variance += std::pow(flakes_per_pixel * error, 2);
        weights += flakes_per_pixel;
    }
    double contrast() const { return counted > 0 ? std::exp(log_sum / counted) : 0; }
    Estimate of_means() const {
        if (weights == 0) return {};
        return {mean / weights, std::sqrt(mean_variance) / weights};
    }
};

/// Contrast against footprint. Adds to the verdict.
void add_contrast(FlakesContext& context, const FlakePaint& paint, const Look& look,
                  FlakesVerdict& verdict) {
    constexpr Way kWays[] = {Way::discs, Way::hashed, Way::no_hot_spot};
    std::vector<double> footprints{0.25, 1, 4, 16, 64, 256};
    if (context.settings.quick) footprints = {1, 4};
    report::Plot plot{
        .title = "Contrast against footprint",
        .caption =
            "Standard deviation of the pixels' luminance over its mean. Bars: one standard "
            "error.",
        .x = {.label = "flakes in the pixel's area, on average", .logarithmic = true},
        .y = {.label = "contrast", .logarithmic = true}};
    report::Table table{.columns = {"flakes a pixel", "contrast, discs", "hashed",
                                    "without hot spot", "mean, discs", "hashed", "without hot spot",
                                    "smooth"}};
    report::Series series[3];
    nlohmann::json& results = context.results["recipes"][paint.key()]["contrast"];
    Ratios hashed, no_hot_spot;
    for (double n : footprints) {
        Estimate c[3], mean[3];
        for (int i = 0; i < 3; ++i) {
            const Pixels a = look.take(kWays[i], n, "contrast", kContrast, 0);
            const Pixels b = look.take(kWays[i], n, "contrast", kContrast, 1);
            c[i] = contrast(a, b);
            mean[i] = mean_luminance(a, b);
            series[i].x.push_back(n);
            series[i].y.push_back(c[i].value);
            series[i].y_error.push_back(c[i].standard_error);
            results.push_back({{"flakes_per_pixel", n},
                               {"way", name(kWays[i])},
                               {"contrast", c[i].value},
                               {"contrast_error", c[i].standard_error},
                               {"mean", mean[i].value},
                               {"mean_error", mean[i].standard_error}});
        }
        const Pixels s = look.take(Way::smooth, n, "contrast", {kContrast.pixels, 0, 32}, 0);
        hashed.add(n, {c[0], c[1]}, {mean[0], mean[1]});
        no_hot_spot.add(n, {c[0], c[2]}, {mean[0], mean[2]});
        table.rows.push_back({report::number_cell(number(n))});
        for (const Estimate& m : c) table.rows.back().push_back(report::number_cell(with_error(m)));
        for (const Estimate& m : mean)
            table.rows.back().push_back(report::number_cell(with_error(m)));
        table.rows.back().push_back(report::number_cell(number(mean_luminance(s, s).value)));
    }
    verdict.contrast_ratio = hashed.contrast();
    verdict.worst_contrast_ratio = hashed.worst;
    verdict.mean_ratio = hashed.of_means();
    verdict.contrast_ratio_no_hot_spot = no_hot_spot.contrast();
    verdict.mean_ratio_no_hot_spot = no_hot_spot.of_means();
    for (int i = 0; i < 3; ++i) {
        series[i].name = of_name(kWays[i]);
        series[i].dots = true;
        plot.series.push_back(series[i]);
    }
    context.report.plot(plot);
    context.report.table(table);
}

void add_histogram_and_colour(FlakesContext& context, const FlakePaint& paint, const Look& look,
                              FlakesVerdict& verdict) {
    report::Plot bars{.title = "Luminance of the pixels, one flake a pixel",
                      .x = {.label = "luminance over the mean", .logarithmic = true},
                      .y = {.label = "share of the pixels", .lo = 0}};
    report::Plot brighter{.title = "Pixels brighter than so much, one flake a pixel",
                          .x = {.label = "luminance over the mean", .logarithmic = true},
                          .y = {.label = "share of the pixels", .logarithmic = true, .lo = 1e-4}};
    report::Plot colours{.title = "Colours of the pixels, one flake a pixel",
                         .caption =
                             "CIELAB, with the mean luminance of each picture at 0.3 of "
                             "white; the first 500 pixels.",
                         .x = {.label = "a*"},
                         .y = {.label = "b*"},
                         .equal_scale = true};
    ColourSpread spread[2];
    nlohmann::json& results = context.results["recipes"][paint.key()];
    for (int i = 0; i < 2; ++i) {
        const Pixels p = look.take(kCompared[i], 1, "picture", kPicture, 0);
        const Histogram h = histogram(p);
        bars.series.push_back(
            {.name = of_name(kCompared[i]), .x = h.centre, .y = h.fraction, .dots = true});
        report::Series above{.name = of_name(kCompared[i]), .x = {}, .y = {}};
        double fraction = 0;
        for (std::size_t k = h.fraction.size(); k-- > 0;) {
            fraction += h.fraction[k];
            // Steps are a third of an octave; this one begins a sixth below its middle.
            above.x.push_back(h.centre[k] * std::exp2(-1.0 / 6));
            above.y.push_back(fraction);
        }
        brighter.series.push_back(above);
        spread[i] = colour_spread(p, std::max(1e-12, mean_luminance(p, p).value));
        report::Series dots{.name = of_name(kCompared[i]), .line = false, .dots = true};
        for (std::size_t k = 0; k < std::min<std::size_t>(500, spread[i].ab.size()); ++k) {
            dots.x.push_back(spread[i].ab[k][0]);
            dots.y.push_back(spread[i].ab[k][1]);
        }
        colours.series.push_back(dots);
        results["histogram"][name(kCompared[i])] = h.fraction;
        results["colour"][name(kCompared[i])] = {{"mean_lab", spread[i].mean_lab},
                                                 {"a_deviation", spread[i].a_deviation},
                                                 {"b_deviation", spread[i].b_deviation}};
    }
    verdict.mean_delta_e = spectra::delta_e_2000(spread[0].mean_lab, spread[1].mean_lab);
    verdict.a_ratio = spread[1].a_deviation / std::max(1e-12, spread[0].a_deviation);
    verdict.b_ratio = spread[1].b_deviation / std::max(1e-12, spread[0].b_deviation);
    context.report.plot(bars);
    context.report.plot(brighter);
    context.report.plot(colours);
    report::Table table{
        .columns = {"", "mean L*", "mean a*", "mean b*", "deviation of a*", "deviation of b*"}};
    for (int i = 0; i < 2; ++i) {
        const auto& s = spread[i];
        table.rows.push_back({{of_name(kCompared[i])},
                              report::number_cell(number(s.mean_lab[0])),
                              report::number_cell(number(s.mean_lab[1])),
                              report::number_cell(number(s.mean_lab[2])),
                              report::number_cell(number(s.a_deviation)),
                              report::number_cell(number(s.b_deviation))});
    }
    context.report.table(table);
}

/// The part of the difference of the means that is due to diffraction: explicit flakes without it
/// reflect exactly by the distribution of normals of the recipe.
void add_diffraction(FlakesContext& context, const FlakePaint& paint, const Look& look,
                     FlakesVerdict& verdict) {
    constexpr double kFlakes = 64;
    const Effort effort{kContrast.pixels, kContrast.disc_samples, kContrast.hashed_samples};
    Estimate mean[3];
    for (int i = 0; i < 3; ++i) {
        const Way way = std::array{Way::discs, Way::mirrors, Way::hashed}[i];
        mean[i] = mean_luminance(look.take(way, kFlakes, "contrast", effort, 0),
                                 look.take(way, kFlakes, "contrast", effort, 1));
    }
    verdict.mean_ratio_mirrors = mean[2].value / mean[1].value;
    context.results["recipes"][paint.key()]["mean_of_mirrors"] = mean[1].value;
    context.report.paragraph(fmt::format(
        "Without diffraction the discs have a mean luminance of {} ± {} instead of {} ± {}, the "
        "hashed flakes {}.",
        number(mean[1].value), number(mean[1].standard_error, 1), number(mean[0].value),
        number(mean[0].standard_error, 1), number(mean[2].value)));
}

}  // namespace

std::string flake_count(double per_mm2) {
    return per_mm2 < 1000 ? number(per_mm2) : fmt::format("{:.0f}", per_mm2);
}

FlakesVerdict add_flake_paint(FlakesContext& context, FlakePaint& paint) {
    FlakesVerdict verdict;
    verdict.name = paint.recipe().name;
    verdict.depth = paint.depth();
    verdict.diameter_um = paint.species().diameter_um;
    verdict.flakes_per_mm2 = paint.flakes_per_mm2();
    context.report.heading(1, verdict.name, paint.key());
    context.report.definitions(
        {{"Flakes",
          fmt::format("{}, diameter {} ± {} um, Beckmann roughness {}", paint.species().name,
                      paint.species().diameter_um, paint.species().diameter_spread_um,
                      paint.species().orientation.beckmann_alpha)},
         {"Layer", fmt::format("{} um; a vertical line meets {} flakes on average; {} flakes a mm²",
                               paint.recipe().layers[0].thickness_um, number(verdict.depth),
                               flake_count(verdict.flakes_per_mm2))}});
    const Look look(context, paint);
    add_pictures(context, paint, look);
    add_contrast(context, paint, look, verdict);
    add_diffraction(context, paint, look, verdict);
    add_histogram_and_colour(context, paint, look, verdict);
    context.results["recipes"][paint.key()]["verdict"] = {
        {"depth", verdict.depth},
        {"diameter_um", verdict.diameter_um},
        {"flakes_per_mm2", verdict.flakes_per_mm2},
        {"mean_hashed_over_discs", verdict.mean_ratio.value},
        {"mean_hashed_over_discs_error", verdict.mean_ratio.standard_error},
        {"mean_hashed_over_mirrors", verdict.mean_ratio_mirrors},
        {"contrast_hashed_over_discs", verdict.contrast_ratio},
        {"contrast_hashed_over_discs_worst", verdict.worst_contrast_ratio},
        {"mean_no_hot_spot_over_discs", verdict.mean_ratio_no_hot_spot.value},
        {"contrast_no_hot_spot_over_discs", verdict.contrast_ratio_no_hot_spot},
        {"delta_e_of_means", verdict.mean_delta_e}};
    return verdict;
}

}  // namespace nacre::study
