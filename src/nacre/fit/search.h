#pragma once

#include <cstdint>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/fit/minimise.h"

namespace nacre::fit {

struct SearchEffort {
    int points = 0, descents = 0, finished = 0;
};

/// Minima over the unit cube, the best first, no two alike: a Halton sequence of points is glanced
/// at; the best of them make a few steps each; from where the best of those are, and from `start`
/// in any case, coarse descents; from where the best of those ended, fine ones. Interference
/// colours repeat with the order, so that there are several minima, and the nearest one need not be
/// the right one.
///
/// @param progress  told shares of the whole; what it answers is heeded: the model is stopped
/// @throws Error if there is no paint at the start, or progress asked to stop
std::vector<Descent> search(ColourModel& model, const std::vector<double>& start, int starts,
                            std::uint64_t seed, const Progress& progress, SearchEffort& effort);

}  // namespace nacre::fit
