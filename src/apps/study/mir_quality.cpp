#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/study/equal_time.h"
#include "apps/study/mir_2022.h"
#include "apps/study/query_cost.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/special_effect.h"
#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/core/file.h"
#include "nacre/io/image_difference.h"
#include "nacre/io/recipe_file.h"
#include "nacre/montecarlo/discs/disc.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

// What a user pays: the time to a picture of a given quality, with what is computed beforehand, and
// what one query of each model costs.

namespace nacre::study {
namespace {

/// The noise that our Monte Carlo reference of metallic gray has with the paper's 1024 samples.
constexpr double kTarget_db = 38.9;
/// Flakes or facets in the patch of a sample: 1e9 on the ball, 512 pixels a side, 1024 samples.
constexpr double kPerPatch = 3;

using Table = bsdf::MicroflakeModel::Table;

struct Subject {
    const char* key;
    const char* name;
    bsdf::Model model;
};

/// Subjects that show one paint, hence have one converged picture, that of the first if it is
/// common.
struct Group {
    const char* key;
    const char* name;
    std::string paint;
    std::vector<Subject> subjects;
    bool common;  ///< all should show the same: errors of data count, not only noise
};

std::vector<Group> all_groups(const MirContext& context) {
    const bsdf::BrdfTableSettings size =
        context.settings.quick ? bsdf::BrdfTableSettings{32, 32} : bsdf::BrdfTableSettings{};
    const auto data = [&](int rank) {
        return std::vector<Subject>{
            {"split", "`microflake`, split", bsdf::MicroflakeModel{}},
            {"raw", "`microflake`, raw table",
             bsdf::MicroflakeModel{.table = Table::raw, .table_size = size}},
            {"svd", "`microflake`, compressed",
             bsdf::MicroflakeModel{
                 .table = Table::svd, .table_size = size, .compression = {.rank = rank}}},
            {"volume", "Monte Carlo (`volume`)", named_model("volume")}};
    };
    std::vector<Group> groups = {
        {"gray", "Metallic gray", "paints/metallic-gray.toml", data(3), true},
        {"red", "Cadmium red", "paints/cadmium-red.toml", data(4), true}};
    for (const MirFigure4Row& row : kFigure4Rows) {
        groups.push_back({row.paper.titania_nm < 100 ? "pearl-80" : "pearl-110",
                          row.flakes_name,
                          row.flakes,
                          {{"microflake", "`microflake`", named_model("microflake")},
                           {"nacre", "`nacre`", named_model("nacre")}},
                          false});
        groups.push_back(
            {row.paper.titania_nm < 100 ? "facets-570" : "facets-665",
             row.facets_name,
             row.facets,
             {{"thin-film", "`thin-film`", named_model("thin-film")},
              {"smooth", "`special-effect`, smooth", bsdf::SpecialEffectModel{.smooth_ndf = true}},
              {"special-effect", "`special-effect`", named_model("special-effect")}},
             false});
    }
    if (context.settings.quick) groups.erase(groups.begin() + 1, groups.end() - 1);
    return groups;
}

/// As a small part of the full picture: as many facets and flakes a pixel, and patches of the same
/// fraction of it.
PictureJob job_of(const MirContext& context, const Group& group, const Subject& subject) {
    PictureJob job = context.job({}, {}, group.paint, subject.model);
    const int size = std::max(32, context.settings.size / 8);
    job.render.width = job.render.height = size;
    const double scale = static_cast<double>(size) / printed::kPictureSize;
    if (subject.model.info().ingredients == bsdf::Ingredients::facets) {
        job.facet_count = std::round(printed::kFacetCounts[2] * scale * scale);
        job.render.footprint_pixels = render::default_footprint_pixels(printed::kSamples);
    } else if (subject.model.info().can.sparkle) {
        job.scene_scale = scale;
    }
    return job;
}

struct QualityOutcome {
    double prepare_s = 0;
    double us_per_sample = 0;
    ErrorCurve curve;               ///< mean square errors by processor time of a full picture
    std::optional<double> seconds;  ///< to the target
    double best_db = 0;             ///< of most samples
};

QualityOutcome measure_quality(const MirContext& context, const Group& group,
                               const Subject& subject, std::optional<io::Image>& common) {
    const int most = context.settings.quick ? 16 : 4 * context.settings.samples;
    QualityOutcome out;
    std::vector<double> samples, each_s;
    const auto picture = [&](int count, std::uint64_t seed) {
        PictureJob job = job_of(context, group, subject);
        job.key = fmt::format("quality-{}-{}-{}-{}", group.key, subject.key, count, seed);
        job.title = fmt::format("quality of {}, {}: {} samples", group.name, subject.key, count);
        job.render.samples_per_pixel = count;
        job.render.seed = context.settings.seed + seed;
        Picture made = context.gallery.make(job);
        each_s.push_back(made.processor_s / count / job.render.width / job.render.height);
        out.prepare_s = made.prepare_s;
        return made.image;
    };
    const bool has_converged = group.common && common;
    const io::Image converged = has_converged ? *common : picture(4 * most, 1);
    if (group.common && !common) common = converged;
    for (int count = 4; count <= most; count *= 4) {
        samples.push_back(count);
        out.curve.error.push_back(
            io::image_difference(picture(count, 0), converged, "picture", "converged picture")
                .mean_square_error);
    }
    const double pixels = double{printed::kPictureSize} * printed::kPictureSize;
    const double sample_s = median(each_s);
    out.us_per_sample = 1e6 * sample_s;
    for (double count : samples) out.curve.seconds.push_back(count * pixels * sample_s);
    out.seconds = seconds_at(out.curve, std::pow(10, -kTarget_db / 10));
    out.best_db = -10 * std::log10(out.curve.error.back());
    return out;
}

/// The surface that a renderer asks, and patches that hold kPerPatch of its flakes or facets; none
/// where they make no difference.
struct QueriedSurface {
    std::shared_ptr<const bsdf::Bsdf> surface;
    std::vector<bsdf::Patch> patches;
};

QueriedSurface asked_of(const Group& group, const Subject& subject, int queries,
                        const Progress& progress) {
    paint::Recipe recipe = io::read_recipe(shipped_file(group.paint));
    if (recipe.microfacet && recipe.microfacet->facets) {
        recipe.microfacet->facets->count = printed::kFacetCounts[2];
    }
    bsdf::ModelInput input{.recipe = recipe};
    if (subject.model.info().solution != bsdf::Solution::none) {
        input.solved = std::make_shared<const solver::SolvedPaint>(
            solver::solve(recipe, spectra::default_wavelengths_nm(), {}, nullptr, progress));
        input.table = subject.model.make_table(*input.solved, progress);
    }
    QueriedSurface asked{subject.model.make(input, progress), {}};
    if (!asked.surface->varies_over_surface()) return asked;
    constexpr double kUmPerMm = 1e3;
    const double area_mm2 = recipe.layers.empty() ? 1
                                                  : kPerPatch / montecarlo::expected_discs(
                                                                    recipe, {kUmPerMm, kUmPerMm});
    asked.patches = square_patches(area_mm2, kPerPatch / printed::kFacetCounts[2], queries);
    return asked;
}

/// ns: value, and value with a sample.
std::array<double, 2> query_cost(const QueriedSurface& asked, int queries, int rounds) {
    const QuerySubject subject(*asked.surface, queries);
    std::array<std::vector<double>, 2> times;
    for (int round = 0; round < rounds; ++round) {
        times[0].push_back(subject.measure(asked.patches, QueryKind::value).nanoseconds);
        times[1].push_back(subject.measure(asked.patches, QueryKind::value_and_sample).nanoseconds);
    }
    return {median(times[0]), median(times[1])};
}

void add_queries(MirContext& context, const std::vector<Group>& groups) {
    const bool quick = context.settings.quick;
    const int queries = quick ? 256 : 4096, rounds = quick ? 3 : 15;
    report::Table table{.caption = "Time of one query, ns",
                        .columns = {"paint", "model", "value", "value and sample"}};
    context.gallery.stage()("queries of each model", [&](const Progress& progress) {
        for (const Group& group : groups) {
            for (const Subject& subject : group.subjects) {
                if (subject.model.info().can.reference_only) continue;  // has no values to ask for
                const QueriedSurface asked = asked_of(group, subject, queries, progress);
                const auto [value, sample] = query_cost(asked, queries, rounds);
                const bool first = &subject == group.subjects.data();
                table.rows.push_back({{first ? group.name : ""},
                                      {subject.name},
                                      report::number_cell(fmt::format("{:.0f}", value)),
                                      report::number_cell(fmt::format("{:.0f}", sample))});
                context.results["query_ns"][group.key][subject.key] = {
                    {"value", value}, {"value_and_sample", sample}};
            }
        }
    });
    context.report.heading(2, "A query of each model", "query-of-each-model");
    context.report.paragraph(fmt::format(
        "A value with its density, and the same with a sample to go on, for directions as in a "
        "renderer; eight wavelengths, processor time of one core, medians of {} rounds. Of single "
        "flakes and facets: a new patch that holds {}. Monte Carlo walks have no values: they "
        "cost what a path costs, above.",
        rounds, kPerPatch));
    context.table("queries", table);
}

}  // namespace

void add_quality(MirContext& context) {
    report::Report& report = context.report;
    report.heading(1, "Time to a picture of a given quality", "quality");
    report.paragraph(fmt::format(
        "The time that matters to a user is that to a picture that is good enough. Here: {} dB "
        "against the converged picture, which is the noise of our Monte Carlo reference of "
        "metallic gray at the paper's {} samples. Processor time of a picture of {} x {}, from "
        "small pictures at growing numbers of samples with as many flakes and facets (10⁹ on the "
        "ball) a pixel. Where one paint is kept as different data, all are held against the "
        "converged picture of the split data, so that errors of a table count too. *Preparation* "
        "is what is computed beforehand, once a paint, in wall-clock time: the solver, and where "
        "it is so the table, its compression, and writing and reading its file. The paper gives "
        "1.9 to 2 minutes for its precomputation.",
        kTarget_db, printed::kSamples, printed::kPictureSize, printed::kPictureSize));
    report::Table table{.caption = fmt::format("Processor time to {} dB", kTarget_db),
                        .columns = {"paint", "model", "preparation", "µs per sample", "to quality",
                                    "over the first", "at most"}};
    const std::vector<Group> groups = all_groups(context);
    for (const Group& group : groups) {
        std::optional<io::Image> common;
        std::optional<double> first_s;
        for (const Subject& subject : group.subjects) {
            const QualityOutcome out = measure_quality(context, group, subject, common);
            const bool first = &subject == group.subjects.data();
            if (first) first_s = out.seconds;
            const bool has_ratio = out.seconds && first_s;
            table.rows.push_back(
                {{first ? group.name : ""},
                 {subject.name},
                 report::number_cell(duration(out.prepare_s)),
                 report::number_cell(number(out.us_per_sample)),
                 report::number_cell(out.seconds ? duration(*out.seconds) : "not reached"),
                 report::number_cell(has_ratio ? fmt::format("{:.2f}", *out.seconds / *first_s)
                                               : "—"),
                 report::number_cell(fmt::format("{:.1f} dB", out.best_db))});
            nlohmann::json& results = context.results["quality"][group.key][subject.key];
            results = {{"prepare_s", out.prepare_s},
                       {"us_per_sample", out.us_per_sample},
                       {"processor_s", out.curve.seconds},
                       {"mean_square_error", out.curve.error},
                       {"best_db", out.best_db}};
            if (out.seconds) results["processor_s_to_target"] = *out.seconds;
        }
    }
    context.results["quality"]["target_db"] = kTarget_db;
    context.table("quality", table);
    report.paragraph(
        "*At most*: the PSNR with most samples, four times those of the study. Where it stays "
        "below the target, the light of single flakes or facets outshines the noise of all else, "
        "or the data themselves err.");
    add_queries(context, groups);
}

}  // namespace nacre::study
