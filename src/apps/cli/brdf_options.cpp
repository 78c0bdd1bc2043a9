#include "apps/cli/brdf_options.h"

#include <CLI/CLI.hpp>

namespace nacre::cli {

void add_brdf_options(CLI::App& command, BrdfOptions& options) {
    command.add_option("RECIPE", options.recipe, "Recipe (TOML) or solved paint (HDF5)")
        ->required();
    command
        .add_option("--incident", options.incident,
                    "Direction towards the light as theta[,phi], deg; may be repeated")
        ->required()
        ->option_text("THETA[,PHI] REQUIRED")
        ->allow_extra_args(false);
    command
        .add_option("--outgoing", options.outgoing,
                    "Direction towards the eye as theta[,phi], deg; may be repeated")
        ->required()
        ->option_text("THETA[,PHI] REQUIRED")
        ->allow_extra_args(false);
    add_input_options(command, options);
    add_set(command, options);
    command
        .add_option("--part", options.part,
                    "total, single (met exactly one flake) or multiple scattering")
        ->check(CLI::IsMember({"total", "single", "multiple"}))
        ->capture_default_str();
}

Part parse_part(const std::string& text) {
    if (text == "single") return Part::single;
    if (text == "multiple") return Part::multiple;
    return Part::total;
}

}  // namespace nacre::cli
