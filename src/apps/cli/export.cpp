#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/brdf_source.h"
#include "apps/cli/measured_source.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_source.h"
#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/measured/rgl.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/io/measured_brdf_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/measure/acquire.h"
#include "nacre/models/spectral_brdf.h"
#include "nacre/paint/recipe.h"

namespace nacre::cli {

namespace {

struct ExportOptions : CommonOptions {
    std::string paint;
    ModelOptions model;
    std::string wavelengths;
    measure::RglSettings rgl;
    std::string cells = "90,90,180";
    /// Given options that only one of the formats has; the last of each.
    std::string only_rgl, only_merl;
};

/// A file to be, and the surface that it holds.
struct Exported {
    std::string bytes;
    std::shared_ptr<const bsdf::Bsdf> surface;
    bool rgb;
};

/// What is written holds one azimuth of the lamp; a surface that has more must not lose them
/// unsaid.
void refuse_anisotropic(const std::string& paint) {
    const std::string bytes = read_file(paint, io::kMaxMeasuredBytes);
    if (io::looks_like_rgl(bytes) && !io::parse_rgl(bytes, paint).isotropic()) {
        throw InputError(fmt::format(
            "{}: holds an anisotropic BRDF; files are written of isotropic ones only", paint));
    }
}

/// The paint as the renderer sees it, which differs from the solver's values by less than
/// bsdf::kMicroflakeError of the peak and is a hundred times faster: a file asks a million times.
BrdfSource load_fast(const ExportOptions& options, const BrdfRequest& request,
                     const std::optional<std::vector<double>>& wavelengths) {
    refuse_anisotropic(options.paint);
    const bool solved = answers_by_solution(request.model) &&
                        !is_measured_brdf_file(options.paint) && !is_brdf_table(options.paint);
    if (!solved) return load_brdf(options.paint, request, wavelengths, options);
    const auto paint = std::make_shared<const solver::SolvedPaint>(
        load_paint(options.paint, wavelengths, options));
    BrdfSource source{paint->recipe, wavelengths.value_or(paint->wavelengths_nm()), {}};
    const auto brdf = std::make_shared<const models::SpectralBrdf>(
        *request.model.make({paint->recipe, paint, {}}), source.wavelengths_nm);
    source.brdf = [brdf](double theta_i, double theta_o, double phi) {
        return (*brdf)(theta_i, theta_o, phi);
    };
    return source;
}

measure::MerlSettings parse_cells(const std::string& text) {
    constexpr Range kCells{bsdf::kMinMerlCells, bsdf::kMaxMerlCells};
    const std::vector<double> n = parse_numbers("--cells", text, kCells);
    if (n.size() != 3 || n[0] != static_cast<int>(n[0]) || n[1] != static_cast<int>(n[1]) ||
        n[2] != static_cast<int>(n[2])) {
        throw UsageError(
            fmt::format("--cells = {}: must be three whole numbers, as in 90,90,180", text));
    }
    return {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2])};
}

bool is_rgl_name(const std::string& output) {
    const std::string extension = std::filesystem::path(output).extension().string();
    if (extension == ".bsdf") return true;
    if (extension == ".binary") return false;
    throw UsageError(
        fmt::format("--output = {}: must end in .bsdf (RGL) or .binary (MERL)", output));
}

void check_format_options(const ExportOptions& options, bool rgl) {
    const std::string& stray = rgl ? options.only_merl : options.only_rgl;
    if (!stray.empty()) {
        throw UsageError(
            fmt::format("{} belongs to files that end in {}", stray, rgl ? ".binary" : ".bsdf"));
    }
}

std::string title(const ExportOptions& options, const BrdfSource& source) {
    const std::string name = source.recipe && !source.recipe->name.empty()
                                 ? source.recipe->name
                                 : std::filesystem::path(options.paint).filename().string();
    return fmt::format("{}, {}", name, source.measured ? "measured" : options.model.model);
}

Exported acquire(const ExportOptions& options, const BrdfSource& source, bool rgl) {
    ProgressBar bar("measure", options.quiet);
    if (rgl) {
        const bsdf::RglTable table =
            measure::acquire_rgl(title(options, source), source.brdf, source.wavelengths_nm,
                                 options.rgl, bar.callback());
        return {io::rgl_bytes(table), std::make_shared<const bsdf::MeasuredRgl>(table),
                options.rgl.rgb};
    }
    const bsdf::MerlTable table = measure::acquire_merl(source.brdf, source.wavelengths_nm,
                                                        parse_cells(options.cells), bar.callback());
    return {io::merl_bytes(table), std::make_shared<const bsdf::MeasuredMerl>(table), true};
}

ExitStatus run(const ExportOptions& options) {
    const bool rgl = is_rgl_name(options.output);
    check_format_options(options, rgl);
    parse_cells(options.cells);
    const BrdfRequest request = parse_brdf_request(options.model, options.seed);
    std::optional<std::vector<double>> wanted;
    if (!options.wavelengths.empty()) {
        wanted = parse_numbers("--wavelength", options.wavelengths, paint::limits::kWavelength);
        std::sort(wanted->begin(), wanted->end());
        wanted->erase(std::unique(wanted->begin(), wanted->end()), wanted->end());
    }
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;
    const BrdfSource source = load_fast(options, request, wanted);
    const Exported made = acquire(options, source, rgl);
    const measure::TableError error =
        measure::table_error(*made.surface, source.brdf, source.wavelengths_nm, made.rgb);
    emit(options, made.bytes);
    say(options, fmt::format("{}: {} bytes, {:.1f} s; misses the BRDF by {:.2g} % of the light and "
                             "at most {:.2g} % of its peak (incidence 5 to 80 deg)",
                             options.output, made.bytes.size(), watch.seconds(), 100 * error.flux,
                             100 * error.peak));
    write_report(options, "export",
                 {{"paint", options.paint},
                  {"recipe_sha256", source.recipe ? io::recipe_hash(*source.recipe) : ""},
                  {"model", source.measured ? "measured" : options.model.model},
                  {"output", options.output},
                  {"format", rgl ? "rgl" : "merl"},
                  {"bytes", made.bytes.size()},
                  {"error_of_flux", error.flux},
                  {"error_over_peak", error.peak},
                  {"total_s", watch.seconds()}});
    return ExitStatus::ok;
}

}  // namespace

Command add_export(CLI::App& program) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = program.add_subcommand(
        "export", "Write the BRDF of a paint for other renderers, as a measured one");
    command->add_option("PAINT", options->paint, "Recipe, solved paint, table or measured BRDF")
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "File to write: .bsdf (RGL, spectra or RGB) or .binary (MERL, RGB)")
        ->required()
        ->type_name("FILE");
    add_model_options(*command, options->model);
    command->add_option("--wavelength", options->wavelengths,
                        "Vacuum wavelengths, nm [those of a solved paint, else 400:700:10]");
    const auto only = [&](CLI::Option* option, std::string& stray) {
        option->each([&stray, name = option->get_name()](const std::string&) { stray = name; });
        return option;
    };
    only(command->add_option("--resolution", options->rgl.resolution,
                             ".bsdf: points per side for each incidence"),
         options->only_rgl)
        ->check(CLI::Range(4, 512))
        ->capture_default_str();
    only(command->add_option("--incidences", options->rgl.incident,
                             ".bsdf: polar angles of incidence, even from 0 to 89 deg"),
         options->only_rgl)
        ->check(CLI::Range(2, 256))
        ->capture_default_str();
    only(command->add_flag("--rgb", options->rgl.rgb,
                           ".bsdf: linear Rec. 709 instead of spectra, for renderers in RGB"),
         options->only_rgl);
    only(command->add_option("--cells", options->cells,
                             ".binary: cells along theta_half, theta_difference and "
                             "phi_difference; most programs read no others than the database's"),
         options->only_merl)
        ->capture_default_str();
    add_seed(*command, *options);
    add_threads(*command, *options);
    add_quiet(*command, *options);
    add_report(*command, *options);
    command->footer(
        "The mirror of a smooth interface is not part of a BRDF: add it in the other renderer as\n"
        "a coat of the binder's index. Says on stderr by how much the file misses the BRDF.\n\n"
        "Example: for Mitsuba's plugin \"measured\"\n"
        "  nacre export paints/red-gold.toml -o red-gold.bsdf");
    return {command, [options] { return run(*options); }};
}

}  // namespace nacre::cli
