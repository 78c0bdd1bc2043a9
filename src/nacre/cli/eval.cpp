#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "nacre/cli/brdf_options.h"
#include "nacre/cli/command.h"
#include "nacre/cli/direction_list.h"
#include "nacre/cli/model_options.h"
#include "nacre/cli/number_list.h"
#include "nacre/cli/paint_source.h"
#include "nacre/cli/stopwatch.h"
#include "nacre/cli/usage_error.h"
#include "nacre/core/parallel.h"
#include "nacre/io/recipe_file.h"
#include "nacre/layers/recipe_limits.h"
#include "nacre/models/spectral_brdf.h"

namespace nacre::cli {

namespace {

constexpr std::size_t kMostRows = 5'000'000;
constexpr double kDegree = std::numbers::pi / 180;

struct EvalOptions : BrdfOptions {
    ModelOptions model;
    // Without wavelengths: those of a solved paint, else 400 to 700 nm by 10.
    std::string at, footprint;
};

/// BRDF values by wavelength for angles in rad.
using Evaluate = std::function<std::vector<double>(double theta_i, double theta_o, double phi)>;

struct Source {
    std::optional<layers::Recipe> recipe;  // none: a table does not hold it
    std::vector<double> wavelengths;
    Evaluate evaluate;
};

/// The solved paint itself: in double precision, by parts.
Source solved_source(const EvalOptions& options, const std::optional<std::vector<double>>& wanted) {
    auto paint =
        std::make_shared<const layers::SolvedPaint>(load_paint(options.recipe, wanted, options));
    std::vector<double> wavelengths = wanted.value_or(paint->wavelengths_nm());
    std::vector<std::size_t> positions;
    for (double wavelength : wavelengths) {
        positions.push_back(wavelength_position(*paint, wavelength, options.recipe));
    }
    const auto part = parse_part<layers::Part>(options.part);
    return {paint->recipe, std::move(wavelengths),
            [paint, positions, part](double theta_i, double theta_o, double phi) {
                const std::vector<double> brdf = paint->brdf(theta_i, theta_o, phi, part);
                std::vector<double> values;
                for (std::size_t position : positions) values.push_back(brdf[position]);
                return values;
            }};
}

/// What can be said about --at and --footprint before the paint is made.
void check_patch(const EvalOptions& options, const models::ModelInfo& model) {
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

/// The square that --at and --footprint describe, in the terms of the surface; none without them.
std::optional<bsdf::Patch> parse_patch(const EvalOptions& options, bsdf::Layout layout) {
    if (options.at.empty()) return std::nullopt;
    // As large as a car.
    constexpr Range kPlace{-1e4, 1e4, "mm"}, kSide{0, 1e4, "mm", true};
    constexpr Range kShare{0, 1}, kShareOfSide{0, 1, "", true};
    const bool in_mm = layout == bsdf::Layout::rest_space;
    const std::vector<std::string> place = split(options.at, ',');
    const double x = parse_number("--at", place[0], in_mm ? kPlace : kShare);
    const double y = parse_number("--at", place[1], in_mm ? kPlace : kShare);
    const auto side = static_cast<float>(
        parse_number("--footprint", options.footprint, in_mm ? kSide : kShareOfSide));
    if (!in_mm) return bsdf::Patch{x, y, {side, 0}, {0, side}};
    // A flat panel that faces +z, as in render::FlatPanel.
    const Vec3f position_mm{static_cast<float>(x), static_cast<float>(y), 0}, normal{0, 0, 1};
    const Frame frame = Frame::around(normal);
    bsdf::Patch patch;
    patch.rest = {position_mm, normal, frame.s, {side * frame.s, side * frame.t}};
    return patch;
}

/// Any model that gives values, through the surface that a renderer sees.
Source model_source(const EvalOptions& options, const models::ModelInfo& model,
                    const models::SurfaceOptions& surface,
                    const std::optional<std::vector<double>>& wanted) {
    if (model.can.reference_only) {
        throw UsageError(
            fmt::format("--model = {}: follows light and has no values to give; see "
                        "nacre reference",
                        model.name));
    }
    if (surface.flakes == models::Flakes::explicit_discs) {
        throw UsageError(
            "--flakes = explicit: follows light and has no values to give; see nacre render");
    }
    if (options.part != "total") {
        throw UsageError(
            fmt::format("--part = {}: only --model microflake knows parts", options.part));
    }
    PaintSurface paint = load_surface(options.recipe, model.model, surface, options);
    const std::optional<bsdf::Patch> patch = parse_patch(options, paint.surface->layout());
    std::vector<double> wavelengths = wanted.value_or(layers::default_wavelengths_nm());
    const auto brdf = std::make_shared<const models::SpectralBrdf>(*paint.surface, wavelengths);
    return {std::move(paint.recipe), std::move(wavelengths),
            [brdf, patch](double theta_i, double theta_o, double phi) {
                return (*brdf)(theta_i, theta_o, phi, patch);
            }};
}

ExitStatus run(const EvalOptions& options) {
    const models::ModelInfo& model = parse_model(options.model);
    const models::SurfaceOptions surface = parse_surface_options(options.model, options.seed);
    check_patch(options, model);
    const ThreadLimit threads(options.threads);
    const Stopwatch watch;
    const std::vector<Direction> incident = parse_directions("--incident", options.incident);
    const std::vector<Direction> outgoing = parse_directions("--outgoing", options.outgoing);
    std::optional<std::vector<double>> wanted;
    if (!options.wavelengths.empty()) {
        wanted = parse_numbers("--wavelength", options.wavelengths, layers::limits::kWavelength);
    }
    const bool is_solved = model.model == models::Model::microflake &&
                           surface.table == models::Table::split && !is_brdf_table(options.recipe);
    const Source source =
        is_solved ? solved_source(options, wanted) : model_source(options, model, surface, wanted);
    const std::vector<double>& wavelengths = source.wavelengths;
    if (incident.size() * outgoing.size() * wavelengths.size() > kMostRows) {
        throw UsageError(
            fmt::format("{} incident times {} outgoing directions times {} wavelengths are too "
                        "many: at most {} rows",
                        incident.size(), outgoing.size(), wavelengths.size(), kMostRows));
    }
    std::string table = "theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf\n";
    for (const Direction& in : incident) {
        for (const Direction& out : outgoing) {
            const std::vector<double> brdf =
                source.evaluate(in.theta_deg * kDegree, out.theta_deg * kDegree,
                                (out.phi_deg - in.phi_deg) * kDegree);
            for (std::size_t i = 0; i < wavelengths.size(); ++i) {
                fmt::format_to(std::back_inserter(table), "{},{},{},{},{},{:.9g}\n", in.theta_deg,
                               in.phi_deg, out.theta_deg, out.phi_deg, wavelengths[i], brdf[i]);
            }
        }
    }
    emit(options, table);
    write_report(options, "eval",
                 {{"recipe", options.recipe},
                  {"recipe_sha256", source.recipe ? io::recipe_hash(*source.recipe) : ""},
                  {"model", options.model.model},
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
                     "Middle of a patch that shows its single flakes; nacre: X,Y in mm on a flat "
                     "panel; special-effect: U,V in the object's unit square. Without it, the mean "
                     "over the object");
    eval->add_option("--footprint", options->footprint,
                     "Side of that patch; nacre: in mm; special-effect: as a share of the unit "
                     "square's");
    add_seed(*eval, *options);
    eval->add_option("--wavelength", options->wavelengths,
                     "Vacuum wavelengths, nm [those of a solved paint, else 400:700:10]");
    add_output(*eval, *options);
    add_threads(*eval, *options);
    add_quiet(*eval, *options);
    add_report(*eval, *options);
    eval->footer(
        "phi_o - phi_i = 180 is the mirror side; theta and phi may be first:last:step. Writes "
        "CSV:\n"
        "theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf, in 1/sr; the mirror of a smooth "
        "interface\n"
        "is left out.\n\n"
        "Example: the flop of a pearl, lit from 45 deg\n"
        "  nacre eval paints/tio2-mica-80.toml --incident 45 --outgoing 0:75:5,180 \\\n"
        "             --wavelength 450,550,650");
    return {eval, [options] { return run(*options); }};
}

}  // namespace nacre::cli
