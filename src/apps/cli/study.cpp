#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "apps/cli/options.h"
#include "apps/study/flakes.h"
#include "apps/study/mir_2022.h"
#include "apps/study/mir_document.h"
#include "apps/study/mir_references.h"
#include "apps/study/sparkle.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"

namespace nacre::cli {

namespace {

struct StudyOptions : CommonOptions {
    std::string study;
    int samples = 1024;
    int size = 512;
    bool quick = false;
    std::vector<int> tables, figures;
    std::vector<std::string> parts;
    std::string references;
    std::vector<std::string> documents;
};

/// Parts of mir-2022 that are neither a table nor a figure.
const std::map<std::string, study::MirPart> kPartNames = {
    {"agreement", study::MirPart::agreement},
    {"antialiasing", study::MirPart::antialiasing},
    {"nacre", study::MirPart::nacre},
    {"quality", study::MirPart::quality}};

std::set<study::MirPart> chosen_parts(const StudyOptions& options) {
    using study::MirPart;
    if (options.tables.empty() && options.figures.empty() && options.parts.empty()) {
        return study::all_mir_parts();
    }
    const MirPart by_table[] = {MirPart::table_1, MirPart::table_2, MirPart::table_3,
                                MirPart::table_4};
    const MirPart by_figure[] = {MirPart::table_1, MirPart::table_2, MirPart::table_4};
    std::set<MirPart> parts;
    for (int table : options.tables) parts.insert(by_table[table - 1]);
    for (int figure : options.figures) parts.insert(by_figure[figure - 2]);
    for (const std::string& part : options.parts) {
        parts.insert(kPartNames.at(part));
    }
    return parts;
}

std::filesystem::path run_mir_2022(const StudyOptions& options, const study::Stage& stage) {
    study::MirSettings settings;
    settings.quick = options.quick;
    settings.size = options.quick ? std::min(options.size, 32) : options.size;
    settings.samples = options.quick ? std::min(options.samples, 8) : options.samples;
    settings.seed = options.seed;
    settings.parts = chosen_parts(options);
    if (settings.samples < 1024 || settings.size < 512) {
        say(options, fmt::format("nacre: scaled down: {0} x {0} pixels at {1} samples each",
                                 settings.size, settings.samples));
    }
    std::filesystem::path written;
    if (!options.references.empty()) {
        settings.folder = options.references;
        written = study::write_references(settings, stage);
    }
    if (options.output.empty()) return written;
    settings.folder = options.output;
    const auto page = study::run_mir_2022(settings, stage);
    if (!options.documents.empty()) {
        const auto results = nlohmann::json::parse(
            read_file(std::filesystem::path(options.output) / "results.json"));
        for (const std::string& file : options.documents) {
            write_file_atomically(file, study::with_tables(read_file(file), file, results));
        }
    }
    return page;
}

/// Of the options that choose parts of mir-2022, none may be given.
void refuse_parts(const StudyOptions& options) {
    const StudyOptions standard;
    if (options.samples != standard.samples || options.size != standard.size ||
        !options.tables.empty() || !options.figures.empty() || !options.parts.empty() ||
        !options.references.empty() || !options.documents.empty()) {
        throw UsageError(
            fmt::format("--spp, --size, --table, --figure, --part, --references and --document "
                        "belong to the study mir-2022, not to {}",
                        options.study));
    }
}

std::filesystem::path run_flakes(const StudyOptions& options, const study::Stage& stage) {
    refuse_parts(options);
    return study::run_flakes(
        {.folder = options.output, .seed = options.seed, .quick = options.quick}, stage);
}

std::filesystem::path run_sparkle(const StudyOptions& options, const study::Stage& stage) {
    refuse_parts(options);
    return study::run_sparkle(
        {.folder = options.output, .seed = options.seed, .quick = options.quick}, stage);
}

using RunStudy = std::filesystem::path (*)(const StudyOptions&, const study::Stage&);
const std::map<std::string, RunStudy> kStudies = {
    {"flakes", run_flakes}, {"mir-2022", run_mir_2022}, {"sparkle", run_sparkle}};

ExitStatus run(const StudyOptions& options) {
    const auto study = kStudies.find(options.study);
    if (study == kStudies.end()) {
        throw UsageError(
            fmt::format("STUDY = {}: must be one of flakes, mir-2022, sparkle", options.study));
    }
    if (options.output.empty() && options.references.empty()) {
        throw UsageError("--output is required");
    }
    if (!options.documents.empty() && options.output.empty()) {
        throw UsageError("--document needs --output");
    }
    for (const std::string& file : options.documents) study::require_markers(read_file(file), file);
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const study::Stage stage = [&](const std::string& label,
                                   const std::function<void(const Progress&)>& work) {
        if (interrupt_requested()) throw study::Interrupted("stopped");
        ProgressBar bar(label, options.quiet);
        work(bar.callback());
    };
    try {
        const auto page = study->second(options, stage);
        say(options, fmt::format("{}", page.string()));
    } catch (const Error&) {
        if (!interrupt_requested()) throw;
        say(options,
            options.study == "sparkle"
                ? "nacre: stopped; no page was written"
                : fmt::format("nacre: stopped; what is finished is kept in {}, and the "
                              "same command goes on from there",
                              options.output.empty() ? options.references : options.output));
        return ExitStatus::failure;
    }
    return ExitStatus::ok;
}

}  // namespace

Command add_study(CLI::App& program) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* study = program.add_subcommand(
        "study", "Reproduce a published comparison, or the evidence for a model");
    study
        ->add_option(
            "STUDY", options->study,
            "mir-2022: Mir, Yildirim and Kurt 2022; flakes: the model nacre against explicit "
            "discs; sparkle: how sparkle and graininess follow from the flakes")
        ->required();
    study->add_option("-o,--output", options->output, "Folder for the report and its pictures")
        ->type_name("DIR");
    study
        ->add_option("--references", options->references,
                     "mir-2022: write converged spectral pictures with standard errors, recipes, "
                     "scenes and checksums to this folder; without --output, nothing else")
        ->type_name("DIR");
    study
        ->add_option("--document", options->documents,
                     "mir-2022: a Markdown file whose tables, between the markers <!-- begin: NAME "
                     "--> and <!-- end: NAME -->, are written from the results (may be repeated)")
        ->type_name("FILE");
    study->add_option("--spp", options->samples, "mir-2022: samples per pixel")
        ->check(in_range(8, 1 << 20))
        ->capture_default_str();
    study->add_option("--size", options->size, "mir-2022: pixels a side")
        ->check(in_range(16, 4096))
        ->capture_default_str();
    study->add_option("--table", options->tables, "mir-2022: only this table (may be repeated)")
        ->check(in_range(1, 4));
    study->add_option("--figure", options->figures, "mir-2022: only this figure (may be repeated)")
        ->check(in_range(2, 4));
    study
        ->add_option("--part", options->parts,
                     "mir-2022: only agreement, antialiasing, nacre or quality (may be repeated)")
        ->check(CLI::IsMember({"agreement", "antialiasing", "nacre", "quality"}));
    study->add_flag("--quick", options->quick,
                    "Tiny pictures (at most 32 pixels, 8 samples), to see that all works");
    add_seed(*study, *options);
    add_threads(*study, *options);
    add_quiet(*study, *options);
    study->footer(
        "Writes DIR/index.html, one self-contained page, and DIR/results.json with every figure.\n"
        "Pictures of mir-2022 and flakes that are there already are not made again: after Ctrl-C "
        "the\nsame command goes on.\n\n"
        "Examples:\n  nacre study mir-2022 -o out/mir-2022 --spp 64\n"
        "  nacre study flakes -o out/flakes\n  nacre study sparkle -o out/sparkle");
    return {study,
            [options] {
                return CommandFiles{.inputs = {},
                                    .files = {},
                                    .folders = {{"--output", options->output},
                                                {"--references", options->references}}};
            },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
