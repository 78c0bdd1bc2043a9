#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/brdf_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/nacre.h"
#include "nacre/paint/recipe.h"

namespace nacre::cli {

namespace {

constexpr std::size_t kMaxRows = 1'000'000;

struct ReferenceOptions : BrdfOptions {
    std::uint64_t samples = std::uint64_t{1} << 20;
};

ExitStatus run(const ReferenceOptions& options) {
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;
    const std::vector<Direction> incident = parse_directions("--incident", options.incident);
    const std::vector<Direction> outgoing = parse_directions("--outgoing", options.outgoing);
    const std::vector<double> wavelengths =
        parse_numbers("--wavelength", options.wavelengths, paint::limits::kWavelength);
    const std::size_t rows = incident.size() * outgoing.size() * wavelengths.size();
    if (rows > kMaxRows) {
        throw UsageError(fmt::format("{} rows are too many: at most {}", rows, kMaxRows));
    }
    const Paint paint = open_paint(options, options.recipe);
    const std::vector<Estimate> estimates = [&] {
        ProgressBar bar("reference", options.quiet);
        return paint.reference(
            incident, outgoing,
            {wavelengths, {options.samples, options.seed, parse_part(options.part)}},
            bar.callback());
    }();
    std::string table = "theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf,stderr\n";
    std::size_t row = 0;
    for (const Direction& in : incident) {
        for (const Direction& out : outgoing) {
            for (double wavelength : wavelengths) {
                const Estimate& e = estimates[row++];
                table +=
                    fmt::format("{},{},{},{},{},{:.9g},{:.3g}\n", in.theta_deg, in.phi_deg,
                                out.theta_deg, out.phi_deg, wavelength, e.value, e.standard_error);
            }
        }
    }
    emit_table(options, table);
    write_report(options, "reference",
                 {{"recipe", options.recipe},
                  {"recipe_sha256", paint.recipe_sha256()},
                  {"samples", options.samples},
                  {"seed", options.seed},
                  {"part", options.part},
                  {"total_s", watch.seconds()}});
    return ExitStatus::ok;
}

}  // namespace

Command add_reference(CLI::App& program) {
    auto options = std::make_shared<ReferenceOptions>();
    options->wavelengths = "400:700:10";
    CLI::App* command = program.add_subcommand(
        "reference", "BRDF of a paint by a random walk that is independent of the solver");
    add_brdf_options(*command, *options);
    command->add_option("--wavelength", options->wavelengths, "Vacuum wavelengths, nm")
        ->capture_default_str();
    command->add_option("--samples", options->samples, "Walks per incident direction")
        ->check(in_range<std::uint64_t>(montecarlo::ReferenceSettings::kSamplesRange))
        ->capture_default_str();
    add_table_output(*command, *options);
    add_seed(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "Writes CSV: theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf,stderr; stderr is the "
        "standard\n"
        "error of brdf. For a given seed the result does not depend on the number of threads.\n\n"
        "Example:\n"
        "  nacre reference paints/metallic-gray.toml --incident 45 --outgoing 45,180 \\\n"
        "                  --wavelength 550 --samples 1000000");
    return {command, [options] { return files_of(*options, {options->recipe}, "CSV"); },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
