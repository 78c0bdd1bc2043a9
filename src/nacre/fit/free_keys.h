#pragma once

#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/paint/recipe_parameter.h"

// Which numbers of a recipe can be free at all.

namespace nacre::fit {

/// A number that a pattern means and that cannot be free.
struct SkippedNumber {
    std::string key, why;
};

struct FreeKeys {
    std::vector<std::string> keys;  ///< whole ones, each once
    std::vector<SkippedNumber> skipped;
};

/// The numbers that patterns mean (paint::matching_parameters()). Those that a pattern with `*`
/// means beside others are passed over if they cannot be free: because nothing tells between which
/// bounds they are (default_bounds()), or because they do not change the colours. Those named
/// without `*` are taken as they are.
/// @throws DomainError as paint::matching_parameters(), or if all are passed over
FreeKeys free_keys(const paint::Recipe& start, const std::vector<std::string>& patterns,
                   const std::vector<paint::ParameterBounds>& bounds, bool hot_spot,
                   const Progress& progress = {});

}  // namespace nacre::fit
