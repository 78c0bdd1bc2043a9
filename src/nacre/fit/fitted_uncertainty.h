#pragma once

#include <string>
#include <vector>

#include "nacre/fit/fit.h"
#include "nacre/paint/parameter_correlation.h"
#include "nacre/paint/parameter_deviation.h"

// From what a fit says of its own errors to what a recipe says in [uncertainty].

namespace nacre::fit {

struct FittedUncertainty {
    std::vector<paint::ParameterDeviation> deviations;      ///< to four digits
    std::vector<paint::ParameterCorrelation> correlations;  ///< of pairs
    /// Keys of the numbers that were free and have no standard error.
    std::vector<std::string> not_determined;
};

/// The standard errors of the numbers that a fit varied, and the correlations of these errors, of
/// the covariance s^2 (J^T J)^-1.                             [seber-wild-1989, section 2.1.2]
/// Coefficients have six digits behind the point, or all where those could not be together.
FittedUncertainty fitted_uncertainty(const Fit& fit);

}  // namespace nacre::fit
