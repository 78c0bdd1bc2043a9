#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/fit/target.h"

namespace nacre::fit {

/// When a descent ends.
struct DescentLimits {
    int max_steps = 30;
    double function_tolerance = 1e-6;   ///< change of the sum of squares over itself
    double parameter_tolerance = 1e-6;  ///< length of a step over that of the point
    double enough_delta_e = 1e-3;       ///< root mean square below which colours count as equal
};

/// Where a descent ended.
struct Descent {
    std::vector<double> x;
    double rms_delta_e = 0;
    bool converged = false;
    int steps = 0;
    std::string ended;  ///< why, in a sentence without its full stop
};

/// Least squares from a point of the unit cube, within it: steps of Levenberg and Marquardt cut off
/// at the bounds, by Ceres Solver.                  [levenberg-1944; marquardt-1963; agarwal-2022]
///
/// @param after_step  called after each step; may be empty
/// @return a descent with an infinite difference if there is no paint at the start
Descent descend(const ColourModel& model, std::vector<double> x, Detail detail,
                const DescentLimits& limits, const std::function<void()>& after_step = {});

struct SearchEffort {
    int points = 0, descents = 0, finished = 0;
};

/// Minima over the unit cube, the best first, no two equal, by multi-start: the points of a Halton
/// sequence are screened; short descents start from the best of them, coarse ones from where the
/// best of those ended and in any case from `start`, and fine ones from where the best of the
/// coarse ones ended. Interference colours repeat with the order, so that there are several minima,
/// and the nearest one need not be the right one.
///
/// @param work  of total 1: told the fraction done, up to 0.95
/// @throws Error if there is no paint at the start, or the work is stopped
std::vector<Descent> search(const ColourModel& model, const std::vector<double>& start, int starts,
                            std::uint64_t seed, SharedProgress& work, SearchEffort& effort);

/// The first steps of search() alone, for a fraction of its work: where the short descents ended,
/// the best first.
/// @throws as search()
std::vector<Descent> short_search(const ColourModel& model, const std::vector<double>& start,
                                  int starts, std::uint64_t seed, SharedProgress& work);

/// One of the coarse descents of search().
/// @throws Stopped if the work is
Descent coarse_descent(const ColourModel& model, const std::vector<double>& start);

}  // namespace nacre::fit
