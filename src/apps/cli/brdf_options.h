#pragma once

#include <string>
#include <vector>

#include "apps/cli/options.h"
#include "nacre/core/part.h"

// The options that `eval` and `reference` have in common: paint, directions, wavelengths, part.

namespace nacre::cli {

struct BrdfOptions : CommonOptions {
    std::string recipe;
    std::vector<std::string> incident, outgoing;
    std::string wavelengths;
    std::string part = "total";
};

/// RECIPE, --incident, --outgoing and --part.
void add_brdf_options(CLI::App& command, BrdfOptions& options);

/// Of --part.
Part parse_part(const std::string& text);

}  // namespace nacre::cli
