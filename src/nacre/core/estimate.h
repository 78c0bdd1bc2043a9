#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// Estimates with their standard errors.

namespace nacre {

/// A value and the standard deviation of its error, estimated from the same data. Where a few rare
/// contributions dominate the sum, both come out too low in most runs.
struct Estimate {
    double value = 0, standard_error = 0;
};

/// Mean of independent numbers, from their sum and the sum of their squares.
/// @param count  at least 2
inline Estimate estimate_of_mean(double sum, double sum_of_squares, double count) {
    const double mean = sum / count;
    const double variance = (sum_of_squares / count - mean * mean) * count / (count - 1);
    return {mean, std::sqrt(std::max(0.0, variance) / count)};  // < 0 by rounding alone
}

/// (estimate - expected) in standard errors; the expected value's own error adds in quadrature.
/// Standard normal if both have the same mean.
inline double z_score(const Estimate& estimate, double expected, double expected_error = 0) {
    return (estimate.value - expected) / std::hypot(estimate.standard_error, expected_error);
}
inline double z_score(const Estimate& a, const Estimate& b) {
    return z_score(a, b.value, b.standard_error);
}

/// Probability that |t| exceeds x for Student's t with nu degrees of freedom: of z-scores whose
/// standard errors are estimated from nu + 1 batches. To 1e-6 for nu in [2, 1e4].
double student_two_sided(double x, double nu);

/// The median; of an even number, the mean of the two in the middle. One run that another program
/// disturbed hardly changes it.
/// @throws DomainError if there are none
double median(std::vector<double> values);

/// A statistic of sums over a picture, with its standard error: pieces of the picture are left out
/// in turn, so that neighbours that share a flake do not count as independent.
/// [efron-stein-1981]
///
/// @param pieces     several sums over each piece
/// @param statistic  a function of these sums over all pieces
/// @return the standard error is NaN where the statistic of some of them is not finite
template <std::size_t kSums, std::size_t kPieces, class Statistic>
Estimate jackknife(const std::array<std::array<double, kSums>, kPieces>& pieces,
                   const Statistic& statistic) {
    constexpr double kCount = kPieces;
    std::array<double, kSums> total{};
    for (const auto& piece : pieces) {
        for (std::size_t i = 0; i < kSums; ++i) total[i] += piece[i];
    }
    std::array<double, kPieces> values;
    double mean = 0, variance = 0;
    for (std::size_t p = 0; p < kPieces; ++p) {
        std::array<double, kSums> others = total;
        for (std::size_t i = 0; i < kSums; ++i) others[i] -= pieces[p][i];
        values[p] = statistic(others);
        mean += values[p] / kCount;
    }
    for (double value : values) variance += (value - mean) * (value - mean) / kCount;
    const double error = std::sqrt((kCount - 1) * variance);
    return {statistic(total),
            std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN()};
}

/// Pieces of a picture, for the jackknife.
inline constexpr int kPiecesAcross = 4, kPicturePieces = kPiecesAcross * kPiecesAcross;

/// Which of them holds the pixel (x, y).
constexpr int piece_of(int x, int y, int width, int height) {
    return y * kPiecesAcross / height * kPiecesAcross + x * kPiecesAcross / width;
}

}  // namespace nacre
