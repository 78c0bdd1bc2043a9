#pragma once

#include <string>
#include <vector>

#include "apps/cli/options.h"

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

/// solver::Part or montecarlo::Part, which are apart because the two share no code.
template <class Part>
Part parse_part(const std::string& text) {
    if (text == "single") return Part::single;
    if (text == "multiple") return Part::multiple;
    return Part::total;
}

}  // namespace nacre::cli
