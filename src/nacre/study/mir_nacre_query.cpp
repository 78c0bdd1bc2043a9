#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "nacre/core/data_directory.h"
#include "nacre/discs/disc.h"
#include "nacre/io/recipe_file.h"
#include "nacre/layers/solver.h"
#include "nacre/study/median.h"
#include "nacre/study/mir_parts.h"
#include "nacre/study/query_cost.h"

// Time of one query against the number of flakes or facets in its footprint.

namespace nacre::study {
namespace {

constexpr double kFacets = 1e9;

/// One curve: a surface, and what it is asked.
struct Curve {
    std::string name;
    const QuerySubject* subject;
    Ask ask;
    bool on_patch;
    std::vector<double> median_ns = {};
};

struct Surfaces {
    std::shared_ptr<const bsdf::Bsdf> facets, flakes, mean;
    double flakes_per_mm2;
};

Surfaces make_surfaces(std::uint64_t seed) {
    models::SurfaceOptions options;
    options.seed = seed;
    models::Paint facets{.recipe =
                             io::read_recipe(shipped_file("studies/mir-2022/facets-570.toml"))};
    facets.recipe.microfacet->facets->count = kFacets;
    models::Paint flakes{.recipe =
                             io::read_recipe(shipped_file("studies/mir-2022/flakes-570.toml"))};
    flakes.solved = std::make_shared<const layers::SolvedPaint>(
        layers::solve(flakes.recipe, layers::default_wavelengths_nm(), {}));
    constexpr double kUmPerMm = 1e3;
    return {models::make_surface(models::Model::special_effect, facets, options),
            models::make_surface(models::Model::nacre, flakes, options),
            models::make_surface(models::Model::microflake, flakes, options),
            discs::expected_discs(flakes.recipe, {kUmPerMm, kUmPerMm})};
}

void measure(std::vector<Curve>& curves, const std::vector<double>& footprints,
             double flakes_per_mm2, int queries, int rounds) {
    for (double count : footprints) {
        const auto patches = square_patches(count / flakes_per_mm2, count / kFacets, queries);
        std::vector<std::vector<double>> times(curves.size());
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < curves.size(); ++i) {
                const Curve& curve = curves[i];
                times[i].push_back(
                    curve.subject
                        ->ask(curve.on_patch ? patches : std::vector<bsdf::Patch>{}, curve.ask)
                        .nanoseconds);
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
    context.report.table(table);
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
    context.gallery.stage()("queries by their footprint", [&](const Progress&) {
        const Surfaces surfaces = make_surfaces(context.settings.seed);
        const QuerySubject facets(*surfaces.facets, queries), flakes(*surfaces.flakes, queries),
            mean(*surfaces.mean, queries);
        curves = {{"facets: value", &facets, Ask::value, true},
                  {"and sample", &facets, Ask::value_and_sample, true},
                  {"flakes: value", &flakes, Ask::value, true},
                  {"and sample", &flakes, Ask::value_and_sample, true},
                  {"further", &flakes, Ask::value_again, true},
                  {"their mean: value", &mean, Ask::value, false},
                  {"and sample", &mean, Ask::value_and_sample, false}};
        measure(curves, footprints, surfaces.flakes_per_mm2, queries, rounds);
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
        "and what does not depend on flakes, Fresnel terms, layers and the remainder of the "
        "solver, which `special-effect` does not have.");
}

}  // namespace nacre::study
