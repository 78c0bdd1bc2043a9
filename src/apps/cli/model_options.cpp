#include "apps/cli/model_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <map>
#include <vector>

#include "apps/cli/options.h"
#include "nacre/core/text.h"

namespace nacre::cli {
namespace {

using models::Model;

std::vector<std::string> model_names() {
    std::vector<std::string> names;
    for (const models::ModelInfo& model : models::all_models()) names.emplace_back(model.name);
    return names;
}

template <class T>
T choose(const char* option, const std::string& text, const std::map<std::string, T>& choices) {
    const auto found = choices.find(text);
    if (found != choices.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) names.push_back(name);
    throw UsageError(
        fmt::format("{} = {}: must be one of {}", option, text, fmt::join(names, ", ")));
}

}  // namespace

void add_table_option(CLI::App& command, ModelOptions& options) {
    command
        .add_option(
            "--table", options.table,
            "microflake: how the solved BRDF is kept: split (spectral, exact), or raw or svd (RGB "
            "tables as in the comparison of 2022)")
        ->capture_default_str();
}

void add_model_options(CLI::App& command, ModelOptions& options) {
    command
        .add_option("--model", options.model,
                    fmt::format("Model of the paint: {}", fmt::join(model_names(), ", ")))
        ->each([&options](const std::string&) { options.model_given = true; })
        ->capture_default_str();
    add_table_option(command, options);
    command
        .add_option("--colour", options.colour,
                    "thin-film: spectral (exact), or RGB by spectral antialiasing: table (Fourier "
                    "transform of the observer) or paper (Gaussian fit)")
        ->capture_default_str();
    command
        .add_option("--tracking", options.tracking,
                    "volume: delta (unbiased) or simpson (the paper's integration along the ray)")
        ->capture_default_str();
    command
        .add_option("--simpson-panels", options.simpson_panels,
                    "volume with --tracking simpson: panels per piece of ray")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command.add_flag(
        "--hot-spot", options.hot_spot,
        "nacre: light that came in between large flakes finds the same gaps on its way "
        "out; the mean is then brighter than the solver's");
    command
        .add_option(
            "--flakes", options.flakes,
            "nacre: hashed (statistics, on any shape), or explicit (the ground truth: every "
            "flake a disc, under flat panels)")
        ->capture_default_str();
}

const models::ModelInfo& parse_model(const ModelOptions& options) {
    if (const models::ModelInfo* found = models::find_model(options.model)) return *found;
    const std::vector<std::string> names = model_names();
    throw UsageError(fmt::format("--model = {}: is no model{}; there are: {}", options.model,
                                 did_you_mean(options.model, names), fmt::join(names, ", ")));
}

models::SurfaceOptions parse_surface_options(const ModelOptions& options, std::uint64_t seed) {
    const models::ModelInfo& model = parse_model(options);
    const ModelOptions standard;
    const auto belongs_to = [&](const char* option, Model owner, bool chosen) {
        if (chosen && model.model != owner) {
            throw UsageError(fmt::format("{} belongs to --model {}, not to {}", option,
                                         models::info(owner).name, model.name));
        }
    };
    belongs_to("--table", Model::microflake, options.table != standard.table);
    belongs_to("--colour", Model::thin_film, options.colour != standard.colour);
    belongs_to("--tracking", Model::volume, options.tracking != standard.tracking);
    belongs_to("--simpson-panels", Model::volume,
               options.simpson_panels != standard.simpson_panels);
    belongs_to("--hot-spot", Model::nacre, options.hot_spot);
    belongs_to("--flakes", Model::nacre, options.flakes != standard.flakes);

    models::SurfaceOptions surface;
    surface.table = choose<models::Table>("--table", options.table,
                                          {{"split", models::Table::split},
                                           {"raw", models::Table::raw},
                                           {"svd", models::Table::svd}});
    surface.colour = choose<bsdf::ThinFilmColour>("--colour", options.colour,
                                                  {{"spectral", bsdf::ThinFilmColour::spectral},
                                                   {"table", bsdf::ThinFilmColour::table},
                                                   {"paper", bsdf::ThinFilmColour::paper}});
    surface.tracking = choose<montecarlo::Tracking>(
        "--tracking", options.tracking,
        {{"delta", montecarlo::Tracking::delta}, {"simpson", montecarlo::Tracking::simpson}});
    surface.simpson_panels = options.simpson_panels;
    surface.hot_spot = options.hot_spot;
    surface.flakes = choose<models::Flakes>(
        "--flakes", options.flakes,
        {{"hashed", models::Flakes::hashed}, {"explicit", models::Flakes::explicit_discs}});
    if (surface.hot_spot && surface.flakes == models::Flakes::explicit_discs) {
        throw UsageError("--hot-spot is for hashed flakes: explicit ones have it by themselves");
    }
    surface.seed = seed;
    return surface;
}

}  // namespace nacre::cli
