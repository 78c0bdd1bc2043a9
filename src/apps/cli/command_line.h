#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/options.h"

namespace nacre::cli {

/// Reads the command line into the options of its command. `help COMMAND` is `COMMAND --help`.
///
/// @return  none where a command is to be run; else the status to end with: help or the version
///          have been printed
/// @throws UsageError naming the argument that is wrong, with what may have been meant
std::optional<ExitStatus> parse_command_line(CLI::App& program, std::vector<std::string> arguments);

}  // namespace nacre::cli
