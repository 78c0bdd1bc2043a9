#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/difference_table.h"
#include "apps/cli/instrument_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "apps/cli/plot_files.h"
#include "apps/cli/text_table.h"
#include "apps/cli/tolerance_options.h"
#include "apps/cli/uncertainty_options.h"
#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/io/measurement_file.h"
#include "nacre/measure/difference.h"
#include "nacre/measure/measurement.h"
#include "nacre/nacre.h"

namespace nacre::cli {

namespace {

struct MeasureOptions : CommonOptions {
    std::string sample, versus, weights, format, plots, contributions;
    ToleranceRequest tolerance;
    ModelOptions model;
    InstrumentOptions instrument;
    UncertaintyRequest uncertainty;
    std::optional<std::uint64_t> samples;  // of models that are sampled
};

std::vector<std::string> sampled_models() {
    return models_that([](const bsdf::ModelInfo& model) { return model.can.estimated_values; });
}

/// A paint and the readings on it.
struct Sample {
    Paint paint;
    std::string model;  ///< empty: measured
    Readings readings;

    const Measurement& measurement() const { return readings.measurement; }
};

/// Flop index and colour travel, on stderr.
void say_summary(const MeasureOptions& options, const Sample& sample) {
    const auto flop = measure::flop_index(sample.measurement());
    const measure::ColourTravel travel = measure::colour_travel(sample.measurement());
    std::string line = sample.measurement().name + ": ";
    line += flop ? fmt::format("flop index {:.2f}", *flop) : "no flop index";
    if (travel.path.size() > 1) line += fmt::format(", colour travel {:.1f}", travel.length);
    say(options, line);
}

nlohmann::json sample_json(const Sample& sample) {
    nlohmann::json document = io::measurement_json(sample.measurement());
    document["file"] = sample.paint.file();
    document["recipe_sha256"] = sample.paint.recipe_sha256();
    document["model"] = sample.model;
    for (std::size_t i = 0; i < sample.readings.standard_error.size(); ++i) {
        document["readings"][i]["standard_error"] = sample.readings.standard_error[i];
    }
    return document;
}

/// CSV for programs, a table for people: without --format, by who reads and what is asked of CSV.
bool wants_text(const MeasureOptions& options) {
    if (!options.format.empty()) return options.format == "text";
    if (options.decimal_comma || options.byte_order_mark) return false;
    return options.output.empty() && isatty(STDOUT_FILENO);
}

/// With standard deviations behind the values, where they are known.
std::string text_of(const Sample& sample, const std::optional<Uncertainty>& uncertainty) {
    std::vector<std::vector<std::string>> rows = {{"angle", "L*", "a*", "b*", "C*", "h"}};
    const Measurement& measurement = sample.measurement();
    for (std::size_t i = 0; i < measurement.readings.size(); ++i) {
        const measure::Reading& reading = measurement.readings[i];
        const double values[] = {reading.lab[0], reading.lab[1], reading.lab[2],
                                 measure::chroma(reading.lab), measure::hue_deg(reading.lab)};
        std::optional<double> deviations[5];
        if (uncertainty) {
            const fit::Spread& spread = uncertainty->readings.at(i).best();
            const Vec3d lab = spread.lab();
            deviations[0] = lab[0];
            deviations[1] = lab[1];
            deviations[2] = lab[2];
            deviations[3] = spread.chroma;
            deviations[4] = spread.hue_deg;
        }
        std::vector<std::string> row = {reading.geometry.name};
        for (int k = 0; k < 5; ++k) {
            const int digits = k < 4 ? 2 : 1;
            row.push_back(rounded(values[k], digits));
            if (deviations[k]) row.back() += " ± " + rounded(*deviations[k], digits);
        }
        rows.push_back(std::move(row));
    }
    return text_table(rows);
}

std::string csv_of(const Sample& sample, const std::optional<Uncertainty>& uncertainty) {
    if (!uncertainty) return sample.readings.csv();
    return io::measurement_csv(sample.measurement(), sample.readings.standard_error,
                               uncertainty_columns(*uncertainty));
}

std::string dumped(const nlohmann::json& document) {
    return document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

ExitStatus compare(const MeasureOptions& options, const Sample& sample, const Sample& standard,
                   const Stopwatch& watch) {
    const measure::Difference difference = measure::difference(
        standard.measurement(), sample.measurement(), parse_weights(options.weights));
    std::optional<measure::Verdict> verdict;
    if (const auto tolerance = parse_tolerance(options.tolerance)) {
        verdict = measure::judge(difference, *tolerance);
    }
    nlohmann::json document = difference_json(difference, verdict);
    std::vector<FileContents> beside;
    if (!options.plots.empty()) {
        beside = plot_files(options.plots, datasheet::measurement_plots(sample.measurement(),
                                                                        &standard.measurement()));
    }
    if (options.format == "json") {
        nlohmann::json whole = document;
        whole["sample"] = sample_json(sample);
        whole["standard"] = sample_json(standard);
        emit_together(options, dumped(whole), std::move(beside));
    } else if (wants_text(options)) {
        emit_together(options, difference_text(difference, verdict), std::move(beside));
    } else {
        emit_table(options, difference_csv(difference, verdict), std::move(beside));
    }
    say_summary(options, sample);
    say_summary(options, standard);
    say(options, fmt::format("Delta E 2000 over {} angles: mean {:.2f}, greatest {:.2f}",
                             difference.angles.size(), difference.mean_delta_e_2000,
                             difference.max_delta_e_2000));
    document["sample"] = sample.paint.file();
    document["standard"] = standard.paint.file();
    document["total_s"] = watch.seconds();
    write_report(options, "measure", document);
    return status_of(options, verdict);
}

ExitStatus run(const MeasureOptions& options) {
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;
    const bool writes_csv = options.format.empty() || options.format == "csv";
    if (!writes_csv && options.contributions.empty()) refuse_table_options(options);
    if (options.versus.empty() && !options.weights.empty()) {
        throw UsageError("--weights belongs to --versus");
    }
    if (options.versus.empty() && options.tolerance.asks()) {
        throw UsageError("--formula and --tolerance belong to --versus");
    }
    parse_tolerance(options.tolerance);  // before any work
    if (!options.versus.empty() && (options.uncertainty.asks() || !options.contributions.empty())) {
        throw UsageError(
            "--uncertainty and --contributions do not go with --versus: measure both paints on "
            "their own");
    }
    parse_weights(options.weights);
    InstrumentRequest instrument = parse_instrument(options.instrument);
    const bsdf::ModelInfo& model = parse_model(options.model);
    if (options.samples) {
        if (!model.can.estimated_values) {
            throw UsageError(
                fmt::format("--samples belongs to --model {}; other models are not sampled",
                            fmt::join(sampled_models(), ", ")));
        }
        instrument.settings.walks = *options.samples;
    }
    instrument.settings.seed = options.seed;
    const auto sample_of = [&](const Paint& paint, Readings readings) {
        say_warnings(options, paint);
        warn_of_coarse_spectra(options, readings.measurement);
        return Sample{paint, paint.is_measured() ? std::string() : options.model.model,
                      std::move(readings)};
    };
    const Paint paint = open_paint(options, options.sample);

    if (options.versus.empty()) {
        instrument.settings.model = model_for({&paint}, options.model, true);
        // First, so that a wrong number is refused before the work.
        const std::optional<Uncertainty> uncertainty = uncertainty_of(
            options, options.uncertainty, paint, instrument.geometries, instrument.settings);
        if (!uncertainty && !options.contributions.empty()) {
            throw UsageError(
                "--contributions belongs to --uncertainty, or to a recipe with a table "
                "[uncertainty]");
        }
        ProgressBar bar("measure", options.quiet);
        const Sample sample = sample_of(
            paint, paint.measure(instrument.geometries, instrument.settings, bar.callback()));
        nlohmann::json report = sample_json(sample);
        if (uncertainty) report["uncertainty"] = uncertainty_json(*uncertainty);
        std::vector<FileContents> beside;
        if (!options.plots.empty()) {
            beside = plot_files(
                options.plots, datasheet::measurement_plots(sample.measurement(), nullptr,
                                                            uncertainty ? &*uncertainty : nullptr));
        }
        if (!options.contributions.empty()) {
            beside.push_back(
                {options.contributions, table_text(options, contributions_csv(*uncertainty))});
        }
        if (options.format == "json") {
            emit_together(options, dumped(report), std::move(beside));
        } else if (wants_text(options)) {
            emit_together(options, text_of(sample, uncertainty), std::move(beside));
        } else {
            emit_table(options, csv_of(sample, uncertainty), std::move(beside));
        }
        say_summary(options, sample);
        if (uncertainty) say_uncertainty(options, *uncertainty);
        report["total_s"] = watch.seconds();
        write_report(options, "measure", report);
        return ExitStatus::ok;
    }
    const Paint versus = open_input(options, options.versus);
    instrument.settings.model = model_for({&paint, &versus}, options.model, true);
    ProgressBar bar("measure", options.quiet);
    auto [sample, standard] =
        measure_alike(paint, versus, instrument.geometries, instrument.settings, bar.callback());
    return compare(options, sample_of(paint, std::move(sample)),
                   sample_of(versus, std::move(standard)), watch);
}

CommandFiles files(const MeasureOptions& options) {
    CommandFiles files =
        files_of(options, {options.sample, options.versus, options.instrument.geometry},
                 options.format == "json" ? "JSON" : "CSV");
    files.files.push_back({"--contributions", options.contributions, false, "CSV"});
    files.folders = {{"--plots", options.plots, plot_file_names()}};
    return files;
}

}  // namespace

Command add_measure(CLI::App& program) {
    auto options = std::make_shared<MeasureOptions>();
    CLI::App* command = program.add_subcommand(
        "measure", "Hold a virtual multi-angle spectrophotometer against a paint");
    command
        ->add_option("SAMPLE", options->sample,
                     "Recipe (TOML), solved paint or table (HDF5), measured BRDF (.bsdf, .binary), "
                     "or measured "
                     "colours (CSV, JSON, CGATS; FILE#SAMPLE where it holds several)")
        ->required();
    add_instrument_options(*command, options->instrument);
    add_model_options(*command, options->model);
    command
        ->add_option("--samples", options->samples,
                     fmt::format("With --model {}: walks per lamp; standard errors are in columns "
                                 "SE<nm> [262144]",
                                 fmt::join(sampled_models(), ", ")))
        ->check(in_range(std::uint64_t{2}, std::uint64_t{1'000'000'000'000}));
    command->add_option("--versus", options->versus,
                        "Standard to compare with: a recipe or a measured file");
    command->add_option("--weights", options->weights,
                        "With --versus: weights in the mean as NAME=W,...; others weigh 1");
    add_tolerance_options(*command, options->tolerance);
    command
        ->add_option("--format", options->format,
                     "csv, json, or text for people [text on a terminal, else csv]")
        ->check(CLI::IsMember({"csv", "json", "text"}));
    command
        ->add_option("--plots", options->plots,
                     "Folder for curves, as SVG and PNG: lightness, travel and spectra")
        ->type_name("DIR");
    add_uncertainty_options(*command, options->uncertainty);
    command
        ->add_option("--contributions", options->contributions,
                     "Table (CSV) of what each uncertain number contributes to each quantity")
        ->type_name("FILE");
    add_table_output(*command, *options);
    add_seed(*command, *options);
    add_input_options(*command, *options);
    add_set(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "On a terminal a table for people. Else CSV: "
        "geometry,theta_i,aspecular_deg,L,a,b,C,h,X,Y,Z, a column R<nm> a wavelength, "
        "and\n"
        "the conditions. Reflectance is relative to the perfect diffuser, which has Y = 100; the\n"
        "specular reflection of a smooth interface is left out. Flop index and colour travel go to "
        "stderr and "
        "into\n"
        "JSON. With --versus: the colour difference at each angle. With --uncertainty or a table\n"
        "[uncertainty] in the recipe: columns L_sd,a_sd,b_sd,C_sd,h_sd, covariances and SD<nm>\n"
        "(docs/uncertainty.md).\n\n"
        "Examples:\n"
        "  nacre measure paints/tio2-mica-80.toml --geometry byk-mac\n"
        "  nacre measure paints/tio2-mica-80.toml --versus paints/tio2-mica-110.toml \\\n"
        "                --geometry 45as15,45as45,45as110 --illuminant A --observer 2");
    return {command, [options] { return files(*options); }, [options] { return run(*options); }};
}

}  // namespace nacre::cli
