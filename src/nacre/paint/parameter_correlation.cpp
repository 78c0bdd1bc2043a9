#include "nacre/paint/parameter_correlation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "nacre/core/dense.h"
#include "nacre/core/text.h"
#include "nacre/paint/recipe_parameter.h"

namespace nacre::paint {
namespace {

/// Eigenvalues of a matrix of coefficients above minus this are 0 or more but for rounding.
constexpr double kRoundingOfEigenvalues = 1e-12;
/// Pairs are named if their part of a negative variance is so much of the largest part.
constexpr double kPartNamed = 0.01;
constexpr std::size_t kMaxPairsNamed = 8;

using Pair = std::pair<std::string, std::string>;

Pair pair_of(const std::string& a, const std::string& b) { return std::minmax(a, b); }

template <class Visit>
void for_each_pair(const ParameterCorrelation& correlation, const Visit& visit) {
    for (std::size_t i = 0; i < correlation.keys.size(); ++i) {
        for (std::size_t j = i + 1; j < correlation.keys.size(); ++j) {
            visit(correlation.keys[i], correlation.keys[j]);
        }
    }
}

std::size_t place_of(const std::vector<ParameterDeviation>& deviations, const std::string& key) {
    const auto found = std::find_if(deviations.begin(), deviations.end(),
                                    [&](const ParameterDeviation& d) { return d.key == key; });
    return static_cast<std::size_t>(found - deviations.begin());
}

/// @throws DomainError naming the pairs that give some combination of the numbers a variance below 0
void check_variances(const std::vector<ParameterDeviation>& deviations,
                     const std::vector<ParameterCorrelation>& correlations) {
    const std::vector<double> matrix = correlation_matrix(deviations, correlations);
    if (matrix.empty()) return;
    const auto count = static_cast<Eigen::Index>(deviations.size());
    const Eigen::Map<const RowMajorMatrix> r(matrix.data(), count, count);
    const SymmetricEigen eigen = symmetric_eigen(r);
    const double least = eigen.values[0];
    if (least >= -kRoundingOfEigenvalues) return;

    struct Part {
        double variance;
        Eigen::Index i, j;
    };
    std::vector<Part> parts;  // of the variance of the combination that has the least
    const Eigen::VectorXd combination = eigen.vectors.col(0);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = i + 1; j < count; ++j) {
            parts.push_back({2 * combination[i] * combination[j] * r(i, j), i, j});
        }
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.variance < b.variance; });
    std::vector<std::string> pairs;
    for (const Part& part : parts) {
        if (part.variance > kPartNamed * parts[0].variance || pairs.size() == kMaxPairsNamed) break;
        pairs.push_back(fmt::format("{} of {} and {}", r(part.i, part.j),
                                    deviations[static_cast<std::size_t>(part.i)].key,
                                    deviations[static_cast<std::size_t>(part.j)].key));
    }
    throw DomainError(
        fmt::format("correlation: {}: cannot be together, where pairs that are not stated have 0: "
                    "the matrix of coefficients has the eigenvalue {:.3g}; all must be in [0, inf)",
                    fmt::join(pairs, ", "), least));
}

}  // namespace

ParameterCorrelation parse_correlation(std::string_view text) {
    const auto refuse = [&] {
        throw DomainError(fmt::format(
            "{}: is not A,B=COEFFICIENT, as in layer[0].thickness_um,layer[1].thickness_um=0.8",
            excerpt(text)));
    };
    const std::size_t equals = text.rfind('=');
    if (equals == std::string_view::npos) refuse();
    const auto coefficient = parse_number(trimmed(text.substr(equals + 1)));
    if (!coefficient) refuse();
    ParameterCorrelation out{{}, *coefficient};
    for (const std::string_view key : split(text.substr(0, equals), ',')) {
        if (trimmed(key).empty()) refuse();
        out.keys.emplace_back(trimmed(key));
    }
    return out;
}

std::string correlation_text(const ParameterCorrelation& correlation) {
    return fmt::format("{}={}", fmt::join(correlation.keys, ","), correlation.coefficient);
}

void check_correlation(const Recipe& recipe, const std::vector<ParameterDeviation>& deviations,
                       const ParameterCorrelation& correlation) {
    const std::vector<std::string>& keys = correlation.keys;
    if (keys.size() < 2 || keys.size() > ParameterCorrelation::kMaxKeys) {
        throw DomainError(fmt::format("of = {}: must be 2 to {} numbers",
                                      keys.empty() ? "nothing" : excerpt(keys[0]),
                                      ParameterCorrelation::kMaxKeys));
    }
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const std::string what = fmt::format("of[{}] = ", i);
        try {
            find_parameter(recipe, keys[i]);
        } catch (const DomainError& error) {
            throw DomainError(what + error.what());
        }
        if (std::find(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(i), keys[i]) !=
            keys.begin() + static_cast<std::ptrdiff_t>(i)) {
            throw DomainError(what + keys[i] + ": is named twice");
        }
        if (place_of(deviations, keys[i]) == deviations.size()) {
            std::vector<std::string> known;
            for (const ParameterDeviation& d : deviations) known.push_back(d.key);
            throw DomainError(fmt::format(
                "{}{}: has no standard deviation; those that have: {}", what, keys[i],
                known.empty() ? std::string("none") : fmt::format("{}", fmt::join(known, ", "))));
        }
    }
    if (!ParameterCorrelation::kCoefficient.contains(correlation.coefficient)) {
        throw DomainError(fmt::format("coefficient = {}: must be a number in {}",
                                      correlation.coefficient,
                                      ParameterCorrelation::kCoefficient.text()));
    }
}

void check_correlations(const Recipe& recipe, const std::vector<ParameterDeviation>& deviations,
                        const std::vector<ParameterCorrelation>& correlations) {
    std::set<Pair> stated;
    for (const ParameterCorrelation& correlation : correlations) {
        check_correlation(recipe, deviations, correlation);
        for_each_pair(correlation, [&](const std::string& a, const std::string& b) {
            if (stated.insert(pair_of(a, b)).second) return;
            throw DomainError(fmt::format("correlation: that of {} and {} is stated twice", a, b));
        });
    }
    check_variances(deviations, correlations);
}

std::vector<ParameterCorrelation> with_correlations(
    const std::vector<ParameterCorrelation>& correlations,
    const std::vector<ParameterCorrelation>& changes) {
    std::set<Pair> changed;
    for (const ParameterCorrelation& change : changes) {
        for_each_pair(change, [&](const std::string& a, const std::string& b) {
            changed.insert(pair_of(a, b));
        });
    }
    std::vector<ParameterCorrelation> out;
    for (const ParameterCorrelation& known : correlations) {
        std::vector<ParameterCorrelation> kept;
        bool whole = true;
        for_each_pair(known, [&](const std::string& a, const std::string& b) {
            if (changed.contains(pair_of(a, b))) {
                whole = false;
            } else {
                kept.push_back({{a, b}, known.coefficient});
            }
        });
        if (whole) kept = {known};
        out.insert(out.end(), kept.begin(), kept.end());
    }
    out.insert(out.end(), changes.begin(), changes.end());
    return out;
}

std::vector<double> correlation_matrix(const std::vector<ParameterDeviation>& deviations,
                                       const std::vector<ParameterCorrelation>& correlations) {
    if (correlations.empty()) return {};
    const std::size_t count = deviations.size();
    std::vector<double> matrix(count * count, 0.0);
    for (std::size_t i = 0; i < count; ++i) matrix[i * count + i] = 1;
    for (const ParameterCorrelation& correlation : correlations) {
        for_each_pair(correlation, [&](const std::string& a, const std::string& b) {
            const std::size_t i = place_of(deviations, a), j = place_of(deviations, b);
            matrix[i * count + j] = matrix[j * count + i] = correlation.coefficient;
        });
    }
    return matrix;
}

std::vector<double> correlation_root(const std::vector<double>& matrix) {
    const auto count = static_cast<std::size_t>(std::lround(std::sqrt(matrix.size())));
    std::vector<double> root(matrix.size(), 0.0);
    for (std::size_t j = 0; j < count; ++j) {
        const auto rest = [&](std::size_t i) {  // of R[i][j], less what the columns before make
            double value = matrix[i * count + j];
            for (std::size_t k = 0; k < j; ++k) value -= root[i * count + k] * root[j * count + k];
            return value;
        };
        const double square = rest(j);
        if (square <= kRoundingOfEigenvalues) continue;  // follows from those before
        root[j * count + j] = std::sqrt(square);
        for (std::size_t i = j + 1; i < count; ++i) {
            root[i * count + j] = rest(i) / root[j * count + j];
        }
    }
    return root;
}

}  // namespace nacre::paint
