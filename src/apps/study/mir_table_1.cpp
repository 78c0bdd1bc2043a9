#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/study/folder.h"
#include "apps/study/mir_2022.h"
#include "apps/study/mir_storage.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/core/file.h"
#include "nacre/io/image_difference.h"

// Table 1 and Figure 2: what tabulating and compressing the solved BRDF costs.

namespace nacre::study {
namespace {

struct PaperPaint {
    const char* key;
    const char* name;
    const char* file;
    printed::DataTimes paper;
    int rank;               ///< r, with k = (r^2 + r)/2 terms
    bool has_two_channels;  ///< in the paper
};
constexpr PaperPaint kPaints[] = {
    {"metallic-gray", "Metallic gray", "paints/metallic-gray.toml", printed::kTable1[0], 3, false},
    {"cadmium-red", "Cadmium red", "paints/cadmium-red.toml", printed::kTable1[1], 4, true}};

/// The reference in two halves with independent random numbers: their mean is the reference, their
/// difference gives its noise.
struct Reference {
    Picture mean;
    double noise_mse = 0;  ///< variance of a value of the mean
};

Reference make_reference(const MirContext& context, const PaperPaint& paint) {
    PictureJob job = context.job(fmt::format("table-1-{}-reference-a", paint.key),
                                 fmt::format("{}: reference, first half", paint.name), paint.file,
                                 named_model("volume"));
    job.render.samples_per_pixel /= 2;
    const Picture a = context.gallery.make(job);
    job.key.back() = 'b';
    job.title = fmt::format("{}: reference, second half", paint.name);
    job.render.seed += 1;
    const Picture b = context.gallery.make(job);

    Reference reference{a, 0};
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t c = 0; c < a.image.channels.size(); ++c) {
        const auto& pa = a.image.channels[c].pixels;
        const auto& pb = b.image.channels[c].pixels;
        auto& mean = reference.mean.image.channels[c].pixels;
        for (std::size_t i = 0; i < pa.size(); ++i) {
            mean[i] = 0.5f * (pa[i] + pb[i]);
            if (a.image.channels[c].name == "A") continue;
            const double difference = double{pa[i]} - pb[i];
            sum += difference * difference;
            ++count;
        }
    }
    // Var[(a + b) / 2] = Var[a] / 2 = E[(a - b)^2] / 4.
    reference.noise_mse = sum / static_cast<double>(count) / 4;
    reference.mean.render_s += b.render_s;
    const auto png =
        context.gallery.folder() / "pictures" / fmt::format("table-1-{}-reference.png", paint.key);
    check_own(png);
    io::write_png(png, reference.mean.image);
    reference.mean.png = read_file(png);
    return reference;
}

double psnr_db(double mse) { return -10 * std::log10(mse); }

void add_paint(MirContext& context, const PaperPaint& paint, report::Table& table,
               std::vector<report::Picture>& pictures) {
    const Reference reference = make_reference(context, paint);
    const std::string noise = number(psnr_db(reference.noise_mse), 4);
    table.rows.push_back({{paint.name},
                          {"reference (`volume`)"},
                          report::number_cell("—"),
                          report::number_cell(duration(reference.mean.render_s)),
                          report::number_cell("—"),
                          report::number_cell("—"),
                          report::number_cell("—"),
                          report::number_cell(noise + " (own noise)"),
                          report::number_cell("—"),
                          report::number_cell("—"),
                          report::number_cell(duration(paint.paper.monte_carlo_s)),
                          report::number_cell("—"),
                          report::number_cell("—")});
    pictures.push_back({fmt::format("{}: reference", paint.name), reference.mean.png});
    auto& results = context.results["table_1"][paint.key];
    results["reference"] = {{"render_s", reference.mean.render_s},
                            {"noise_psnr_db", psnr_db(reference.noise_mse)}};

    // What is compared are the settings of one model, hence by their own type.
    using Table = bsdf::MicroflakeModel::Table;
    const bsdf::BrdfTableSettings size =
        context.settings.quick ? bsdf::BrdfTableSettings{32, 32} : bsdf::BrdfTableSettings{};
    struct Kind {
        Table table;
        const char* id;
        const char* name;
        double paper_s;  ///< 0: not in the paper
        double paper_mb;
        bool clip_to_gamut = false;
    };
    std::vector<Kind> kinds = {{Table::raw, "raw", "raw table", paint.paper.raw_s, printed::kRawMb},
                               {Table::svd, "svd", "compressed (SVD)", paint.paper.compressed_s,
                                paint.paper.compressed_mb}};
    if (paint.has_two_channels) {
        kinds.push_back({Table::svd, "svd-two-channels", "compressed, green left out",
                         paint.paper.compressed_s, paint.paper.compressed_mb, true});
    }
    kinds.push_back({Table::split, "split", "split (ours)", 0, 0});
    double raw_psnr = 0;
    for (const Kind& kind : kinds) {
        const std::string id = kind.id;
        const PictureJob job = context.job(
            fmt::format("table-1-{}-{}", paint.key, id),
            fmt::format("{}: {}", paint.name, kind.name), paint.file,
            bsdf::MicroflakeModel{
                .table = kind.table,
                .table_size = size,
                .compression = {.rank = paint.rank, .clip_to_gamut = kind.clip_to_gamut}});
        const Picture picture = context.gallery.make(job);
        const io::ImageDifference difference =
            io::image_difference(picture.image, reference.mean.image, job.title, "the reference");
        if (kind.table == Table::raw) raw_psnr = difference.psnr_db;
        const double loss = raw_psnr - difference.psnr_db;
        table.rows.push_back(
            {{},
             {kind.name},
             report::number_cell(duration(picture.prepare_s)),
             report::number_cell(duration(picture.render_s)),
             report::number_cell(mebibytes(picture.data_bytes)),
             report::number_cell(mebibytes(picture.file_bytes)),
             report::number_cell(number(picture.peak_mib) + " MiB"),
             report::number_cell(number(difference.psnr_db, 5)),
             report::number_cell(number(difference.delta_e_mean)),
             report::number_cell(kind.table == Table::svd ? fmt::format("{:.4f}", loss) : "—"),
             report::number_cell(kind.paper_s > 0 ? fmt::format("{} s", kind.paper_s) : "—"),
             report::number_cell(kind.paper_mb > 0 ? fmt::format("{} MB", kind.paper_mb) : "—"),
             report::number_cell(
                 kind.table == Table::svd
                     ? fmt::format("{} to {}", printed::kMinLoss_db, printed::kMaxLoss_db)
                     : "—")});
        if (!kind.clip_to_gamut) {  // it looks like the other compressed one
            pictures.push_back({fmt::format("{}: {}", paint.name, kind.name), picture.png});
        }
        results[id] = {{"prepare_s", picture.prepare_s},
                       {"render_s", picture.render_s},
                       {"data_bytes", picture.data_bytes},
                       {"file_bytes", picture.file_bytes},
                       {"peak_mib", picture.peak_mib},
                       {"psnr_db", difference.psnr_db},
                       {"loss_db", loss},
                       {"delta_e_mean", difference.delta_e_mean},
                       {"delta_e_95th", difference.delta_e_95th}};
    }
}

/// Of the times of Table 1, ours and the paper's.
void add_ratios(MirContext& context) {
    report::Table table{
        .caption = "Ratios of times",
        .columns = {"paint", "Monte Carlo over raw", "paper", "compressed over raw", "paper"}};
    for (const PaperPaint& paint : kPaints) {
        auto& results = context.results["table_1"][paint.key];
        const double raw_s = results["raw"]["render_s"];
        const double monte_carlo = results["reference"]["render_s"].get<double>() / raw_s;
        const double compressed = results["svd"]["render_s"].get<double>() / raw_s;
        table.rows.push_back(
            {{paint.name},
             report::number_cell(fmt::format("{:.2f}", monte_carlo)),
             report::number_cell(fmt::format("{:.0f}", paint.paper.monte_carlo_over_raw())),
             report::number_cell(fmt::format("{:.2f}", compressed)),
             report::number_cell(fmt::format("{:.2f}", paint.paper.compressed_over_raw()))});
        results["ratios"] = {{"monte_carlo_over_raw", monte_carlo},
                             {"paper_monte_carlo_over_raw", paint.paper.monte_carlo_over_raw()},
                             {"compressed_over_raw", compressed},
                             {"paper_compressed_over_raw", paint.paper.compressed_over_raw()}};
    }
    context.table("table-1-ratios", table);
    context.report.paragraph(
        "*Why Monte Carlo is not hundreds of times slower here.* The paper marches through the "
        "volume by Simpson's rule along every segment of a path, and picks normals by general "
        "means. Our reference draws free flights without bias from tabulated extinction, and "
        "flakes' normals in closed form, so that a walk through the coat costs about what tracing "
        "and lighting a path costs anyway; the times are of whole pictures, and a table saves only "
        "the walk. And equal samples are not equal noise: [the time to a given "
        "quality](#quality) is.");
    context.report.paragraph(
        "*Compressed over raw.* Compressed data fit the processor's cache, raw data do not; that "
        "is what the paper's .66 (gray) shows, and a [query](#query-of-each-model) of ours does "
        "too. Over the whole picture less of it is left. Its .91 for red has more terms to sum.");
}

}  // namespace

void add_table_1(MirContext& context) {
    report::Report& report = context.report;
    report.heading(1, "Table 1 and Figure 2: raw and compressed data", "table-1");
    report.paragraph(
        "The solved BRDF is tabulated over incident angle, outgoing angle and azimuth (n = 256, m "
        "= 128, RGB, 32-bit: 96 MiB), and compressed by a singular value decomposition with k = "
        "(r² + r)/2 terms. Beside them: our own form, which keeps the interface and single "
        "scattering as formulas and only the rest as symmetric factors per azimuthal order and "
        "wavelength.");
    report::Table table{.caption = "Against the volumetric Monte Carlo reference",
                        .columns = {"paint", "data", "preparation", "time", "data", "file",
                                    "peak memory", "PSNR, dB", "mean ΔE", "loss, dB", "paper: time",
                                    "paper: data", "paper: loss, dB"}};
    std::vector<report::Picture> pictures;
    for (const PaperPaint& paint : kPaints) add_paint(context, paint, table, pictures);
    context.table("table-1", table);
    add_ratios(context);
    report.pictures(pictures, 4, "Figure 2. Reference, raw table, compressed table, split.");
    report.paragraph(
        "*Own noise*: the PSNR between the reference and its exact picture, from two halves "
        "rendered with different random numbers. No model can come closer to the noisy reference "
        "than that. Raw and compressed pictures share their random numbers and their way of "
        "sampling, so that their difference is that of the data. The split data are rendered by "
        "wavelengths, eight a path, and show a little more colour noise than RGB tables do.");
    report.paragraph(
        "*What the paper leaves out, and what we chose.* The amount, thickness and orientation of "
        "the flakes: c = 0.1 per µm, 15 µm, alpha = 0.1, in a binder of index 1.5 over black. The "
        "nodes of the table, which docs/tables.md gives. For cadmium red the paper's sizes imply "
        "two channels, its green being zero. Here reflected light is a spectrum whose colour is "
        "(0.89, 0, 0.13), and light that meets several flakes is more saturated still: its green "
        "is negative, outside the gamut. We keep it; left out, as in the row of that name, the "
        "size is the paper's. Our split data are spectral, 31 wavelengths.");
    add_storage(context);
}

}  // namespace nacre::study
