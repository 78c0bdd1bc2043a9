#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/difference_table.h"
#include "apps/cli/export_chips.h"
#include "apps/cli/files.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "apps/report/svg_raster.h"
#include "nacre/core/file.h"
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
    std::string chips;
    /// Given options that only one kind of formats has; the last of each.
    std::string only_rgl, only_merl, only_materials;
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

enum class ExportFormat { rgl, merl, gltf, materialx, cycles, threejs };

constexpr const char* kMaterialSuffixes = ".gltf, .mtlx, .blender.py or .three.js";

ExportFormat format_of(const std::string& output) {
    const std::string extension = std::filesystem::path(output).extension().string();
    if (extension == ".bsdf") return ExportFormat::rgl;
    if (extension == ".binary") return ExportFormat::merl;
    if (extension == ".gltf") return ExportFormat::gltf;
    if (extension == ".mtlx") return ExportFormat::materialx;
    if (output.ends_with(".blender.py")) return ExportFormat::cycles;
    if (output.ends_with(".three.js")) return ExportFormat::threejs;
    throw UsageError(
        fmt::format("--output = {}: must end in .bsdf (RGL), .binary (MERL), .gltf (glTF 2.0), "
                    ".mtlx (MaterialX), .blender.py (Cycles) or .three.js (three.js){}",
                    output,
                    is_standard_output(output)
                        ? ", which says what to write; it does not go to the standard output"
                        : ""));
}

/// The material that is fitted, or none for a table or a shader.
std::optional<MaterialFormat> fitted_format(ExportFormat format) {
    switch (format) {
        case ExportFormat::rgl:
        case ExportFormat::merl:
        case ExportFormat::threejs:
            return std::nullopt;
        case ExportFormat::gltf:
            return MaterialFormat::gltf;
        case ExportFormat::materialx:
            return MaterialFormat::materialx;
        case ExportFormat::cycles:
            return MaterialFormat::cycles;
    }
    return std::nullopt;
}

/// Whether a picture of colours lies beside it.
bool is_material(ExportFormat format) {
    return format != ExportFormat::rgl && format != ExportFormat::merl;
}

const char* report_name(MaterialFormat format) {
    switch (format) {
        case MaterialFormat::gltf:
            return "gltf";
        case MaterialFormat::materialx:
            return "materialx";
        case MaterialFormat::cycles:
            return "cycles";
    }
    return "";
}

void check_format_options(const ExportOptions& options, ExportFormat format) {
    const auto refuse = [](const std::string& stray, const char* suffixes) {
        if (stray.empty()) return;
        throw UsageError(fmt::format("{} belongs to files that end in {}", stray, suffixes));
    };
    if (format != ExportFormat::rgl) refuse(options.only_rgl, ".bsdf");
    if (format != ExportFormat::merl) refuse(options.only_merl, ".binary");
    if (!is_material(format)) refuse(options.only_materials, kMaterialSuffixes);
    if (format == ExportFormat::threejs && !options.wavelengths.empty()) {
        throw UsageError("--wavelength: a .three.js file has its own sixteen");
    }
}

/// The picture of the colours, beside the material unless it was named.
std::string chips_name(const ExportOptions& options) {
    if (!options.chips.empty()) return options.chips;
    return options.output + ".svg";
}

/// @throws UsageError unless it is a picture of vectors or of pixels
void check_chips(const ExportOptions& options) {
    const std::string name = chips_name(options);
    const std::string extension = std::filesystem::path(name).extension().string();
    if (extension == ".svg" || extension == ".png") return;
    throw UsageError(fmt::format("--chips = {}: must end in .svg or .png", name));
}

void write_chips(const ExportOptions& options, const std::string& svg) {
    const std::string name = chips_name(options);
    const bool png = std::filesystem::path(name).extension() == ".png";
    write_file_atomically(name, png ? report::png_of_svg(svg, report::kPngScale) : svg);
}

BrdfSettings brdf_settings(const ExportOptions& options) {
    BrdfSettings settings;
    if (options.wavelengths.empty()) return settings;
    settings.wavelengths_nm =
        parse_numbers("--wavelength", options.wavelengths, paint::limits::kWavelength);
    std::vector<double>& nm = settings.wavelengths_nm;
    std::sort(nm.begin(), nm.end());
    nm.erase(std::unique(nm.begin(), nm.end()), nm.end());
    return settings;
}

nlohmann::json export_report(const ExportOptions& options, const Paint& paint, const char* format,
                             std::size_t bytes, double seconds) {
    return {{"paint", options.paint},
            {"recipe_sha256", paint.recipe_sha256()},
            {"model", paint.is_measured() ? "measured" : options.model.model},
            {"output", options.output},
            {"format", format},
            {"bytes", bytes},
            {"total_s", seconds}};
}

/// A table of the BRDF, whose error is that of its interpolation.
void write_table(const ExportOptions& options, const Paint& paint, const BrdfSettings& settings,
                 bool rgl) {
    const Stopwatch watch;
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
    nlohmann::json report =
        export_report(options, paint, rgl ? "rgl" : "merl", made.bytes.size(), watch.seconds());
    report["error_of_flux"] = made.error.flux;
    report["error_over_peak"] = made.error.peak;
    write_report(options, "export", report);
}

void say_by_angle(const ExportOptions& options, const measure::Difference& difference) {
    for (const measure::AngleDifference& angle : difference.angles) {
        say(options,
            fmt::format("  {:<8} Delta E 2000 {:5.2f}", angle.geometry.name, angle.delta_e_2000));
    }
}

/// A material of another renderer, whose error is that of its own BRDF.
void write_material(const ExportOptions& options, const Paint& paint, const BrdfSettings& settings,
                    MaterialFormat format) {
    const Stopwatch watch;
    const FittedMaterial made = [&] {
        ProgressBar bar("fit", options.quiet);
        return paint.export_material(format, settings, bar.callback());
    }();
    say_warnings(options, paint);
    write_chips(options, material_chips(paint.name(), made));
    emit(options, made.bytes);
    const exchange::MaterialFit& fit = made.fit;
    say_by_angle(options, fit.instrument);
    say(options,
        fmt::format("{}: a fit, not the paint. Delta E 2000, mean and greatest: {:.1f}, {:.1f} at "
                    "byk-mac's angles; {:.1f}, {:.1f} at {} angles that the fit did not see. "
                    "Side by side: {}",
                    options.output, fit.instrument.mean_delta_e_2000,
                    fit.instrument.max_delta_e_2000, fit.tested.mean_delta_e_2000,
                    fit.tested.max_delta_e_2000, fit.tested.angles.size(), chips_name(options)));
    nlohmann::json report =
        export_report(options, paint, report_name(format), made.bytes.size(), watch.seconds());
    report["chips"] = chips_name(options);
    for (const auto& [name, value] : made.parameters) report["parameters"][name] = value;
    report["differences"] = {{"byk_mac", difference_json(fit.instrument)},
                             {"fitted", difference_json(fit.fitted)},
                             {"tested", difference_json(fit.tested)}};
    write_report(options, "export", report);
}

/// The paint's own model, whose error is that of its textures and wavelengths.
void write_shader(const ExportOptions& options, const Paint& paint,
                  const std::optional<Model>& model) {
    const Stopwatch watch;
    const ShaderMaterial made = [&] {
        ProgressBar bar("tabulate", options.quiet);
        return paint.export_threejs(model, bar.callback());
    }();
    say_warnings(options, paint);
    write_chips(options, shader_chips(paint.name(), made));
    emit(options, made.bytes);
    say_by_angle(options, made.difference);
    say(options, fmt::format("{}: {} bytes; the model's own shader. Delta E 2000 from {}, mean and "
                             "greatest: {:.1f}, {:.1f}. Side by side: {}",
                             options.output, made.bytes.size(), made.standard,
                             made.difference.mean_delta_e_2000, made.difference.max_delta_e_2000,
                             chips_name(options)));
    nlohmann::json report =
        export_report(options, paint, "three.js", made.bytes.size(), watch.seconds());
    report["model"] = made.model;
    report["chips"] = chips_name(options);
    report["differences"] = {{"all", difference_json(made.difference)}};
    write_report(options, "export", report);
}

ExitStatus run(const ExportOptions& options) {
    const ExportFormat format = format_of(options.output);
    check_format_options(options, format);
    parse_cells(options.cells);
    require_values(parse_model_settings(options.model).info());
    BrdfSettings settings = brdf_settings(options);
    const std::optional<MaterialFormat> fitted = fitted_format(format);
    if (is_material(format)) check_chips(options);
    if (is_material(format) && options.chips.empty()) check_chips_beside(chips_name(options));
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Paint paint = open_paint(options, options.paint);
    settings.model = model_for({&paint}, options.model);
    if (fitted) {
        write_material(options, paint, settings, *fitted);
    } else if (format == ExportFormat::threejs) {
        write_shader(options, paint, chosen_model(options.model));
    } else {
        write_table(options, paint, settings, format == ExportFormat::rgl);
    }
    return ExitStatus::ok;
}

CommandFiles files_of_export(const ExportOptions& options) {
    CommandFiles files = files_of(options, {options.paint});
    // A name that is no format is refused by run().
    const std::string extension = std::filesystem::path(options.output).extension().string();
    if (extension == ".gltf" || extension == ".mtlx" || options.output.ends_with(".blender.py") ||
        options.output.ends_with(".three.js")) {
        files.files.push_back({"--chips", chips_name(options)});
    }
    return files;
}

}  // namespace

Command add_export(CLI::App& program) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = program.add_subcommand(
        "export", "Write a paint for other renderers: its BRDF, or a material fitted to it");
    command->add_option("PAINT", options->paint, "Recipe, solved paint, table or measured BRDF")
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "File to write: .bsdf (RGL, spectra or RGB), .binary (MERL, RGB), .gltf (glTF "
                     "2.0), .mtlx (MaterialX, OpenPBR), .blender.py (Blender's Cycles) or "
                     ".three.js (shader)")
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
        ->check(in_range<int>(measure::RglSettings::kResolutionRange))
        ->capture_default_str();
    only(command->add_option("--incidences", options->rgl.incident,
                             ".bsdf: polar angles of incidence, 0 to 89 deg, closest near grazing"),
         options->only_rgl)
        ->check(in_range<int>(measure::RglSettings::kIncidentRange))
        ->capture_default_str();
    only(command->add_flag("--rgb", options->rgl.rgb,
                           ".bsdf: linear Rec. 709 instead of spectra, for renderers in RGB"),
         options->only_rgl);
    only(command->add_option("--cells", options->cells,
                             ".binary: cells along theta_half, theta_difference and "
                             "phi_difference; most programs read no others than the database's"),
         options->only_merl)
        ->capture_default_str();
    only(command->add_option(
             "--chips", options->chips,
             ".gltf, .mtlx, .blender.py, .three.js: picture (.svg or .png) of the paint's colours "
             "and the material's, side by side [beside the output, .svg added]"),
         options->only_materials)
        ->type_name("FILE");
    add_input_options(*command, *options);
    add_set(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "The specular reflection of a smooth interface is not part of a BRDF: add it in the other\n"
        "renderer as a coat of the binder's index. Says on stderr by how much the file misses the "
        "BRDF.\n"
        "A .gltf, .mtlx or .blender.py is the format's own material fitted to the paint's "
        "colours, its\nclearcoat included; what it misses is written into it and shown in the "
        "picture of colours.\n"
        "A .three.js is an ES module with nacre's mean, or microflake, as a shader.\n\n"
        "Example: for Mitsuba's plugin \"measured\"\n"
        "  nacre export paints/red-gold.toml -o red-gold.bsdf");
    return {command, [options] { return files_of_export(*options); },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
