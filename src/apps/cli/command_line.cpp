#include "apps/cli/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <system_error>

#include "nacre/core/text.h"

namespace nacre::cli {

namespace {

bool is_option(const std::string& argument) {
    return argument.size() > 1 && argument[0] == '-' && !nacre::parse_number(argument);
}

std::vector<std::string> command_names(CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

/// A whole number without what CLI11 would take for the mark of octal ones.
/// @return what is wrong; else empty
std::string to_decimal(std::string& text, bool is_signed) {
    const std::size_t sign = text.find_first_not_of("+-") == 1 ? 1 : 0;
    const std::string digits = text.substr(sign);
    const bool negative = sign == 1 && text[0] == '-';
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) {
        return fmt::format("Value {} is not a whole number", excerpt(text));
    }
    const std::string decimal =
        digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
    std::uint64_t magnitude = 0;
    const auto read = std::from_chars(decimal.data(), decimal.data() + decimal.size(), magnitude);
    const std::uint64_t limit = is_signed ? std::numeric_limits<std::int64_t>::max()
                                          : std::numeric_limits<std::uint64_t>::max();
    if (read.ec != std::errc() || magnitude > limit || (negative && !is_signed && magnitude > 0)) {
        return fmt::format("Value {} not in range {} to {}", excerpt(text),
                           is_signed ? fmt::format("-{}", limit) : "0", limit);
    }
    text = (negative && magnitude > 0 ? "-" : "") + decimal;
    return {};
}

/// CLI11 reads whole numbers as C does, 010 as 8 and -1 as 2^64 - 1, and finds nan in each range.
void check_numbers(CLI::App& program) {
    for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
        for (CLI::Option* option : command->get_options()) {
            const std::string type = option->get_type_name();
            if (type.starts_with("INT") || type.starts_with("UINT")) {
                const bool is_signed = type.starts_with("INT");
                option->transform(CLI::Validator(
                    [is_signed](std::string& text) { return to_decimal(text, is_signed); }, ""));
            } else if (type.starts_with("FLOAT")) {
                option->check(CLI::Validator(
                    [](std::string& text) {
                        return std::isnan(std::strtod(text.c_str(), nullptr))
                                   ? fmt::format("Value {} is not a number", excerpt(text))
                                   : std::string();
                    },
                    ""));
            }
        }
    }
}

/// "nacre measure --help lists ..."
std::string see_help(const CLI::App* command) {
    return fmt::format("nacre{}{} --help tells what it takes", command ? " " : "",
                       command ? command->get_name() : "");
}

/// Looks for the mistakes that make the parser complain of something else.
void check_first_word(CLI::App& program, const std::vector<std::string>& arguments) {
    const auto word = std::find_if_not(arguments.begin(), arguments.end(), is_option);
    const std::vector<std::string> names = command_names(program);
    if (word == arguments.end() || std::ranges::find(names, *word) != names.end()) return;
    throw UsageError(fmt::format("there is no command '{}'{}; the commands are {}", excerpt(*word),
                                 did_you_mean(excerpt(*word), names), fmt::join(names, ", ")));
}

/// @throws UsageError if the command was given an option that it does not have
void check_options(const CLI::App& command) {
    for (const std::string& argument : command.remaining()) {
        if (!is_option(argument)) continue;
        const std::string name = argument.substr(0, argument.find('='));
        throw UsageError(fmt::format("{} has no option {}{}; {}", command.get_name(), excerpt(name),
                                     did_you_mean(excerpt(name), option_names(command)),
                                     see_help(&command)));
    }
}

}  // namespace

std::optional<ExitStatus> parse_command_line(CLI::App& program,
                                             std::vector<std::string> arguments) {
    if (!arguments.empty() && arguments[0] == "help") {
        arguments.erase(arguments.begin());
        arguments.resize(std::min<std::size_t>(arguments.size(), 1));
        arguments.push_back("--help");
    }
    check_first_word(program, arguments);
    check_numbers(program);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
    try {
        program.parse(arguments);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // help or version
            std::ostringstream out, err;
            program.exit(error, out, err);
            print_data(out.str());
            return ExitStatus::ok;
        }
        const std::vector<CLI::App*> parsed = program.get_subcommands();
        const CLI::App* command = parsed.empty() ? nullptr : parsed[0];
        if (command) check_options(*command);
        const std::vector<std::string> rest = command ? command->remaining() : program.remaining();
        if (dynamic_cast<const CLI::ExtrasError*>(&error) && !rest.empty()) {
            throw UsageError(fmt::format("{}: '{}' was not expected; {}",
                                         command ? command->get_name() : "nacre",
                                         excerpt(rest.front()), see_help(command)));
        }
        throw UsageError(fmt::format("{}{}{}; {}", command ? command->get_name() : "",
                                     command ? ": " : "", error.what(), see_help(command)));
    }
    return std::nullopt;
}

}  // namespace nacre::cli
