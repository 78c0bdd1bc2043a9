#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/paint/parameter_deviation.h"
#include "nacre/paint/recipe.h"

// Which numbers of a recipe are wrong together: [[uncertainty.correlation]] of its file.

namespace nacre::paint {

/// Numbers of a recipe whose errors go together, as those of two layers that one gun has sprayed:
/// any two of them have the same coefficient of correlation.           [jcgm-100-2008, 5.2.2]
/// Numbers of which nothing is said are independent.
struct ParameterCorrelation {
    std::vector<std::string> keys;  ///< of numbers with a standard deviation, two or more
    double coefficient = 0;         ///< in kCoefficient

    static constexpr Range kCoefficient{-1, 1};
    static constexpr std::size_t kMaxKeys = 64;
    static constexpr std::size_t kMaxStated = 4096;  ///< of a recipe

    friend bool operator==(const ParameterCorrelation&, const ParameterCorrelation&) = default;
};

/// "A,B=0.8", with the keys or parts of keys between commas.
/// @throws DomainError naming the text if it is not; check_correlation() checks the rest
ParameterCorrelation parse_correlation(std::string_view text);

/// The same as text that parse_correlation() reads back.
std::string correlation_text(const ParameterCorrelation& correlation);

/// @throws DomainError if the recipe has no such number, one is named twice or has no standard
///         deviation, there are not two to kMaxKeys of them, or the coefficient is out of range; the
///         message starts with "of" or "coefficient", as in the recipe's table
void check_correlation(const Recipe& recipe, const std::vector<ParameterDeviation>& deviations,
                       const ParameterCorrelation& correlation);

/// Whether each of them is right by itself, and all are together.
/// @throws DomainError as check_correlation(); naming the pair if a pair is stated twice, or the pairs
///         that cannot be together: some combination of the numbers would have a negative variance
void check_correlations(const Recipe& recipe, const std::vector<ParameterDeviation>& deviations,
                        const std::vector<ParameterCorrelation>& correlations);

/// `correlations` with those of `changes` besides: a pair that both state has what `changes` say.
std::vector<ParameterCorrelation> with_correlations(
    const std::vector<ParameterCorrelation>& correlations,
    const std::vector<ParameterCorrelation>& changes);

/// Without the numbers that `keep` does not want.
template <class Keep>
std::vector<ParameterCorrelation> correlations_among(std::vector<ParameterCorrelation> correlations,
                                                     const Keep& keep) {
    for (ParameterCorrelation& c : correlations) {
        std::erase_if(c.keys, [&](const std::string& key) { return !keep(key); });
    }
    std::erase_if(correlations, [](const ParameterCorrelation& c) { return c.keys.size() < 2; });
    return correlations;
}

/// The coefficients of the numbers in the order of their deviations, row by row: 1 on the diagonal.
/// Empty where there are no correlations.
std::vector<double> correlation_matrix(const std::vector<ParameterDeviation>& deviations,
                                       const std::vector<ParameterCorrelation>& correlations);

/// The lower triangular L with L L^T = R, row by row (Cholesky): L z has the correlations R if z has
/// none. Where R is singular, as for a coefficient of 1, a column of L is 0.
/// @param matrix  as correlation_matrix() of what check_correlations() finds right
std::vector<double> correlation_root(const std::vector<double>& matrix);

}  // namespace nacre::paint
