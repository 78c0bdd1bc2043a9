#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "nacre/measure/difference.h"
#include "nacre/measure/tolerance.h"

// Colour differences as the program writes them.

namespace nacre::cli {

/// A row an angle. With a verdict: columns of its formula, if it is not CIEDE2000, and of its limits,
/// if it has any.
std::string difference_csv(const measure::Difference& difference,
                           const std::optional<measure::Verdict>& verdict = {});
/// The same for people: aligned and rounded.
std::string difference_text(const measure::Difference& difference,
                            const std::optional<measure::Verdict>& verdict = {});
nlohmann::json difference_json(const measure::Difference& difference,
                               const std::optional<measure::Verdict>& verdict = {});

/// "45as15=2,45as110=0.5" by name.
/// @throws UsageError naming what is wrong
std::map<std::string, double> parse_weights(const std::string& text);

}  // namespace nacre::cli
