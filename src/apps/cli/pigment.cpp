#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "apps/cli/plot_files.h"
#include "apps/datasheet/drawdown_plots.h"
#include "nacre/core/csv.h"
#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/fit/drawdown.h"
#include "nacre/io/drawdown_file.h"
#include "nacre/io/pigment_file.h"

namespace nacre::cli {

namespace {

struct PigmentOptions : CommonOptions {
    std::string drawdown, white, name, table, plots;
    std::string geometry = "d8-included", ior = "1.5";
    double anisotropy = 0;
    std::optional<double> noise;
    bool matt_ground = false;
};

std::string error_text(const std::optional<double>& error) {
    return error && std::isfinite(*error) ? fmt::format("{:.4g}", *error) : std::string();
}

/// Coefficients, their errors, the constants of Kubelka and Munk, and what is left of each reading.
std::string table_csv(const fit::PigmentEstimate& estimate, double anisotropy) {
    std::string csv =
        "wavelength_nm,scattering_per_mm,scattering_error,absorption_per_mm,absorption_error,"
        "K_per_mm,S_per_mm";
    for (const fit::DrawdownResidual& residual : estimate.residuals) {
        csv += "," + csv_cell(fmt::format("residual {} {}{}", residual.thickness_text(),
                                          residual.volume_fraction, residual.place_text()));
    }
    csv += '\n';
    for (std::size_t i = 0; i < estimate.wavelengths_nm.size(); ++i) {
        const double s = estimate.scattering_per_mm[i], a = estimate.absorption_per_mm[i];
        csv += fmt::format("{},{:.6g},{},{:.6g},{},{:.6g},{:.6g}", estimate.wavelengths_nm[i], s,
                           error_text(estimate.scattering_error[i]), a,
                           error_text(estimate.absorption_error[i]), 2 * a,
                           0.75 * (1 - anisotropy) * s);
        for (const fit::DrawdownResidual& residual : estimate.residuals) {
            csv += fmt::format(",{:.3g}", residual.modelled[i] - residual.measured[i]);
        }
        csv += '\n';
    }
    return csv;
}

void say_outcome(const PigmentOptions& options, const fit::PigmentEstimate& estimate) {
    for (const fit::DrawdownResidual& residual : estimate.residuals) {
        if (!residual.delta_e_2000) continue;
        say(options, fmt::format("{}, {:.4g} %{}: Delta E 2000 {:.2f} between the reading and the "
                                 "pigment",
                                 residual.thickness_text(), 100 * residual.volume_fraction,
                                 residual.place_text(), *residual.delta_e_2000));
    }
    say(options,
        fmt::format(
            "residual {:.2g} (root mean square){}", estimate.rms_residual,
            estimate.noise ? std::string() : "; as many readings as numbers: errors need --noise"));
    if (!estimate.hidden_nm.empty()) {
        say(options,
            fmt::format("at {} of {} wavelengths ({} to {} nm) the paint hides its grounds: only "
                        "the ratio of absorption and scattering shows there; a thinner drawdown, "
                        "or one with less pigment, would tell them apart",
                        estimate.hidden_nm.size(), estimate.wavelengths_nm.size(),
                        estimate.hidden_nm.front(), estimate.hidden_nm.back()));
    }
    if (estimate.scattering_assumed) {
        say(options,
            "one ratio of pigment to white: only absorption can be told; scattering is taken as 0. "
            "The masstone, or a tint of much more pigment, would tell it");
    } else if (!estimate.absorption_only_nm.empty()) {
        say(options,
            fmt::format("at {} of {} wavelengths ({} to {} nm) only absorption shows, as the white "
                        "scatters for both: scattering is known to no better than half of itself; "
                        "the masstone, or a tint of much more pigment, would tell it",
                        estimate.absorption_only_nm.size(), estimate.wavelengths_nm.size(),
                        estimate.absorption_only_nm.front(), estimate.absorption_only_nm.back()));
    }
}

ExitStatus run(const PigmentOptions& options) {
    if (options.table.empty()) refuse_table_options(options);
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const measure::Drawdown drawdown = io::read_drawdown(options.drawdown);
    const std::vector<std::string> words = fit::drawdown_geometry_words();
    fit::DrawdownSettings settings;
    settings.geometry = static_cast<measure::DrawdownGeometry>(
        std::find(words.begin(), words.end(), options.geometry) - words.begin());
    settings.binder = open_material("--ior", options.ior);
    settings.anisotropy = options.anisotropy;
    settings.matt_ground = options.matt_ground;
    settings.noise = options.noise;
    if (!options.white.empty()) settings.white = io::find_white(options.white);

    fit::PigmentEstimate estimate;
    {
        ProgressBar bar("pigment", options.quiet);
        try {
            estimate = fit::estimate_pigment(drawdown, settings, bar.callback());
        } catch (const DomainError& error) {
            throw InputError(options.drawdown + ": " + error.what());
        }
    }
    const std::string name = options.name.empty() ? "pigment of " + options.drawdown : options.name;
    std::string source =
        fmt::format("nacre pigment of {}, {}, binder {}, {}rms residual {:.2g}", options.drawdown,
                    options.geometry, options.ior,
                    options.white.empty() ? std::string() : "white " + options.white + ", ",
                    estimate.rms_residual);
    std::vector<FileContents> beside;
    if (!options.plots.empty()) {
        beside = plot_files(options.plots, datasheet::drawdown_plots(estimate));
    }
    if (!options.table.empty()) {
        beside.push_back(
            {options.table, table_text(options, table_csv(estimate, options.anisotropy))});
    }
    emit_together(options,
                  io::write_pigment_file({estimate.pigment(name, options.anisotropy), source}),
                  std::move(beside));
    say_outcome(options, estimate);
    return ExitStatus::ok;
}

}  // namespace

Command add_pigment(CLI::App& program) {
    auto options = std::make_shared<PigmentOptions>();
    CLI::App* pigment = program.add_subcommand(
        "pigment", "A pigment's coefficients from drawdowns over black and white, or from tints");
    pigment
        ->add_option("DRAWDOWN", options->drawdown,
                     "CSV with the columns ground, thickness_um (0: the bare ground; or opaque), "
                     "volume_fraction, of tints white_volume_fraction, and one for each wavelength")
        ->required();
    pigment
        ->add_option("--white", options->white,
                     "The white of tints: a pigment that ships, such as rutile-white, or a file of "
                     "one")
        ->type_name("NAME|FILE");
    pigment
        ->add_option("--geometry", options->geometry,
                     "How it was read: d8-included (sphere, with gloss), d8-excluded, 45-0")
        ->check(CLI::IsMember(fit::drawdown_geometry_words()))
        ->capture_default_str();
    pigment->add_option("--ior", options->ior, "Binder: an index, or the name of a material")
        ->capture_default_str();
    pigment
        ->add_option("--anisotropy", options->anisotropy,
                     "g of the pigment, which a drawdown does not determine")
        ->capture_default_str();
    pigment->add_flag("--matt-ground", options->matt_ground,
                      "The bare grounds have no glossy surface");
    pigment->add_option("--noise", options->noise,
                        "Standard deviation of a reading; without it, from the residuals");
    pigment->add_option("--name", options->name, "What people call the pigment");
    pigment->add_option("--table", options->table,
                        "CSV of coefficients, errors, K and S, and residuals");
    pigment->add_option("--plots", options->plots,
                        "Folder for coefficients and reflectances as SVG and PNG");
    add_output(*pigment, *options);
    add_table_format(*pigment, *options);
    add_quiet(*pigment, *options);
    add_threads(*pigment, *options);
    pigment->footer(
        "Writes TOML that a recipe names by `from` in [[layer.pigment]]. Each wavelength is "
        "solved\n"
        "exactly, surface and all orders of scattering, for the coefficients that read as "
        "measured.\n\n"
        "Example:\n"
        "  nacre pigment blue.csv -o blue.toml --table blue-table.csv\n"
        "  nacre pigment tints.csv --white rutile-white -o blue.toml");
    return {pigment,
            [options] {
                CommandFiles files =
                    files_of(*options, {options->drawdown, options->ior, options->white});
                files.files.push_back({"--table", options->table, false, "CSV"});
                files.folders = {
                    {"--plots", options->plots, plot_file_names(datasheet::kDrawdownPlots)}};
                return files;
            },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
