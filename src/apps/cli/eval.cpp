#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/cli/brdf_options.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/nacre.h"
#include "nacre/paint/recipe.h"

namespace nacre::cli {

namespace {

constexpr std::size_t kMaxRows = 5'000'000;

struct EvalOptions : BrdfOptions {
    ModelOptions model;
    // Without wavelengths: those of a solved paint, else 400 to 700 nm by 10.
    std::string at, footprint;
};

/// Refuses wrong --at and --footprint before the paint is made, as far as possible.
void check_patch(const EvalOptions& options, const bsdf::ModelInfo& model) {
    if (options.at.empty() && options.footprint.empty()) return;
    if (!model.can.sparkle) {
        throw UsageError(
            fmt::format("--at and --footprint: {} is alike all over the surface", model.name));
    }
    if (options.at.empty() || options.footprint.empty()) {
        throw UsageError("--at and --footprint belong together");
    }
    if (split(options.at, ',').size() != 2) {
        throw UsageError(fmt::format("--at = {}: must be two numbers, as in 0.25,0.5", options.at));
    }
}

/// The square that --at and --footprint describe; the mean over the surface without them.
PaintBrdf on_patch(const PaintBrdf& brdf, const EvalOptions& options) {
    if (options.at.empty()) return brdf;
    if (brdf.surface_coordinates() == bsdf::SurfaceCoordinates::none) {
        throw UsageError("--at and --footprint: the surface is alike everywhere");
    }
    const std::vector<std::string_view> place = split(options.at, ',');
    return brdf.on(parse_number("--at", place[0], brdf.place_range()),
                   parse_number("--at", place[1], brdf.place_range()),
                   parse_number("--footprint", options.footprint, brdf.side_range()));
}

/// Refuses options that do not fit the model, before any work is done.
void check_model(const EvalOptions& options) {
    const bsdf::ModelInfo& model = parse_model_settings(options.model).info();
    check_patch(options, model);
    require_values(model);
    if (parse_part(options.part) != Part::total && !model.can.parts) {
        throw UsageError(fmt::format(
            "--part = {}: only --model {} knows parts", options.part,
            fmt::join(models_that([](const bsdf::ModelInfo& m) { return m.can.parts; }), ", ")));
    }
}

ExitStatus run(const EvalOptions& options) {
    check_model(options);
    const ThreadLimit threads(options.threads);
    const Stopwatch watch;
    const std::vector<Direction> incident = parse_directions("--incident", options.incident);
    const std::vector<Direction> outgoing = parse_directions("--outgoing", options.outgoing);
    BrdfSettings settings{.part = parse_part(options.part), .patches = !options.at.empty()};
    if (!options.wavelengths.empty()) {
        settings.wavelengths_nm =
            parse_numbers("--wavelength", options.wavelengths, paint::limits::kWavelength);
    }
    const Paint paint = open_paint(options, options.recipe);
    settings.model = model_for({&paint}, options.model);
    if (paint.has_recipe() && paint.recipe().flake_lean() &&
        std::any_of(incident.begin(), incident.end(),
                    [](const Direction& in) { return in.phi_deg != 0; })) {
        throw UsageError(
            "--incident: must have the azimuth 0, as flakes that lean do so from the lamp's; "
            "turn the paint by lean.azimuth_deg");
    }
    ProgressBar bar("prepare", options.quiet || !settings.model || !settings.model->makes_table());
    const PaintBrdf values = on_patch(paint.brdf(settings, bar.callback()), options);
    say_warnings(options, paint);
    const std::vector<double>& wavelengths = values.wavelengths_nm();
    if (incident.size() * outgoing.size() * wavelengths.size() > kMaxRows) {
        throw UsageError(
            fmt::format("{} incident times {} outgoing directions times {} wavelengths are too "
                        "many: at most {} rows",
                        incident.size(), outgoing.size(), wavelengths.size(), kMaxRows));
    }
    std::string table = "theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf\n";
    for (const Direction& in : incident) {
        for (const Direction& out : outgoing) {
            const std::vector<double> brdf = values(in.theta_deg * kDegree, out.theta_deg * kDegree,
                                                    (out.phi_deg - in.phi_deg) * kDegree);
            for (std::size_t i = 0; i < wavelengths.size(); ++i) {
                table += fmt::format("{},{},{},{},{},{:.9g}\n", in.theta_deg, in.phi_deg,
                                     out.theta_deg, out.phi_deg, wavelengths[i], brdf[i]);
            }
        }
    }
    emit_table(options, table);
    write_report(options, "eval",
                 {{"recipe", options.recipe},
                  {"recipe_sha256", paint.recipe_sha256()},
                  {"model", paint.kind() == Kind::measured_brdf ? "measured" : options.model.model},
                  {"part", options.part},
                  {"values", incident.size() * outgoing.size() * wavelengths.size()},
                  {"total_s", watch.seconds()}});
    return ExitStatus::ok;
}

}  // namespace

Command add_eval(CLI::App& program) {
    auto options = std::make_shared<EvalOptions>();
    CLI::App* eval = program.add_subcommand("eval", "Evaluate the BRDF of a paint");
    add_brdf_options(*eval, *options);
    add_model_options(*eval, options->model);
    eval->add_option("--at", options->at,
                     fmt::format("Middle of a patch that shows its single flakes; {}. Without it, "
                                 "the mean over the object",
                                 by_coordinates("X,Y in mm on a flat panel",
                                                "U,V in the object's unit square")));
    eval->add_option(
        "--footprint", options->footprint,
        "Side of that patch; " + by_coordinates("in mm", "as a fraction of the unit square's"));
    eval->add_option("--wavelength", options->wavelengths,
                     "Vacuum wavelengths, nm [those of a solved paint, else 400:700:10]");
    add_table_output(*eval, *options);
    add_run_options(*eval, *options);
    eval->footer(
        "phi_o - phi_i = 180 is the mirror side; theta and phi may be first:last:step. Writes "
        "CSV:\n"
        "theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf, in 1/sr; the specular "
        "reflection of\n"
        "a smooth interface is left out.\n\n"
        "Example: the flop of a pearl, lit from 45 deg\n"
        "  nacre eval paints/tio2-mica-80.toml --incident 45 --outgoing 0:75:5,180 \\\n"
        "             --wavelength 450,550,650");
    return {eval, [options] { return files_of(*options, {options->recipe}, "CSV"); },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
