#include "nacre/study/mir_2022.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <thread>

#include "nacre/core/atomic_file.h"
#include "nacre/core/data_directory.h"
#include "nacre/core/error.h"
#include "nacre/core/progress_bar.h"
#include "nacre/io/version.h"
#include "nacre/study/mir_parts.h"

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

void require_valid(const MirSettings& settings) {
    require_in_range(settings.size, 16, 4096, "size in pixels");
    require_in_range(settings.samples, 8, 1 << 20, "samples per pixel");
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
         {"Program", fmt::format("nacre {}, seed {}", io::version(), s.seed)},
         {"Machine", hardware()}});
    report.paragraph(
        "The paper's scene, its lights and its camera are not published, nor is its program. Its "
        "pictures can be recognised here, not subtracted. Published figures stand beside ours "
        "where this project knows them; a dash means that it does not. *What the paper leaves out "
        "and what we chose* stands with each part.");
}

}  // namespace

std::set<MirPart> all_mir_parts() {
    return {MirPart::table_1,   MirPart::table_2,      MirPart::table_3, MirPart::table_4,
            MirPart::agreement, MirPart::antialiasing, MirPart::nacre};
}

PictureJob MirContext::job(std::string key, std::string title, const std::string& paint,
                           models::Model model) const {
    PictureJob job;
    job.key = std::move(key);
    job.title = std::move(title);
    job.paint = shipped_file(paint);
    job.model = model;
    if (settings.quick) job.surface.table_size = {.angles = 32, .azimuths = 32};
    job.render.width = job.render.height = settings.size;
    job.render.samples_per_pixel = settings.samples;
    job.render.seed = settings.seed;
    return job;
}

std::filesystem::path run_mir_2022(const MirSettings& settings, const Stage& stage) {
    require_valid(settings);
    const Gallery gallery(settings.folder, stage);
    report::Report report("The comparison of 2022",
                          "Goniochromism, sparkle and multiple scattering of special-effect "
                          "coatings: three models, their reference and a fourth model");
    nlohmann::json results = {{"study", "mir-2022"},
                              {"version", io::version()},
                              {"hardware", hardware()},
                              {"size", settings.size},
                              {"samples_per_pixel", settings.samples},
                              {"seed", settings.seed},
                              {"quick", settings.quick}};
    MirContext context{settings, gallery, report, results};
    add_introduction(context);
    const std::pair<MirPart, void (*)(MirContext&)> parts[] = {
        {MirPart::table_1, add_table_1},     {MirPart::table_2, add_table_2},
        {MirPart::table_3, add_table_3},     {MirPart::table_4, add_table_4},
        {MirPart::agreement, add_agreement}, {MirPart::antialiasing, add_antialiasing},
        {MirPart::nacre, add_nacre}};
    for (const auto& [part, add] : parts) {
        if (settings.parts.contains(part)) add(context);
    }
    const std::filesystem::path page = settings.folder / "index.html";
    write_file_atomically(settings.folder / "results.json", results.dump(2) + "\n");
    write_file_atomically(page, report.html());
    return page;
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

}  // namespace nacre::study
