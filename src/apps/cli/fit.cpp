#include "nacre/fit/fit.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/difference_table.h"
#include "apps/cli/fit_report.h"
#include "apps/cli/instrument_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/fit/fitted_uncertainty.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/recipe_text.h"
#include "nacre/library.h"
#include "nacre/nacre.h"

namespace nacre::cli {

namespace {

constexpr Range kNoise{1e-6, 100, "Delta E"}, kEqual{1e-3, 100, "Delta E"};
/// Numbers passed over whose reasons are printed, at most.
constexpr std::size_t kMaxSkippedShown = 12;

struct FitOptions : CommonOptions {
    std::string standard, start, library, free, weights, also, noise, format = "text";
    std::size_t constructions = 4;
    bool constructions_given = false;
    double equal_delta_e = 0.3, matched_delta_e = fit::FitOptions().matched_delta_e;
    int starts = 8;
    bool overwrite = false, with_uncertainty = false;
    ModelOptions model;
    InstrumentOptions instrument;
};

/// The numbers that --free means, or without it those of the recipe's table [fit].
fit::FreeKeys free_keys(const FitOptions& options, const Paint& start,
                        const FitSettings& settings) {
    if (options.free.empty() && start.bounds().empty()) {
        throw UsageError(fmt::format(
            "--free: say which numbers of {} are free, or bound them there in a table [fit]",
            options.start));
    }
    std::vector<std::string> patterns;
    if (!options.free.empty()) {
        for (const std::string_view pattern : split(options.free, ',')) {
            patterns.emplace_back(pattern);
        }
    }
    try {
        return start.free_keys(patterns, settings, [](double) { return !interrupt_requested(); });
    } catch (const DomainError& error) {
        throw UsageError(fmt::format("--free: {}: {}", options.start, error.what()));
    }
}

void say_skipped(const FitOptions& options, const std::vector<fit::SkippedNumber>& skipped) {
    for (std::size_t i = 0; i < skipped.size() && i < kMaxSkippedShown; ++i) {
        say(options, fmt::format("--free passes over {}: {}", skipped[i].key, skipped[i].why));
    }
    if (skipped.size() > kMaxSkippedShown) {
        say(options, fmt::format("--free passes over {} more", skipped.size() - kMaxSkippedShown));
    }
}

FitSettings parse(const FitOptions& options) {
    FitSettings parsed;
    parsed.starts = options.starts;
    parsed.seed = options.seed;
    parsed.equal_delta_e = options.equal_delta_e;
    parsed.matched_delta_e = options.matched_delta_e;
    parsed.target.weights = parse_weights(options.weights);
    if (!options.noise.empty()) {
        parsed.noise_delta_e = parse_number("--noise", options.noise, kNoise);
    }
    return parsed;
}

/// --also: the standard's own light first.
void add_lights(const FitOptions& options, const measure::Measurement& standard,
                fit::TargetOptions& target) {
    if (options.also.empty()) return;
    target.illuminants = {standard.conditions.illuminant};
    for (const std::string_view name : split(options.also, ',')) {
        try {
            target.illuminants.push_back(spectra::parse_illuminant(std::string(name)));
        } catch (const InputError& error) {
            throw UsageError(fmt::format("--also = {}: {}", options.also, error.what()));
        }
    }
}

/// The standard as it is measured or, of a paint, seen by the instrument.
Measurement wanted_of(const FitOptions& options, const Paint& standard,
                      InstrumentRequest& instrument) {
    ModelOptions of_standard = options.model;
    of_standard.model_given = false;  // also for the paint that is sought
    if (standard.kind() == Kind::measured_colours) of_standard = {};
    instrument.settings.model = model_for({&standard}, of_standard, true);
    ProgressBar bar("measure", options.quiet);
    Measurement wanted =
        standard.measure(instrument.geometries, instrument.settings, bar.callback()).measurement;
    warn_of_coarse_spectra(options, wanted);
    return wanted;
}

/// Which constructions of the library can match, and which cannot.
std::string constructions_text(const std::vector<ConstructionMatch>& matches) {
    std::string text =
        fmt::format("{:>9} {:>9}  {:<8} {}\n", "nearest", "fitted", "", "construction");
    for (const ConstructionMatch& m : matches) {
        text += fmt::format("{:>9.3f} {:>9.3f}  {:<8} {} (from {})\n", m.start.mean_delta_e_2000,
                            m.match.difference.mean_delta_e_2000,
                            m.match.matched() ? "matches" : "does not", m.start.construction,
                            m.start.folder.filename().string().substr(0, 8));
    }
    return text +
           "Mean Delta E 2000 of the library's nearest record and of the paint fitted from it.\n\n";
}

nlohmann::json constructions_json(const std::vector<ConstructionMatch>& matches) {
    nlohmann::json all = nlohmann::json::array();
    for (const ConstructionMatch& m : matches) {
        all.push_back({{"construction", m.start.construction},
                       {"record", m.start.folder.string()},
                       {"name", m.start.name},
                       {"nearest_mean_delta_e_2000", m.start.mean_delta_e_2000},
                       {"mean_delta_e_2000", m.match.difference.mean_delta_e_2000},
                       {"matched", m.match.matched()},
                       {"recipe_sha256", io::recipe_hash(m.match.recipe)}});
    }
    return all;
}

/// The fitted recipe, as the text of the start with other numbers.
/// @return why it is none of the start's text; else empty
std::string write_found(const FitOptions& options, const Paint& paint) {
    if (options.output.empty()) return {};
    const io::RecipeText written = paint.recipe_text(references_of(options, options.output));
    if (!written.rewritten.empty()) {
        warn(options, fmt::format("{} is written anew, without the comments of {}: {}",
                                  options.output, paint.file(), written.rewritten));
    }
    write_file_atomically(options.output, written.text);
    return written.rewritten;
}

/// The match with what its fit says of its own errors as the table [uncertainty].
Paint with_errors(const FitOptions& options, const Match& match) {
    const fit::FittedUncertainty known = fit::fitted_uncertainty(match);
    for (const std::string& key : known.not_determined) {
        say(options,
            fmt::format("--with-uncertainty: {} has no standard error: {}", key,
                        match.certainty.noise_delta_e ? "the colours do not determine it"
                                                      : "the noise is not known; give --noise"));
    }
    return match.paint.with_uncertainty(known.deviations, known.correlations);
}

/// The paint that --start names, and which of its numbers are free.
struct Start {
    Paint paint;
    fit::FreeKeys free;
};

/// The paint of --start; none with --library.
std::optional<Paint> open_start(const FitOptions& options) {
    if (options.start.empty() == options.library.empty()) {
        throw UsageError(
            "give --start, the recipe to start from, or --library, a folder of nacre-library");
    }
    if (options.library.empty() && options.constructions_given) {
        throw UsageError("--constructions belongs to --library");
    }
    if (!options.library.empty()) {
        if (options.free.empty()) return std::nullopt;
        throw UsageError("--free belongs to --start: a library's sweeps say what varies");
    }
    Paint paint = open_paint(options, options.start);
    if (paint.recipe().layers.empty()) {
        throw InputError(fmt::format("{}: layer: is missing; a fit needs at least one [[layer]]",
                                     options.start));
    }
    return paint;
}

Start with_free_numbers(const FitOptions& options, Paint paint, const FitSettings& how) {
    fit::FreeKeys free = free_keys(options, paint, how);
    fit::FreeNumbers(paint.recipe(), free.keys, paint.bounds());  // before any work
    say_skipped(options, free.skipped);
    return {std::move(paint), std::move(free)};
}

/// The best match, and what the report and the text say besides.
struct Found {
    Match match;
    nlohmann::json report;
    std::string text;
    int solves = 0;  ///< of all constructions that were tried
    double seconds = 0;
};

Found fit_from(const FitOptions& options, const Start& start, const Measurement& wanted,
               const FitSettings& how, const Progress& progress) {
    Match match = start.paint.fit(wanted, start.free.keys, how, progress);
    nlohmann::json report{{"start", options.start}};
    for (const fit::SkippedNumber& skipped : start.free.skipped) {
        report["skipped"].push_back({{"key", skipped.key}, {"why", skipped.why}});
    }
    const fit::Effort effort = match.effort;
    return {std::move(match), std::move(report), "", effort.solves, effort.seconds};
}

Found fit_from_library(const FitOptions& options, const Measurement& wanted, const FitSettings& how,
                       const Progress& progress) {
    const std::vector<ConstructionMatch> matches =
        nacre::fit_from_library(options.library, wanted, options.constructions, how, progress);
    Found found{matches.front().match,
                {{"library", options.library}, {"constructions", constructions_json(matches)}},
                constructions_text(matches)};
    for (const ConstructionMatch& tried : matches) {
        found.solves += tried.match.effort.solves;
        found.seconds += tried.match.effort.seconds;
    }
    return found;
}

ExitStatus run(const FitOptions& options) {
    FitSettings how = parse(options);
    InstrumentRequest instrument = parse_instrument(options.instrument);
    instrument.settings.seed = options.seed;
    const Model model = parse_model_settings(options.model);
    how.target.hot_spot = model.shows_hot_spot();
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    std::optional<Paint> paint = open_start(options);
    const Paint standard = open_input(options, options.standard);
    std::optional<Start> start;
    if (paint) start = with_free_numbers(options, *std::move(paint), how);
    require_part_in_fit(model, standard);
    const Measurement wanted = wanted_of(options, standard, instrument);
    say_warnings(options, standard);
    add_lights(options, wanted, how.target);

    std::optional<ProgressBar> bar(std::in_place, "fit", options.quiet);
    const Found found = start ? fit_from(options, *start, wanted, how, bar->callback())
                              : fit_from_library(options, wanted, how, bar->callback());
    bar.reset();
    const Match& match = found.match;

    nlohmann::json document = fit_json(match);
    document.update(found.report);
    document["standard"] = standard.file();
    document["model"] = options.model.model;
    document["hot_spot"] = how.target.hot_spot;
    document["recipe_sha256"] = io::recipe_hash(match.recipe);
    throw_if_stopped();
    document["rewritten"] =
        write_found(options, options.with_uncertainty ? with_errors(options, match) : match.paint);
    CommonOptions to_stdout = options;
    to_stdout.output.clear();
    emit(to_stdout,
         options.format == "text"
             ? found.text + fit_text(match)
             : document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    say(options, fmt::format("{} solves, {:.1f} s", found.solves, found.seconds));
    write_report(options, "fit", document);
    return match.matched() ? ExitStatus::ok : ExitStatus::comparison_failed;
}

CommandFiles files(const FitOptions& options) {
    CommandFiles files =
        files_of(options, {options.standard, options.start, options.instrument.geometry});
    if (options.with_uncertainty && options.output.empty()) {
        throw UsageError(
            "--with-uncertainty belongs to --output: it adds to what is written there");
    }
    if (options.overwrite && options.output.empty()) {
        throw UsageError("--overwrite belongs to --output: it lets that be the start recipe");
    }
    files.prints = true;
    for (Output& output : files.files) {
        if (output.option != "--output") continue;
        output.may_replace = options.start;
        output.overwrite = options.overwrite;
    }
    return files;
}

}  // namespace

Command add_fit(CLI::App& program) {
    auto options = std::make_shared<FitOptions>();
    CLI::App* command =
        program.add_subcommand("fit", "Find the composition whose colours match a standard");
    command
        ->add_option("STANDARD", options->standard,
                     "What to match: a measured file (CSV, JSON), a recipe or a solved paint")
        ->required();
    command->add_option("--start", options->start, "Recipe (TOML) to start from");
    command
        ->add_option("--library", options->library,
                     "In place of --start: a folder made by nacre-library; the fit starts from the "
                     "nearest record of each of its nearest constructions")
        ->type_name("FOLDER");
    command
        ->add_option("--constructions", options->constructions,
                     "With --library: how many constructions are fitted; four times as many are "
                     "fitted roughly before")
        ->check(in_range(1, 100))
        ->each([options](const std::string&) { options->constructions_given = true; })
        ->capture_default_str();
    command->add_option("--free", options->free,
                        "Numbers to turn, by key or the end of a key; * stands for any text "
                        "[those of the recipe's table [fit]]");
    add_instrument_options(*command, options->instrument);
    command->add_option("--also", options->also,
                        "More illuminants under which colours are to match, as in A,FL11; needs "
                        "spectra");
    command->add_option("--weights", options->weights,
                        "Weights of geometries as NAME=W,...; others weigh 1");
    command->add_option("--noise", options->noise,
                        "Standard deviation of the standard's colours, Delta E in each component "
                        "[from the residual]");
    command
        ->add_option("--equal", options->equal_delta_e,
                     "Mean Delta E 2000 within which compositions count as equal")
        ->check(in_range(kEqual.lo, kEqual.hi))
        ->capture_default_str();
    command
        ->add_option("--within", options->matched_delta_e,
                     "Mean Delta E 2000 up to which the standard counts as matched; beyond, the "
                     "exit status is 4")
        ->check(in_range(kEqual.lo, kEqual.hi))
        ->capture_default_str();
    command->add_option("--starts", options->starts, "Descents from different places")
        ->check(in_range(1, fit::FitOptions::kMaxStarts))
        ->capture_default_str();
    command->add_option("--format", options->format, "text or json, on standard output")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    command->add_option("-o,--output", options->output, "Fitted recipe (TOML) to write")
        ->type_name("FILE");
    command->add_flag("--overwrite", options->overwrite,
                      "Let -o replace the start recipe; without it, that is refused");
    command->add_flag("--with-uncertainty", options->with_uncertainty,
                      "Say in the table [uncertainty] of -o how well the found numbers are known: "
                      "their standard errors and the correlations of these");
    add_model_options(*command, options->model);
    add_seed(*command, *options);
    add_input_options(*command, *options);
    add_set(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "Bounds come from the table [fit] of the starting recipe; without them a third to three\n"
        "times the start (docs/fit.md). --model is what a STANDARD that is a recipe is seen by; "
        "the\n"
        "paint that is sought is seen by nacre with its hot spot if it is that, else by "
        "microflake.\n"
        "Ctrl-C stops the fit; nothing is written then. A standard that is not matched ends with\n"
        "status 4, what is missing and what might help; everything is written all the same. The\n"
        "fitted recipe keeps the comments of the start.\n\n"
        "Example: how thick the film of a pearl is\n"
        "  nacre fit paints/tio2-mica-110.toml --start paints/tio2-mica-80.toml \\\n"
        "            --free 'coats[0].thickness_nm' -o fitted.toml");
    return {command, [options] { return files(*options); }, [options] { return run(*options); }};
}

}  // namespace nacre::cli
