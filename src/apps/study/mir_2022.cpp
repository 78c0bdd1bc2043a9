#include "apps/study/mir_2022.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <thread>

#include "apps/study/folder.h"
#include "apps/study/picture_agreement.h"
#include "nacre/bsdf/models/thin_film.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/progress.h"
#include "nacre/core/random.h"
#include "nacre/core/version.h"
#include "nacre/io/image_difference.h"
#include "nacre/montecarlo/shell_walk.h"
#include "nacre/optics/antialiased.h"

namespace nacre::study {
namespace {

/// "AMD EPYC ..., 2 threads": times mean little without it.
std::string hardware() {
    std::ifstream cpus("/proc/cpuinfo");
    std::string line, model = "unknown processor";
    while (std::getline(cpus, line)) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            model = line.substr(colon + 2);
            break;
        }
    }
    return fmt::format("{}, {} hardware threads", model, std::thread::hardware_concurrency());
}

void add_introduction(MirContext& context) {
    const MirSettings& s = context.settings;
    report::Report& report = context.report;
    report.paragraph(
        "Mir, Yıldırım and Kurt (2022) compared three families of models for special-effect "
        "coatings: translucent micro-flakes solved by adding-doubling (Ergun et al. 2016), "
        "thin-film microfacets (Belcour and Barla 2017) and discrete facets (Guo et al. 2018). "
        "This page is that comparison made anew by one command: the same tables and figures, with "
        "this program's own implementations. Beside them stands a fourth model, `nacre`, which "
        "does what the paper leaves as future work: colour that turns with angle, sparkle and "
        "multiple scattering at once.");
    if (s.samples < 1024 || s.size < 512) {
        report.note(
            fmt::format("Scaled down: {0} x {0} pixels at {1} samples each, where the paper's "
                        "pictures have 512 x 512 at 1024. Times are those of the scaled pictures; "
                        "noise is higher.",
                        s.size, s.samples));
    }
    report.definitions(
        {{"Pictures", fmt::format("{0} x {0} pixels, {1} samples each; a ball of 100 mm in the "
                                  "built-in studio (soft boxes of D65 on a dim gradient); full "
                                  "spectrum, eight wavelengths a path",
                                  s.size, s.samples)},
         {"Differences",
          "PSNR over linear R, G, B with the perfect diffuser as peak; colour differences are "
          "CIEDE2000 under D65"},
         {"Program", fmt::format("nacre {}, seed {}", version(), s.seed)},
         {"Machine", hardware()}});
    report.paragraph(
        "The paper's scene, its lights and its camera are not published, nor is its program. Its "
        "pictures can be recognised here, not subtracted. What it prints stands beside ours, times "
        "of its machine included (Intel Xeon X5650, GeForce GTX 690 and Quadro 4000; on which of "
        "them is not said): so ratios can be compared, not seconds. A dash means that the paper "
        "does not say. *What the paper leaves out and what we chose* stands with each part.");
}

}  // namespace

std::set<MirPart> all_mir_parts() {
    return {MirPart::table_1, MirPart::table_2,   MirPart::table_3,      MirPart::table_4,
            MirPart::quality, MirPart::agreement, MirPart::antialiasing, MirPart::nacre};
}

PictureJob MirContext::job(std::string key, std::string title, const std::string& paint,
                           bsdf::Model model) const {
    PictureJob job;
    job.key = std::move(key);
    job.title = std::move(title);
    job.paint = shipped_file(paint);
    job.model = std::move(model);
    job.render.width = job.render.height = settings.size;
    job.render.samples_per_pixel = settings.samples;
    job.render.seed = settings.seed;
    return job;
}

void require_valid(const MirSettings& settings) {
    require_in_range(settings.size, 16, 4096, "size in pixels");
    require_in_range(settings.samples, 8, 1 << 20, "samples per pixel");
}

void MirContext::table(const std::string& name, const report::Table& table) {
    report.table(table);
    nlohmann::json rows = nlohmann::json::array();
    for (const std::vector<report::Cell>& row : table.rows) {
        nlohmann::json cells = nlohmann::json::array();
        for (const report::Cell& cell : row) cells.push_back(cell.text);
        rows.push_back(std::move(cells));
    }
    std::vector<bool> numeric;  // by column, as most of its cells are
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        std::size_t count = 0;
        for (const auto& row : table.rows) count += row[c].numeric;
        numeric.push_back(2 * count > table.rows.size());
    }
    results["tables"][name] = {
        {"columns", table.columns}, {"numeric", numeric}, {"rows", std::move(rows)}};
}

std::filesystem::path run_mir_2022(const MirSettings& settings, const Stage& stage) {
    require_valid(settings);
    const FolderLock lock(settings.folder);
    check_page(settings.folder);
    const Gallery gallery(settings.folder, stage);
    report::Report report("The comparison of 2022",
                          "Goniochromism, sparkle and multiple scattering of special-effect "
                          "coatings: three models, their reference and a fourth model");
    nlohmann::json results = {{"study", "mir-2022"},
                              {"version", version()},
                              {"hardware", hardware()},
                              {"size", settings.size},
                              {"samples_per_pixel", settings.samples},
                              {"seed", settings.seed},
                              {"quick", settings.quick}};
    MirContext context{settings, gallery, report, results};
    add_introduction(context);
    const std::pair<MirPart, void (*)(MirContext&)> parts[] = {
        {MirPart::table_1, add_table_1},           {MirPart::table_2, add_table_2},
        {MirPart::table_3, add_table_3},           {MirPart::table_4, add_table_4},
        {MirPart::quality, add_quality},           {MirPart::agreement, add_agreement},
        {MirPart::antialiasing, add_antialiasing}, {MirPart::nacre, add_nacre}};
    for (const auto& [part, add] : parts) {
        if (settings.parts.contains(part)) add(context);
    }
    return write_page(settings.folder, report.html(), results);
}

std::string number(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }

std::string power_of_ten(double value) {
    static constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = "10";
    for (char digit : fmt::format("{}", std::lround(std::log10(value))))
        text += kDigits[digit - '0'];
    return text;
}

std::string duration(double seconds) { return duration_text(seconds); }

std::string mebibytes(std::size_t bytes) {
    return fmt::format("{:.{}f} MiB", static_cast<double>(bytes) / (1 << 20),
                       bytes < (1 << 20) ? 3 : 2);
}

// The solved BRDF, the position-free reference and the volumetric reference, pixel by pixel.

namespace {

constexpr int kBatches = 16;

std::vector<io::Image> batches(const MirContext& context, const char* paint,
                               const bsdf::Model& model, const std::string& name) {
    std::vector<io::Image> pictures;
    for (int batch = 0; batch < kBatches; ++batch) {
        PictureJob job = context.job(
            fmt::format("agreement-{}-{}", name, batch),
            fmt::format("agreement: {}, batch {} of {}", name, batch + 1, kBatches), paint, model);
        job.render.width = job.render.height = std::max(16, context.settings.size / 8);
        // Random numbers of its own for each method: shared ones would correlate the errors.
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
    const auto solved = batches(context, paint, named_model("microflake"), "microflake");
    const auto walk = batches(context, paint, named_model("walk"), "walk");
    const auto shell = batches(context, paint, named_model("volume"), "volume-delta");
    const auto simpson =
        batches(context, paint, montecarlo::VolumeModel{.tracking = montecarlo::Tracking::simpson},
                "volume-simpson");
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
             report::number_cell(fmt::format("{:.2f} %", 100 * agreement.fraction_above_3)),
             report::number_cell(
                 fmt::format("{:.2f} %", 100 * agreement.expected_fraction_above_3)),
             report::number_cell(fmt::format("{:+.4f} ± {:.4f} %",
                                             100 * agreement.relative_difference,
                                             100 * agreement.relative_standard_error))});
        context.results["agreement"][pair.name] = {
            {"pixels", agreement.pixels},
            {"mean_square_z", agreement.mean_square_z},
            {"expected_mean_square_z", agreement.expected_mean_square_z},
            {"share_above_3", agreement.fraction_above_3},
            {"relative_difference", agreement.relative_difference},
            {"relative_standard_error", agreement.relative_standard_error}};
    }
    context.table("agreement", table);
}

// Spectral antialiasing of the thin film: RGB colours in closed form against integration.

namespace {

struct Film {
    const char* name;
    double outside, film, base, extinction;
};
constexpr Film kFilms[] = {
    {"1.8 on 1.08 + 0.51i, in air", 1, 1.8, 1.08, 0.51},
    {"1.97 on 1.12, in air", 1, 1.97, 1.12, 0},
    {"2.5 (titania) on 1.58 (mica), in resin", 1.5, 2.5, 1.58, 0},
    {"1.45 (silica) on 1.0 + 6.7i (aluminium), in resin", 1.5, 1.45, 1.0, 6.7}};

struct Variant {
    const char* name;
    optics::Antialiasing how;
};
const Variant kVariants[] = {
    {"table, every order", {optics::ObserverTransform::table, optics::kEveryOrder}},
    {"table, 3 orders", {optics::ObserverTransform::table, 3}},
    {"paper (Gaussians), 3 orders", {optics::ObserverTransform::paper, 3}},
    {"paper (Gaussians), every order", {optics::ObserverTransform::paper, optics::kEveryOrder}}};

std::vector<double> steps(double first, double last, double step) {
    std::vector<double> values;
    for (int i = 0; first + i * step <= last + 1e-9; ++i) values.push_back(first + i * step);
    return values;
}

void add_plot(MirContext& context, const Film& film) {
    const optics::AiryFilm airy(film.outside, film.film, film.base, film.extinction);
    report::Plot plot{.title = std::string("Error of a colour against thickness: ") + film.name,
                      .caption = "At 30° on the film.",
                      .x = {.label = "film thickness, nm"},
                      .y = {.label = "CIEDE2000", .logarithmic = true, .lo = 1e-4}};
    for (const Variant& variant : kVariants) {
        report::Series series{.name = variant.name};
        for (double thickness : steps(10, 1000, 10)) {
            series.x.push_back(thickness);
            series.y.push_back(optics::compare_antialiasing(airy, std::cos(std::numbers::pi / 6),
                                                            thickness, variant.how)
                                   .delta_e);
        }
        plot.series.push_back(series);
    }
    context.report.plot(plot);
}

/// The two sets of Table 2 rendered from RGB colours, against the spectral pictures.
void add_rgb_pictures(MirContext& context) {
    using bsdf::ThinFilmColour;
    struct Mode {
        const char* key;
        const char* name;
        ThinFilmColour colour;
    };
    constexpr Mode kModes[] = {{"spectral", "spectral", ThinFilmColour::spectral},
                               {"table", "RGB, table", ThinFilmColour::table},
                               {"paper", "RGB, paper (Gaussians)", ThinFilmColour::paper}};
    report::Table table{.caption = "Pictures rendered from RGB colours against spectral ones",
                        .columns = {"film", "colours", "time", "PSNR, dB", "mean ΔE", "95th ΔE"}};
    std::vector<report::Picture> pictures;
    for (const MirFigure4Row& row : kFigure4Rows) {
        io::Image spectral;
        for (const Mode& mode : kModes) {
            const Picture picture = context.gallery.make(
                context.job(fmt::format("antialiasing-{:.0f}-{}", row.paper.titania_nm, mode.key),
                            fmt::format("film of {}: {}", row.facets_name, mode.name), row.facets,
                            bsdf::ThinFilmModel{.colour = mode.colour}));
            if (mode.colour == ThinFilmColour::spectral) spectral = picture.image;
            const io::ImageDifference d =
                io::image_difference(picture.image, spectral, mode.name, "spectral");
            const bool itself = mode.colour == ThinFilmColour::spectral;
            table.rows.push_back(
                {{itself ? row.facets_name : ""},
                 {mode.name},
                 report::number_cell(duration(picture.render_s)),
                 report::number_cell(itself ? "—" : fmt::format("{:.1f}", d.psnr_db)),
                 report::number_cell(itself ? "—" : number(d.delta_e_mean)),
                 report::number_cell(itself ? "—" : number(d.delta_e_95th))});
            pictures.push_back({fmt::format("{}, {}", row.facets_name, mode.name), picture.png});
            if (itself) continue;
            context.results["antialiasing"]["pictures"][row.facets_name][mode.key] = {
                {"render_s", picture.render_s},
                {"psnr_db", d.psnr_db},
                {"delta_e_mean", d.delta_e_mean},
                {"delta_e_95th", d.delta_e_95th}};
        }
    }
    context.table("rgb-pictures", table);
    context.report.pictures(pictures, 3,
                            "The sets of Table 2: spectral, RGB by the table, RGB by the paper.");
    context.report.paragraph(
        "Noise is part of the differences: the same random numbers follow other weights. Colours "
        "outside the gamut of reflectances are cut off where RGB becomes a spectrum.");
}

}  // namespace

void add_antialiasing(MirContext& context) {
    report::Report& report = context.report;
    report.heading(1, "Spectral antialiasing", "antialiasing");
    report.paragraph(
        "`thin-film` renders spectra. Its RGB mode takes the colour of the film in closed form, "
        "from the Fourier transform of the eye's sensitivities: the paper fits them by Gaussians; "
        "ours tabulates the transform of the observer itself. Each against integration at 1 nm, "
        "over thicknesses of 0 to 1000 nm and angles of 0 to 80°.");
    report::Table table{
        .columns = {"film", "colours from", "mean ΔE", "largest ΔE", "mean RGB", "largest RGB"}};
    const std::vector<double> thicknesses = steps(0, 1000, context.settings.quick ? 100 : 10);
    std::vector<double> cosines;
    for (double degrees : steps(0, 80, context.settings.quick ? 40 : 10)) {
        cosines.push_back(std::cos(degrees * std::numbers::pi / 180));
    }
    for (const Film& film : kFilms) {
        const optics::AiryFilm airy(film.outside, film.film, film.base, film.extinction);
        for (const Variant& variant : kVariants) {
            const optics::AntialiasingError e =
                optics::antialiasing_error(airy, cosines, thicknesses, variant.how);
            table.rows.push_back({{&variant == kVariants ? film.name : ""},
                                  {variant.name},
                                  report::number_cell(number(e.mean_delta_e)),
                                  report::number_cell(number(e.max_delta_e)),
                                  report::number_cell(number(e.mean_rgb, 2)),
                                  report::number_cell(number(e.max_rgb, 2))});
            context.results["antialiasing"][film.name][variant.name] = {
                {"mean_delta_e", e.mean_delta_e},
                {"max_delta_e", e.max_delta_e},
                {"mean_rgb", e.mean_rgb},
                {"max_rgb", e.max_rgb}};
        }
    }
    context.table("antialiasing", table);
    add_plot(context, kFilms[0]);
    add_plot(context, kFilms[2]);
    add_rgb_pictures(context);
}

}  // namespace nacre::study
