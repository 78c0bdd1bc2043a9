#include "apps/cli/options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <system_error>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/core/version.h"

namespace nacre::cli {

namespace {

/// In the help behind what a command is about.
constexpr const char* kRunningGroup = "How it runs";

}  // namespace

void add_output(CLI::App& command, CommonOptions& options) {
    command.add_option("-o,--output", options.output, "File to write instead of standard output")
        ->type_name("FILE");
}

void add_table_output(CLI::App& command, CommonOptions& options) {
    add_output(command, options);
    add_table_format(command, options);
}

void add_table_format(CLI::App& command, CommonOptions& options) {
    command
        .add_option_function<std::string>(
            "--decimal",
            [&options](const std::string& mark) { options.decimal_comma = mark == "comma"; },
            "Decimal mark of the CSV: point, or comma with semicolons between the cells [point]")
        ->check(CLI::IsMember({"point", "comma"}))
        ->type_name("MARK");
    command.add_flag("--bom", options.byte_order_mark,
                     "Begin the CSV with a byte order mark, by which spreadsheets know UTF-8");
}

void add_quiet(CLI::App& command, CommonOptions& options) {
    command.add_flag("-q,--quiet", options.quiet, "No progress and no messages, errors excepted")
        ->group(kRunningGroup);
}

void add_report(CLI::App& command, CommonOptions& options) {
    command.add_option("--report", options.report, "JSON file to write about this run")
        ->group(kRunningGroup)
        ->type_name("FILE");
}

void add_input_options(CLI::App& command, CommonOptions& options) {
    command
        .add_flag("--untrusted", options.untrusted,
                  "The recipe or scene came from elsewhere: refuse what it names outside of its "
                  "folder")
        ->group(kRunningGroup);
    command
        .add_flag(
            "--strict", options.strict,
            "Refuse what would be warned of: implausible numbers of a recipe, measured colours "
            "that contradict themselves, colours from too few wavelengths, multiple scattering "
            "that "
            "is not resolved")
        ->group(kRunningGroup);
}

void add_set(CLI::App& command, CommonOptions& options) {
    command
        .add_option("--set", options.set,
                    "Value to put into the recipe as KEY=VALUE, before all else; may be repeated. "
                    "KEY is the key, or the end of it, as in coats[0].thickness_nm=95")
        ->option_text("KEY=VALUE")
        ->allow_extra_args(false);
}

References references_of(const CommonOptions& options, const std::string& input) {
    const References references =
        options.untrusted ? References::of_untrusted_file(input) : References::of_file(input);
    return checked_references(references, input, options.in_use);
}

void add_threads(CLI::App& command, CommonOptions& options) {
    command.add_option("--threads", options.threads, "Threads to use; 0 means all")
        ->group(kRunningGroup)
        ->check(in_range(static_cast<int>(kThreadRange.lo), static_cast<int>(kThreadRange.hi)))
        ->capture_default_str();
}

void add_seed(CLI::App& command, CommonOptions& options) {
    command.add_option("--seed", options.seed, "Seed of the random numbers")
        ->group(kRunningGroup)
        ->capture_default_str();
}

void add_run_options(CLI::App& command, CommonOptions& options) {
    add_threads(command, options);
    add_quiet(command, options);
    add_report(command, options);
}

void throw_if_stopped() {
    if (interrupt_requested()) throw Stopped("stopped; nothing was written");
}

void emit(const CommonOptions& options, const std::string& data) {
    throw_if_stopped();
    if (!options.output.empty() && options.output != "-") {
        write_file_atomically(options.output, data, [](double) { return !interrupt_requested(); });
        return;
    }
    print_data(data);
}

std::string table_text(const CommonOptions& options, const std::string& csv) {
    return std::string(options.byte_order_mark ? kByteOrderMark : "") +
           (options.decimal_comma ? with_decimal_commas(csv) : csv);
}

void emit_together(const CommonOptions& options, const std::string& data,
                   std::vector<FileContents> others) {
    throw_if_stopped();
    if (!options.output.empty() && options.output != "-") {
        others.insert(others.begin(), {options.output, data});
    } else {
        print_data(data);
    }
    write_together(others);
}

void emit_table(const CommonOptions& options, const std::string& csv,
                std::vector<FileContents> others) {
    emit_together(options, table_text(options, csv), std::move(others));
}

void refuse_table_options(const CommonOptions& options) {
    if (!options.decimal_comma && !options.byte_order_mark) return;
    throw UsageError(
        fmt::format("{} belongs to CSV", options.decimal_comma ? "--decimal comma" : "--bom"));
}

void print_data(const std::string& data) {
    // A terminal shows the names in a table; it must not obey them.
    const std::string shown = isatty(STDOUT_FILENO) ? printable_lines(data) : data;
    errno = 0;
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size() &&
        std::fflush(stdout) == 0) {
        return;
    }
    if (errno == EPIPE) return;
    throw Error(
        fmt::format("cannot write to standard output: {}", std::generic_category().message(errno)));
}

void print_message(const std::string& line) {
    const std::string text =
        printable_lines(line) + "\n";  // one write, so that lines of two programs do not mix
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
}

void write_report(const CommonOptions& options, const std::string& command, nlohmann::json report) {
    if (options.report.empty()) return;
    report["command"] = command;
    report["version"] = version();
    if (!options.set.empty()) report["set"] = options.set;
    // Names come from files that may hold any bytes: what is not UTF-8 is replaced.
    write_file_atomically(
        options.report,
        report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void say(const CommonOptions& options, const std::string& line) {
    if (!options.quiet) print_message(printable(line));
}

void warn(const CommonOptions& options, const std::string& message) {
    if (options.strict) throw InputError(message + "; refused by --strict");
    say(options, "nacre: warning: " + message);
}

double parse_number(std::string_view option, std::string_view text, const Range& range) {
    std::string_view rest = text;
    const auto number = take_number(rest);
    if (!number || !rest.empty() || !range.contains(*number)) {
        throw UsageError(
            fmt::format("{} = {}: must be a number in {}", option, text, range.text()));
    }
    return *number;
}

std::vector<double> parse_numbers(std::string_view option, std::string_view text,
                                  const Range& range) {
    std::vector<double> numbers;
    const auto check_count = [&](double more) {
        if (static_cast<double>(numbers.size()) + more > static_cast<double>(kMaxNumbers)) {
            throw UsageError(
                fmt::format("{} = {}: more than {} values", option, text, kMaxNumbers));
        }
    };
    for (const std::string_view part : split(text, ',')) {
        const std::vector<std::string_view> ends = split(part, ':');
        if (ends.size() == 1) {
            check_count(1);
            numbers.push_back(parse_number(option, part, range));
            continue;
        }
        if (ends.size() != 3) {
            throw UsageError(fmt::format(
                "{} = {}: must be a number, a comma list, or first:last:step", option, text));
        }
        const double first = parse_number(option, ends[0], range);
        const double last = parse_number(option, ends[1], range);
        const double step = parse_number(option, ends[2], Range{});
        // Rounding must not lose the last value, as in 0:0.3:0.1.
        const double steps = std::floor((last - first) / step + 1e-9);
        if (!(steps >= 0)) {
            throw UsageError(fmt::format("{} = {}: the step {} does not lead from {} to {}", option,
                                         text, step, first, last));
        }
        check_count(steps + 1);
        for (double i = 0; i <= steps; ++i) numbers.push_back(first + i * step);
    }
    return numbers;
}

namespace {

constexpr Range kPhi{-360, 360, "deg"};

}  // namespace

std::vector<Direction> parse_directions(const std::string& option,
                                        const std::vector<std::string>& texts) {
    std::vector<Direction> directions;
    for (const std::string& text : texts) {
        const std::vector<std::string_view> parts = split(text, ',');
        if (parts.size() > 2) {
            throw UsageError(
                fmt::format("{} = {}: must be theta or theta,phi in degrees", option, text));
        }
        const std::vector<double> thetas =
            parse_numbers(option + " (theta)", parts[0], kPolarAngleRange);
        const std::vector<double> phis = parts.size() == 2
                                             ? parse_numbers(option + " (phi)", parts[1], kPhi)
                                             : std::vector<double>{0.0};
        if (thetas.size() * phis.size() + directions.size() > kMaxDirections) {
            throw UsageError(fmt::format("{}: more than {} directions", option, kMaxDirections));
        }
        for (double theta : thetas) {
            for (double phi : phis) directions.push_back({theta, phi});
        }
    }
    return directions;
}

}  // namespace nacre::cli
