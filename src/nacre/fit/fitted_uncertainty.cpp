#include "nacre/fit/fitted_uncertainty.h"

#include <fmt/format.h>

#include <cmath>

#include "nacre/core/text.h"

namespace nacre::fit {
namespace {

/// To so many digits behind the point.
constexpr double kCoefficientScale = 1e6;

double to_four_digits(double x) { return *parse_number(fmt::format("{:.4g}", x)); }

std::vector<paint::ParameterCorrelation> correlations_of(const Fit& fit, bool rounded) {
    std::vector<paint::ParameterCorrelation> out;
    const std::vector<FittedParameter>& all = fit.parameters;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (!all[i].standard_error || !all[j].standard_error) continue;
            const double exact = fit.certainty.correlation[i * all.size() + j];
            const double r =
                rounded ? std::round(exact * kCoefficientScale) / kCoefficientScale : exact;
            if (r != 0) out.push_back({{all[i].number.bounds.key, all[j].number.bounds.key}, r});
        }
    }
    return out;
}

}  // namespace

FittedUncertainty fitted_uncertainty(const Fit& fit) {
    FittedUncertainty out;
    for (const FittedParameter& fitted : fit.parameters) {
        const std::string& key = fitted.number.bounds.key;
        if (fitted.standard_error) {
            out.deviations.push_back({key, to_four_digits(*fitted.standard_error), false});
        } else {
            out.not_determined.push_back(key);
        }
    }
    out.correlations = correlations_of(fit, true);
    try {
        paint::check_correlations(fit.recipe, out.deviations, out.correlations);
    } catch (const DomainError&) {  // nearly singular
        out.correlations = correlations_of(fit, false);
    }
    return out;
}

}  // namespace nacre::fit
