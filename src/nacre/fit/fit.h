#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/fit/certainty.h"
#include "nacre/fit/free_numbers.h"
#include "nacre/fit/remedy.h"
#include "nacre/fit/target.h"
#include "nacre/fit/tradeoff.h"
#include "nacre/measure/difference.h"

// From multi-angle colour back to composition. The method, what it determines and what it cannot:
// docs/fit.md.

namespace nacre::fit {

struct FitOptions {
    TargetOptions target;
    /// Descents from different points of the bounds, the given start being the first. Up to 16
    /// times as many points are screened first.
    int starts = 8;
    std::uint64_t seed = 0;  ///< of the points
    /// Standard deviation of the standard's noise in each component of Delta E 2000; none: from the
    /// residual.
    std::optional<double> noise_delta_e;
    /// Paints whose mean Delta E 2000 exceeds that of the best one by this or less count as equal.
    double equal_delta_e = 0.3;
    /// Mean Delta E 2000 up to which the standard counts as matched: 1 is about just noticeable.
    double matched_delta_e = 1;
    bool remedies = true;  ///< whether to seek what might help where it does not

    static constexpr int kMaxStarts = 256;
};

/// Another local minimum of the colour difference.
struct Minimum {
    std::vector<double> values;  ///< of the free numbers
    double mean_delta_e_2000 = 0, max_delta_e_2000 = 0;
    bool converged = false;
    std::string ended;
};

/// Cost of a fit.
struct Effort {
    int solves = 0, films = 0;
    int points = 0, descents = 0, finished = 0;  ///< screened, descended coarsely, and finely
    double seconds = 0;
};

struct Fit {
    paint::Recipe recipe;
    std::vector<FittedParameter> parameters;
    measure::Measurement standard, colours;  ///< wanted and reached
    measure::Difference difference;
    measure::Difference at_start;
    /// Under A and FL11 besides, where the standard has spectra: a match under one light need not
    /// be one under another (metamerism).
    std::vector<std::pair<spectra::Illuminant, measure::Difference>> other_lights;
    bool converged = false;
    std::string ended;
    Certainty certainty;
    bool noise_given = false;    ///< not taken from the residual
    double equal_delta_e = 0.3;  ///< as in FitOptions
    std::vector<Tradeoff> tradeoffs;
    std::vector<Minimum> alternatives;  ///< within equal_delta_e of the best, the nearest first
    double matched_delta_e = 1;         ///< as in FitOptions
    std::vector<Remedy> remedies;       ///< where the standard was not matched, the best first
    Effort effort;

    /// Whether the standard's colours were reached.
    bool matched() const { return difference.mean_delta_e_2000 <= matched_delta_e; }
};

/// Seeks the composition whose colours are nearest to the standard's: the least weighted mean
/// square of Delta E 2000 between the bounds. The answer does not depend on the number of threads.
///
/// @param progress  asked between solves
/// @throws DomainError as FreeNumbers and Target, or if a free number does not change the colours
///         at all, or an option is out of range
/// @throws Error if the paint cannot be solved at the start; Stopped if `progress` asks to stop
Fit fit(const measure::Measurement& standard, const FreeNumbers& numbers,
        const FitOptions& options = {}, const Progress& progress = {});

/// A fit that was begun, to see whether it is worth being finished.
struct RoughFit {
    std::vector<double> x;  ///< of the free numbers
    double delta_e = 0;     ///< what tells which of several is nearest
};

/// The first steps of fit() alone, by colours of few wavelengths: their root mean square is off by
/// some Delta E.
/// @throws as fit(), but for numbers that do not change the colours
RoughFit screened(const measure::Measurement& standard, const FreeNumbers& numbers,
                  const FitOptions& options = {}, const Progress& progress = {});

/// Goes on from there with one coarse descent: `delta_e` is the mean Delta E 2000 at its end, without
/// what fine descents would win.
/// @throws as screened()
RoughFit descended(const measure::Measurement& standard, const FreeNumbers& numbers,
                   const RoughFit& from, const FitOptions& options = {},
                   const Progress& progress = {});

}  // namespace nacre::fit
