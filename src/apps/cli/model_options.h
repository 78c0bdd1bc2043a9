#pragma once

#include <string>

#include "nacre/models/models.h"

namespace CLI {
class App;
}

// --model and the choices that belong to a model.

namespace nacre::cli {

struct ModelOptions {
    std::string model = "microflake";
    bool model_given = false;  ///< --model was on the command line
    std::string table = "split";
    std::string colour = "spectral";
    std::string tracking = "delta";
    int simpson_panels = models::SurfaceOptions{}.simpson_panels;
    bool hot_spot = false;
    std::string flakes = "hashed";
};

void add_model_options(CLI::App& command, ModelOptions& options);
/// Only --table, for `solve`.
void add_table_option(CLI::App& command, ModelOptions& options);

/// @throws UsageError naming the model and those that exist
const models::ModelInfo& parse_model(const ModelOptions& options);

/// @param seed  which facets there are
/// @throws UsageError if a choice was made that the model does not know
models::SurfaceOptions parse_surface_options(const ModelOptions& options, std::uint64_t seed);

}  // namespace nacre::cli
