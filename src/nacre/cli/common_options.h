#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace CLI {
class App;
}

// What several commands have in common: where results go, and how much is said meanwhile.

namespace nacre::cli {

struct CommonOptions {
    int threads = 0;         ///< 0: all
    std::uint64_t seed = 0;  ///< of random numbers
    bool quiet = false;      ///< no progress, no messages other than errors
    std::string report;      ///< JSON file about the run; empty: none
    std::string output;      ///< empty: stdout
};

void add_output(CLI::App& command, CommonOptions& options);  ///< -o, --output
void add_quiet(CLI::App& command, CommonOptions& options);
void add_report(CLI::App& command, CommonOptions& options);
void add_threads(CLI::App& command, CommonOptions& options);
void add_seed(CLI::App& command, CommonOptions& options);

/// Data to the output file, whole or not at all, or to stdout.
/// @throws Error if they cannot be written
void emit(const CommonOptions& options, const std::string& data);

/// Writes the report, if one was asked for, with "command" and "version" added to it.
void write_report(const CommonOptions& options, const std::string& command, nlohmann::json report);

/// A line on stderr unless quiet.
void say(const CommonOptions& options, const std::string& line);

}  // namespace nacre::cli
