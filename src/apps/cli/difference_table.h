#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "nacre/measure/difference.h"

// Colour differences as the program writes them.

namespace nacre::cli {

/// A row an angle.
std::string difference_csv(const measure::Difference& difference);
nlohmann::json difference_json(const measure::Difference& difference);

/// "45as15=2,45as110=0.5" by name.
/// @throws UsageError naming what is wrong
std::map<std::string, double> parse_weights(const std::string& text);

}  // namespace nacre::cli
