#pragma once

#include <optional>
#include <string>

#include "apps/cli/options.h"
#include "nacre/measure/tolerance.h"

namespace nacre::cli {

/// Options of commands that compare with a standard.
struct ToleranceRequest {
    std::string formula, limits;
    bool asks() const { return !formula.empty() || !limits.empty(); }
};

void add_tolerance_options(CLI::App& command, ToleranceRequest& request);

/// None if nothing was asked for.
/// @throws UsageError naming option, text and what is allowed
std::optional<measure::Tolerance> parse_tolerance(const ToleranceRequest& request);

/// How a command ends by a verdict, if there is one. Where it fails, says at how many angles.
ExitStatus status_of(const CommonOptions& options, const std::optional<measure::Verdict>& verdict);

}  // namespace nacre::cli
