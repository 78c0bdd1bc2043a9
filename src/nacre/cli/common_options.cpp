#include "nacre/cli/common_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/io/version.h"

namespace nacre::cli {

void add_output(CLI::App& command, CommonOptions& options) {
    command.add_option("-o,--output", options.output, "File to write instead of standard output")
        ->type_name("FILE");
}

void add_quiet(CLI::App& command, CommonOptions& options) {
    command.add_flag("-q,--quiet", options.quiet, "No progress and no messages, errors excepted");
}

void add_report(CLI::App& command, CommonOptions& options) {
    command.add_option("--report", options.report, "JSON file to write about this run")
        ->type_name("FILE");
}

void add_threads(CLI::App& command, CommonOptions& options) {
    command.add_option("--threads", options.threads, "Threads to use; 0 means all")
        ->check(CLI::Range(0, 4096))
        ->capture_default_str();
}

void add_seed(CLI::App& command, CommonOptions& options) {
    command.add_option("--seed", options.seed, "Seed of the random numbers")->capture_default_str();
}

void emit(const CommonOptions& options, const std::string& data) {
    if (!options.output.empty()) {
        write_file_atomically(options.output, data);
        return;
    }
    if (std::fwrite(data.data(), 1, data.size(), stdout) != data.size() ||
        std::fflush(stdout) != 0) {
        throw Error("cannot write to standard output");
    }
}

void write_report(const CommonOptions& options, const std::string& command, nlohmann::json report) {
    if (options.report.empty()) return;
    report["command"] = command;
    report["version"] = io::version();
    // Names come from files that may hold any bytes: what is not UTF-8 is replaced.
    write_file_atomically(
        options.report,
        report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void say(const CommonOptions& options, const std::string& line) {
    if (!options.quiet) fmt::print(stderr, "{}\n", line);
}

}  // namespace nacre::cli
