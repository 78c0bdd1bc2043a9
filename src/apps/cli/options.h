#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/files.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/references.h"
#include "nacre/core/text.h"
#include "nacre/montecarlo/reference.h"

namespace nacre::cli {

/// The command line is wrong in a way that only the command itself can see. Exit status 1.
class UsageError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// One file per command. Each adds its options to the program and hands back what to run once the
// command line has been read.

/// Exit status of the program.
enum class ExitStatus {
    ok = 0,
    usage = 1,              ///< the command line is wrong
    bad_input = 2,          ///< a file, or a value in it, is wrong
    failure = 3,            ///< something failed while running
    comparison_failed = 4,  ///< pictures or colours differ by more than was allowed
};

struct Command {
    CLI::App* options = nullptr;
    std::function<CommandFiles()> files;  ///< what it reads and writes, checked before it runs
    std::function<ExitStatus()> run;
};

Command add_film(CLI::App& program);
Command add_solve(CLI::App& program);
Command add_eval(CLI::App& program);
Command add_reference(CLI::App& program);
Command add_render(CLI::App& program);
Command add_merge(CLI::App& program);  ///< shards of a picture
Command add_diff(CLI::App& program);
Command add_info(CLI::App& program);
Command add_studio(CLI::App& program);  ///< the page in the browser
Command add_study(CLI::App& program);
Command add_measure(CLI::App& program);     ///< multi-angle colour
Command add_sparkle(CLI::App& program);     ///< sparkle and graininess
Command add_atlas(CLI::App& program);       ///< colours of a film by thickness and angle
Command add_materials(CLI::App& program);   ///< what ships
Command add_pigments(CLI::App& program);    ///< the same of pigments
Command add_pigment(CLI::App& program);     ///< from a drawdown to a pigment
Command add_panel(CLI::App& program);       ///< a page about a paint
Command add_scene(CLI::App& program);       ///< built-in scenes as files
Command add_completion(CLI::App& program);  ///< for shells; the program outlives it
Command add_fit(CLI::App& program);         ///< from colour back to composition
Command add_export(CLI::App& program);      ///< formats of measured BRDFs

/// Of an option of numbers: must be from `lo` to `hi`.
template <class T>
CLI::Validator in_range(T lo, T hi) {
    return CLI::Validator(
        [lo, hi](std::string& text) {
            T value{};
            if (CLI::detail::lexical_cast(text, value) && value >= lo && value <= hi) {
                return std::string();
            }
            return fmt::format("Value {} not in range {} to {}", excerpt(text), lo, hi);
        },
        fmt::format("{} in [{} - {}]", CLI::detail::type_name<T>(), lo, hi));
}

/// The same of a range with closed ends.
template <class T = double>
CLI::Validator in_range(const Range& range) {
    return in_range(static_cast<T>(range.lo), static_cast<T>(range.hi));
}

/// Wall-clock time since it was made.
class Stopwatch {
 public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

 private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace nacre::cli

namespace CLI {
class App;
}

// What several commands have in common: where results go, and how much is said meanwhile.

namespace nacre::cli {

struct CommonOptions {
    int threads = 0;               ///< 0: all
    std::uint64_t seed = 0;        ///< of random numbers
    bool quiet = false;            ///< no progress, no messages other than errors
    std::string report;            ///< JSON file about the run; empty: none
    std::string output;            ///< empty: stdout
    bool untrusted = false;        ///< recipes and scenes name files in their folders only
    bool strict = false;           ///< what would be warned of is an error
    bool decimal_comma = false;    ///< in tables; semicolons between the cells then
    bool byte_order_mark = false;  ///< at the beginning of tables
    std::vector<std::string> set;  ///< changes of the recipe, key=value; see open_paint()
    /// Of the command, shared by copies.
    std::shared_ptr<FilesInUse> in_use = std::make_shared<FilesInUse>();
};

void add_output(CLI::App& command, CommonOptions& options);  ///< -o, --output
/// Of commands that write a table (CSV): -o, --output, --decimal and --bom.
void add_table_output(CLI::App& command, CommonOptions& options);
/// --decimal and --bom alone: of commands whose output is not the table.
void add_table_format(CLI::App& command, CommonOptions& options);
void add_quiet(CLI::App& command, CommonOptions& options);
void add_report(CLI::App& command, CommonOptions& options);
/// Of all that open recipes: --untrusted and --strict.
void add_input_options(CLI::App& command, CommonOptions& options);
/// --set, of all that take a recipe, which is opened by open_paint().
void add_set(CLI::App& command, CommonOptions& options);
void add_threads(CLI::App& command, CommonOptions& options);
void add_seed(CLI::App& command, CommonOptions& options);
/// Of commands that compute: --threads, --quiet and --report.
void add_run_options(CLI::App& command, CommonOptions& options);

/// The files that an input of the command may name: checked_references().
References references_of(const CommonOptions& options, const std::string& input);

/// @throws Stopped if the user has interrupted the command, which writes no file then
void throw_if_stopped();

/// Data to the output file, whole or not at all, or to stdout.
/// @throws Error if they cannot be written; Stopped as throw_if_stopped()
void emit(const CommonOptions& options, const std::string& data);
/// The same beside other files of the same result, which are replaced together with it.
void emit_together(const CommonOptions& options, const std::string& data,
                   std::vector<FileContents> others);

/// A table as --decimal and --bom ask for it.
std::string table_text(const CommonOptions& options, const std::string& csv);
/// emit_together() of that.
void emit_table(const CommonOptions& options, const std::string& csv,
                std::vector<FileContents> others = {});
/// Refuses --decimal and --bom where no table is written.
/// @throws UsageError
void refuse_table_options(const CommonOptions& options);

/// Data to stdout. A reader that has gone, as in `nacre ... | head -1`, wants no more: the command
/// goes on, so that its files are written, and main() ends the program.
/// @throws Error if they cannot be written for another reason, such as a full disk
void print_data(const std::string& data);

/// A line on stderr. What cannot be written there is lost without an error: the work is worth more.
void print_message(const std::string& line);

/// Writes the report, if one was asked for, with "command" and "version" added to it.
void write_report(const CommonOptions& options, const std::string& command, nlohmann::json report);

/// Of what can be done and is hardly meant: a line on stderr unless quiet.
/// @throws InputError with --strict
void warn(const CommonOptions& options, const std::string& message);

/// A line on stderr unless quiet.
void say(const CommonOptions& options, const std::string& line);

inline constexpr std::size_t kMaxNumbers = 100'000;

/// The numbers of an option: one value, a comma list, or first:last:step (last is included if a
/// whole number of steps leads there), or a comma list of such.
///
/// @param option  for messages, as in "--wavelength"
/// @throws UsageError naming option, text and what is allowed
std::vector<double> parse_numbers(std::string_view option, std::string_view text,
                                  const Range& range);

/// One number.
double parse_number(std::string_view option, std::string_view text, const Range& range);

using montecarlo::Direction;

inline constexpr std::size_t kMaxDirections = 100'000;

/// Directions from options "theta" or "theta,phi", in degrees; either may be first:last:step, and
/// then every theta goes with every phi.
/// @throws UsageError naming option, text and what is allowed
std::vector<Direction> parse_directions(const std::string& option,
                                        const std::vector<std::string>& texts);

}  // namespace nacre::cli
