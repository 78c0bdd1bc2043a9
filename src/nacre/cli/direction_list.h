#pragma once

#include <string>
#include <vector>

#include "nacre/reference/reference.h"

namespace nacre::cli {

using reference::Direction;

inline constexpr std::size_t kMostDirections = 100'000;

/// Directions from options "theta" or "theta,phi", in degrees; either may be first:last:step, and
/// then every theta goes with every phi.
/// @throws UsageError naming option, text and what is allowed
std::vector<Direction> parse_directions(const std::string& option,
                                        const std::vector<std::string>& texts);

}  // namespace nacre::cli
