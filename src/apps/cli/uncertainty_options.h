#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/options.h"
#include "nacre/io/measurement_file.h"
#include "nacre/nacre.h"

// --uncertainty and what goes with it: how well the numbers of a recipe are known, and what that
// makes of its colours.

namespace nacre::cli {

/// As the command line has them.
struct UncertaintyRequest {
    std::vector<std::string> deviations;    ///< KEY=SD
    std::vector<std::string> correlations;  ///< A,B=COEFFICIENT
    std::optional<int> samples;
    bool none = false;  ///< the recipe's own table [uncertainty] has no say

    bool asks() const { return !deviations.empty() || !correlations.empty() || samples; }
};

void add_uncertainty_options(CLI::App& command, UncertaintyRequest& request);

/// How far the readings on a paint are spread; none if neither the command line nor the recipe says how well anything is known.
/// @throws UsageError if an option is wrong, or the paint or the model can have no uncertainty and
///         one was asked for; otherwise as Paint::measure_uncertainty()
std::optional<Uncertainty> uncertainty_of(const CommonOptions& options,
                                          const UncertaintyRequest& request, const Paint& paint,
                                          const std::vector<Geometry>& geometries,
                                          const MeasureSettings& settings);

/// The widest spread, those of flop index and travel, and where first order is doubtful, on stderr.
void say_uncertainty(const CommonOptions& options, const Uncertainty& uncertainty);

/// Standard deviations, covariances and the number that matters most, to stand beside readings.
std::vector<io::MeasurementColumn> uncertainty_columns(const Uncertainty& uncertainty);
/// A row for each quantity of each reading and each number: what it moves, and its share of the
/// variance.
std::string contributions_csv(const Uncertainty& uncertainty);
/// The readings' "uncertainty" is an entry a reading, in their order.
nlohmann::json uncertainty_json(const Uncertainty& uncertainty);

}  // namespace nacre::cli
