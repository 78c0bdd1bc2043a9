#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/study/mir_2022.h"
#include "nacre/io/recipe_file.h"
#include "nacre/spectra/rgb.h"

// Table 2 and Figure 3: the cost of facets and flakes by their number.

namespace nacre::study {
namespace {

struct ParameterSet {
    const char* key;
    const char* name;
    const char* facets;
    const char* flakes;  ///< of the same hue
    printed::FacetSet paper;
};
constexpr ParameterSet kSets[] = {
    {"570", "first order at 570 nm", "studies/mir-2022/facets-570.toml",
     "studies/mir-2022/flakes-570.toml", printed::kTable2[0]},
    {"665", "first order at 665 nm", "studies/mir-2022/facets-665.toml",
     "studies/mir-2022/flakes-665.toml", printed::kTable2[1]}};

std::vector<float> luminance(const io::Image& image) {
    const std::vector<float> rgb = io::interleaved_rgb(image, "picture");
    std::vector<float> y(image.pixel_count());
    for (std::size_t i = 0; i < y.size(); ++i) {
        y[i] = spectra::rec709_luminance(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
    }
    return y;
}

/// Root mean square of the relative deviation from the smooth picture, over the pixels that the
/// ball fills and that are not dark in it.
double sparkle_contrast(const io::Image& picture, const io::Image& smooth) {
    const std::vector<float> a = luminance(picture), b = luminance(smooth);
    const io::Channel* alpha = smooth.find("A");
    double mean = 0;
    std::size_t inside = 0;
    const auto is_inside = [&](std::size_t i) { return alpha && alpha->pixels[i] >= 1; };
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (!is_inside(i)) continue;
        mean += b[i];
        ++inside;
    }
    mean /= std::max<std::size_t>(inside, 1);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (!is_inside(i) || b[i] < 0.5 * mean) continue;
        const double deviation = a[i] / b[i] - 1;
        sum += deviation * deviation;
        ++count;
    }
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
}

void add_parameters(MirContext& context) {
    report::Table table{.caption = "Parameters",
                        .columns = {"set", "film index", "film thickness", "base", "alpha", "cone",
                                    "thickness spread"}};
    for (const ParameterSet& set : kSets) {
        const paint::Microfacet m =
            *io::read_recipe(context.job("", "", set.facets, named_model("special-effect")).paint)
                 .microfacet;
        table.rows.push_back(
            {{set.name},
             report::number_cell(number(m.film_ior)),
             report::number_cell(fmt::format("{:.1f} nm", m.film_thickness_nm)),
             report::number_cell(fmt::format("{} + {}i", m.base_ior, m.base_extinction)),
             report::number_cell(number(m.alpha)),
             report::number_cell(fmt::format("{}°", m.facets->cone_deg)),
             report::number_cell(fmt::format("{} nm", m.facets->thickness_spread_nm))});
    }
    context.table("facets", table);
}

/// Time of a small picture against the number of facets or flakes, in turn.
void add_cost_curve(MirContext& context) {
    report::Series facets{.name = "special-effect", .dots = true};
    report::Series flakes{.name = "nacre", .dots = true};
    const int last = context.settings.quick ? 8 : 12;
    for (int power = 5; power <= last; ++power) {
        const double count = std::pow(10.0, power);
        for (const bool is_flakes : {false, true}) {
            PictureJob job = context.job(
                fmt::format("cost-{}-1e{}", is_flakes ? "flakes" : "facets", power),
                fmt::format("cost of {} {}", power_of_ten(count), is_flakes ? "flakes" : "facets"),
                is_flakes ? kSets[0].flakes : kSets[0].facets,
                named_model(is_flakes ? "nacre" : "special-effect"));
            if (is_flakes) {
                job.scene_scale = std::sqrt(count / flakes_on_ball(recipe_of(job), kBallRadius_mm));
            } else {
                job.facet_count = count;
            }
            job.render.width = job.render.height = std::max(16, context.settings.size / 4);
            // Footprints as in the full picture.
            job.render.footprint_pixels =
                1 / (4 * std::sqrt(static_cast<double>(context.settings.samples)));
            job.render.samples_per_pixel = std::min(context.settings.samples, 32);
            const double samples = static_cast<double>(job.render.samples_per_pixel) *
                                   job.render.width * job.render.height;
            const double per_sample_us = 1e6 * context.gallery.make(job).processor_s / samples;
            report::Series& series = is_flakes ? flakes : facets;
            series.x.push_back(count);
            series.y.push_back(per_sample_us);
            context
                .results["table_2"][is_flakes ? "cost_us_per_sample_nacre" : "cost_us_per_sample"]
                        [fmt::format("1e{}", power)] = per_sample_us;
        }
    }
    context.report.plot({.title = "Time a sample takes against the number of facets or flakes",
                         .caption =
                             "Processor time over samples; a sample is a whole path. "
                             "Footprints are those of the full picture. Flakes are of 20 µm, on a "
                             "ball of the size that holds so many.",
                         .x = {.label = "facets or flakes on the ball", .logarithmic = true},
                         .y = {.label = "µs per sample", .lo = 0},
                         .series = {facets, flakes}});
}

/// Flakes whose diameter is scaled so that `count` of them lie on the ball, at the same coverage.
PictureJob flakes_job(const MirContext& context, const ParameterSet& set, double count) {
    PictureJob job = context.job(
        fmt::format("table-2-{}-nacre-{}", set.key, fmt::format("1e{:.0f}", std::log10(count))),
        fmt::format("{}: {} flakes", set.name, power_of_ten(count)), set.flakes,
        named_model("nacre"));
    job.flake_scale = std::sqrt(flakes_on_ball(recipe_of(job), kBallRadius_mm) / count);
    return job;
}

/// As printed; a dash for a number of facets that the paper does not have.
std::string paper_hours(const ParameterSet& set, double count) {
    const auto& counts = printed::kFacetCounts;
    const auto found = std::find(counts.begin(), counts.end(), count);
    if (found == counts.end()) return "—";
    return fmt::format("{} h", set.paper.hours[found - counts.begin()]);
}

/// Of the times of most facets and of fewest, ours and the paper's.
void add_count_ratios(MirContext& context, const std::vector<double>& counts) {
    const auto key = [](double count) { return fmt::format("1e{:.0f}", std::log10(count)); };
    report::Table table{
        .caption = fmt::format("Times of {} over {}", power_of_ten(counts.back()),
                               power_of_ten(counts.front())),
        .columns = {"parameters", "facets", "flakes (`nacre`)", "paper: facets, 10⁹ over 10⁷"}};
    for (const ParameterSet& set : kSets) {
        nlohmann::json& results = context.results["table_2"][set.key];
        const auto ratio = [&](const nlohmann::json& times) {
            return times.at(key(counts.back())).at("render_s").get<double>() /
                   times.at(key(counts.front())).at("render_s").get<double>();
        };
        const double facets = ratio(results), flakes = ratio(results["nacre"]);
        table.rows.push_back(
            {{set.name},
             report::number_cell(fmt::format("{:.2f}", facets)),
             report::number_cell(fmt::format("{:.2f}", flakes)),
             report::number_cell(fmt::format("{:.2f}", set.paper.max_min_ratio()))});
        results["most_over_fewest"] = {
            {"facets", facets}, {"flakes", flakes}, {"paper", set.paper.max_min_ratio()}};
    }
    context.table("table-2-ratios", table);
}

PictureJob facets_job(const MirContext& context, const ParameterSet& set, double count) {
    PictureJob job = context.job(fmt::format("table-2-{}-1e{:.0f}", set.key, std::log10(count)),
                                 fmt::format("{}: {} facets", set.name, power_of_ten(count)),
                                 set.facets, named_model("special-effect"));
    job.facet_count = count;
    return job;
}

/// The diameter of the flakes by their number, and the lobe that follows from it by diffraction.
void add_flake_sizes(MirContext& context, const std::vector<double>& counts) {
    report::Table table{.caption = "Flakes of `nacre` by their number",
                        .columns = {"flakes on the ball", "mean diameter",
                                    "lobe about the mirror "
                                    "direction"}};
    for (double count : counts) {
        const paint::FlakeSpecies flake =
            recipe_of(flakes_job(context, kSets[0], count)).layers[0].flakes[0];
        // First zero of the Airy pattern at 550 nm, seen outside.   [born-wolf-1999, section 8.5.2]
        const double lobe_deg = 1.22 * 0.55 / flake.diameter_um * 180 / std::numbers::pi;
        table.rows.push_back({report::number_cell(power_of_ten(count)),
                              report::number_cell(fmt::format("{} µm", number(flake.diameter_um))),
                              report::number_cell(fmt::format("± {}°", number(lobe_deg, 2)))});
    }
    context.table("flake-sizes", table);
}

}  // namespace

void add_table_2(MirContext& context) {
    report::Report& report = context.report;
    report.heading(1, "Table 2 and Figure 3: facets and flakes", "table-2");
    report.paragraph(
        "The `special-effect` model with K facets on the whole ball, each with its own place, "
        "normal and film thickness. `alpha = 0.07`, a query cone of 3°. Beside it `nacre` with as "
        "many flakes of titania on mica in a clear binder.");
    add_parameters(context);
    const int first = context.settings.quick ? 5 : 7;
    const std::vector<double> counts = {std::pow(10.0, first), std::pow(10.0, first + 1),
                                        std::pow(10.0, first + 2)};
    add_flake_sizes(context, counts);
    report::Table table{.caption = "Time by number of facets and flakes",
                        .columns = {"parameters", "model", "K", "time", "µs per sample",
                                    "peak memory", "sparkle contrast", "paper: time"}};
    std::vector<report::Picture> facets, flakes;
    for (const ParameterSet& set : kSets) {
        for (const bool is_flakes : {false, true}) {
            const std::string file = is_flakes ? set.flakes : set.facets;
            const Picture smooth = context.gallery.make(context.job(
                fmt::format("table-2-{}-{}smooth", set.key, is_flakes ? "nacre-" : ""),
                fmt::format("{}: without {}", set.name, is_flakes ? "flakes" : "facets"), file,
                named_model(is_flakes ? "microflake" : "thin-film")));
            for (double count : counts) {
                const PictureJob job = (is_flakes ? flakes_job : facets_job)(context, set, count);
                const std::string model{job.model.info().name};
                const Picture picture = context.gallery.make(job);
                const double contrast = sparkle_contrast(picture.image, smooth.image);
                const bool begins = count == counts[0];
                table.rows.push_back(
                    {{begins && !is_flakes ? set.name : ""},
                     {begins ? fmt::format("`{}`", model) : ""},
                     report::number_cell(power_of_ten(count)),
                     report::number_cell(duration(picture.render_s)),
                     report::number_cell(number(1 / picture.msamples_per_s)),
                     report::number_cell(number(picture.peak_mib) + " MiB"),
                     report::number_cell(number(contrast)),
                     report::number_cell(is_flakes ? "—" : paper_hours(set, count))});
                (is_flakes ? flakes : facets)
                    .push_back({fmt::format("{}, `{}`, {}", set.name, model, power_of_ten(count)),
                                picture.png});
                nlohmann::json& results = context.results["table_2"][set.key];
                (is_flakes ? results["nacre"]
                           : results)[fmt::format("1e{:.0f}", std::log10(count))] = {
                    {"render_s", picture.render_s},
                    {"msamples_per_s", picture.msamples_per_s},
                    {"peak_mib", picture.peak_mib},
                    {"sparkle_contrast", contrast}};
            }
        }
    }
    context.table("table-2", table);
    add_count_ratios(context, counts);
    // A fourth column: the flakes whose number, in the middle, is that of ordinary pigments.
    std::vector<report::Picture> figure;
    for (std::size_t row = 0; row < std::size(kSets); ++row) {
        const auto begin = facets.begin() + static_cast<long>(3 * row);
        figure.insert(figure.end(), begin, begin + 3);
        figure.push_back(flakes[3 * row + 1]);
    }
    report.pictures(figure, 4,
                    fmt::format("Figure 3. More facets, finer sparkle; at the right `nacre` with "
                                "{} flakes.",
                                power_of_ten(counts[1])));
    report.pictures(flakes, 3, "Figure 3, continued. `nacre` with as many flakes as facets above.");
    report.paragraph(
        "*Why the flakes differ in size.* In `special-effect` the number of facets and the cone in "
        "which one flashes are chosen apart. Flakes have a diameter, and both follow from it: the "
        "number at a given share of volume, and by diffraction the lobe. So from left to right the "
        "same paint is ground finer, at the same coverage, which leaves its mean as it is. "
        "Their hue is that of the facets' mean, 15° from the mirror direction: 93 nm of titania "
        "for the film of 570 nm, 128 nm for that of 665 nm; their chroma there is 56 for the "
        "facets' 54, and 79 for their 55. The light that flakes scatter on to other flakes fills "
        "what is black beside the facets' highlights.");
    report.paragraph(
        "*Sparkle contrast*: root mean square of the relative deviation of a pixel's luminance "
        "from the picture without facets, over the lit half of the ball. It contains the noise of "
        "rendering. Independent facets would make it fall by √10 from column to column. That of "
        "flakes is the smaller one: they stand under a coat, over a background of light that has "
        "met more than one of them.");
    add_cost_curve(context);
    report.paragraph(
        "*Why minutes and not hours.* At full size the time grows with the number of facets about "
        "as in the paper (1.57 and 1.58), by a deeper tree; small pictures of few samples ask for "
        "larger patches, with more facets in each. The level is not the paper's. A query visits "
        "only the facets whose cell of the surface "
        "meets the footprint of one sample, a share of 1/samples of the pixel: with 10⁹ facets, "
        "512 pixels and 1024 samples some three facets, not the three thousand of a whole pixel. "
        "Places are split before normals, so that the tree is walked along few branches, and "
        "counts of the upper levels are drawn once. Nothing is allocated, and eight wavelengths "
        "share a query. Details: docs/special-effect.md.");
    report.paragraph(
        "*What the paper leaves out, and what we chose.* The spread of thickness (10 nm standard "
        "deviation, uniform), how facets are laid out on the ball (an equal-area square), and the "
        "footprint of a sample.");
}

}  // namespace nacre::study
