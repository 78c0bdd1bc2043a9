#pragma once

#include <optional>
#include <string>

#include "nacre/measure/tolerance.h"

namespace CLI {
class App;
}

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

}  // namespace nacre::cli
