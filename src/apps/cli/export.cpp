#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/nacre.h"
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

ExitStatus run(const ExportOptions& options) {
    const bool rgl = is_rgl_name(options.output);
    check_format_options(options, rgl);
    parse_cells(options.cells);
    require_values(parse_model_settings(options.model).info());
    BrdfSettings settings;
    if (!options.wavelengths.empty()) {
        settings.wavelengths_nm =
            parse_numbers("--wavelength", options.wavelengths, paint::limits::kWavelength);
        std::vector<double>& nm = settings.wavelengths_nm;
        std::sort(nm.begin(), nm.end());
        nm.erase(std::unique(nm.begin(), nm.end()), nm.end());
    }
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;
    const Paint paint = open_input(options, options.paint);
    settings.model = model_for({&paint}, options.model);
    const Exported made = [&] {
        ProgressBar bar("measure", options.quiet);
        return rgl ? paint.export_rgl(options.rgl, settings, bar.callback())
                   : paint.export_merl(parse_cells(options.cells), settings, bar.callback());
    }();
    say_warnings(options, paint);
    emit(options, made.bytes);
    say(options, fmt::format("{}: {} bytes, {:.1f} s; misses the BRDF by {:.2g} % of the light and "
                             "at most {:.2g} % of its peak (incidence 5 to 80 deg)",
                             options.output, made.bytes.size(), watch.seconds(),
                             100 * made.error.flux, 100 * made.error.peak));
    write_report(options, "export",
                 {{"paint", options.paint},
                  {"recipe_sha256", paint.recipe_sha256()},
                  {"model", paint.kind() == Kind::measured_brdf ? "measured" : options.model.model},
                  {"output", options.output},
                  {"format", rgl ? "rgl" : "merl"},
                  {"bytes", made.bytes.size()},
                  {"error_of_flux", made.error.flux},
                  {"error_over_peak", made.error.peak},
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
                             ".bsdf: polar angles of incidence, 0 to 89 deg, closest near grazing"),
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
    add_untrusted(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "The specular reflection of a smooth interface is not part of a BRDF: add it in the other\n"
        "renderer as a coat of the binder's index. Says on stderr by how much the file misses the "
        "BRDF.\n\n"
        "Example: for Mitsuba's plugin \"measured\"\n"
        "  nacre export paints/red-gold.toml -o red-gold.bsdf");
    return {command, [options] { return files_of(*options, {options->paint}); },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
