#include <fmt/format.h>

#include <functional>

#include "nacre/core/rng.h"
#include "nacre/study/mir_parts.h"
#include "nacre/study/picture_agreement.h"

// The solved BRDF, the position-free reference and the volumetric reference, pixel by pixel.

namespace nacre::study {
namespace {

constexpr int kBatches = 16;

std::vector<io::Image> batches(const MirContext& context, const char* paint, models::Model model,
                               volume::Tracking tracking, const std::string& name) {
    std::vector<io::Image> pictures;
    for (int batch = 0; batch < kBatches; ++batch) {
        PictureJob job = context.job(
            fmt::format("agreement-{}-{}", name, batch),
            fmt::format("agreement: {}, batch {} of {}", name, batch + 1, kBatches), paint, model);
        job.surface.radius_mm = 50;
        job.surface.tracking = tracking;
        job.render.width = job.render.height = std::max(16, context.settings.size / 8);
        // Numbers of their own for each method: shared ones would make errors alike.
        job.render.seed = context.settings.seed + hash_of(std::hash<std::string>{}(name), batch);
        pictures.push_back(context.gallery.make(job).image);
    }
    return pictures;
}

}  // namespace

void add_agreement(MirContext& context) {
    context.report.heading(1, "Agreement of three solutions", "agreement");
    context.report.paragraph(
        fmt::format("Metallic gray, solved by adding-doubling (`microflake`), by random walks in "
                    "depth (`walk`) and by random walks through a shell of paint around the ball "
                    "(`volume`, by unbiased and by Simpson tracking): {} batches each, with random "
                    "numbers of their own. For every pixel, z is the difference of the two means "
                    "over its standard error.",
                    kBatches));
    const char* paint = "paints/metallic-gray.toml";
    const auto solved =
        batches(context, paint, models::Model::microflake, volume::Tracking::delta, "microflake");
    const auto walk = batches(context, paint, models::Model::walk, volume::Tracking::delta, "walk");
    const auto shell =
        batches(context, paint, models::Model::volume, volume::Tracking::delta, "volume-delta");
    const auto simpson =
        batches(context, paint, models::Model::volume, volume::Tracking::simpson, "volume-simpson");
    struct Pair {
        const char* name;
        const std::vector<io::Image>&a, &b;
    };
    const Pair pairs[] = {{"walk, microflake", walk, solved},
                          {"volume, microflake", shell, solved},
                          {"volume, walk", shell, walk},
                          {"volume by Simpson, volume", simpson, shell}};
    report::Table table{.columns = {"pair", "pixels", "mean z²", "expected", "|z| > 3", "expected",
                                    "difference of the whole picture"}};
    for (const Pair& pair : pairs) {
        const PictureAgreement agreement = picture_agreement(pair.a, pair.b);
        table.rows.push_back(
            {{pair.name},
             report::number_cell(fmt::format("{}", agreement.pixels)),
             report::number_cell(fmt::format("{:.3f}", agreement.mean_square_z)),
             report::number_cell(fmt::format("{:.3f}", agreement.expected_mean_square_z)),
             report::number_cell(fmt::format("{:.2f} %", 100 * agreement.share_above_3)),
             report::number_cell(fmt::format("{:.2f} %", 100 * agreement.expected_share_above_3)),
             report::number_cell(fmt::format("{:+.4f} ± {:.4f} %",
                                             100 * agreement.relative_difference,
                                             100 * agreement.relative_standard_error))});
        context.results["agreement"][pair.name] = {
            {"pixels", agreement.pixels},
            {"mean_square_z", agreement.mean_square_z},
            {"expected_mean_square_z", agreement.expected_mean_square_z},
            {"share_above_3", agreement.share_above_3},
            {"relative_difference", agreement.relative_difference},
            {"relative_standard_error", agreement.relative_standard_error}};
    }
    context.report.table(table);
}

}  // namespace nacre::study
