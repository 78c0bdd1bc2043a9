#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/nacre.h"
#include "nacre/paint/recipe.h"

namespace nacre::cli {

namespace {

struct SolveOptions : CommonOptions {
    std::string recipe;
    std::string wavelengths = "400:700:10";
    solver::SolverSettings settings;
    ModelOptions model;  // only what add_solution_options() offers: of the default model
};

/// Bytes, from which on a solve says beforehand how much memory it takes.
constexpr std::size_t kMemoryToSay = 1'000'000'000;

/// The solved paint, or the table that the model makes of it.
std::string solution_bytes(const SolveOptions& options, const bsdf::Model& model,
                           const Paint& paint, const SolveSettings& settings) {
    if (!model.makes_table()) return paint.export_solved(settings);
    ProgressBar bar("tabulate", options.quiet);
    return paint.export_table(model, settings, bar.callback());
}

ExitStatus run(const SolveOptions& options) {
    const bsdf::Model model = parse_model_settings(options.model);
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;
    const SolveSettings settings{
        parse_numbers("--wavelength", options.wavelengths, paint::limits::kWavelength),
        options.settings};
    const Paint paint = open_paint(options, options.recipe);
    if (const std::size_t bytes = paint.memory_to_solve(settings); bytes > kMemoryToSay) {
        say(options, fmt::format("{}: takes about {:.1f} GB of memory", options.recipe,
                                 static_cast<double>(bytes) / 1e9));
    }
    const auto solved = [&] {
        ProgressBar bar("solve", options.quiet);
        return paint.solved(settings, bar.callback());
    }();
    say_warnings(options, paint);
    const double solve_s = watch.seconds();
    const std::string bytes = solution_bytes(options, model, paint, settings);
    emit(options, bytes);
    const solver::SolverReport& report = solved->report;
    say(options,
        fmt::format("{}: {} wavelengths, {} + {} nodes, {} orders, {:.0f} ms, {} bytes",
                    options.output, solved->wavelengths_nm().size(), report.exit_nodes,
                    report.inner_nodes, report.orders, 1000 * watch.seconds(), bytes.size()));
    nlohmann::json about = {{"recipe", options.recipe},
                            {"recipe_sha256", paint.recipe_sha256()},
                            {"output", options.output},
                            {"bytes", bytes.size()},
                            {"wavelengths_nm", solved->wavelengths_nm()},
                            {"exit_nodes", report.exit_nodes},
                            {"inner_nodes", report.inner_nodes},
                            {"orders", report.orders},
                            {"unresolved_scattering", report.unresolved_scattering},
                            {"azimuthal_tail", report.azimuthal_tail},
                            {"solve_s", solve_s},
                            {"total_s", watch.seconds()}};
    for (const bsdf::ModelOption& option : model.info().options) {  // "--table" as "table"
        if (option.of_solution)
            about[std::string(option.flag.substr(2))] = option_text(model, option);
    }
    write_report(options, "solve", std::move(about));
    return ExitStatus::ok;
}

}  // namespace

Command add_solve(CLI::App& program) {
    auto options = std::make_shared<SolveOptions>();
    CLI::App* solve =
        program.add_subcommand("solve", "Solve the light transport in a paint and keep the result");
    solve->add_option("RECIPE", options->recipe, "Recipe (TOML)")->required();
    solve->add_option("-o,--output", options->output, "File to write (HDF5)")
        ->required()
        ->type_name("FILE");
    solve->add_option("--wavelength", options->wavelengths, "Vacuum wavelengths, nm")
        ->capture_default_str();
    solve
        ->add_option("--nodes", options->settings.exit_nodes,
                     "Directions that leave the coat, a multiple of 4; 0: from the recipe")
        ->check(in_range(0, solver::SolverSettings::kMaxNodes))
        ->capture_default_str();
    solve
        ->add_option("--inner-nodes", options->settings.inner_nodes,
                     "Directions beyond the critical angle, a multiple of 4; 0: from the recipe")
        ->check(in_range(0, solver::SolverSettings::kMaxNodes))
        ->capture_default_str();
    solve
        ->add_option("--orders", options->settings.max_orders,
                     "Azimuthal Fourier orders at most; 0: from the recipe")
        ->check(in_range(0, solver::SolverSettings::kMaxOrders))
        ->capture_default_str();
    solve
        ->add_option("--tolerance", options->settings.tolerance,
                     "Share of the peak below which the Fourier series may end")
        ->check(in_range(solver::SolverSettings::kToleranceRange))
        ->capture_default_str();
    add_solution_options(*solve, options->model);
    add_input_options(*solve, *options);
    add_set(*solve, *options);
    add_run_options(*solve, *options);
    solve->footer(
        "Everything that takes a recipe takes the solved file too, and is then faster.\n\n"
        "Example:\n  nacre solve paints/tio2-mica-80.toml -o gold.h5");
    return {solve, [options] { return files_of(*options, {options->recipe}); },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
