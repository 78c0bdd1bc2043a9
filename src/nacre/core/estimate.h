#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nacre {

struct Estimate {
    double value = 0, standard_error = 0;
};

/// A statistic of sums over a picture, with its standard error: pieces of the picture are left out
/// in turn, so that neighbours that share a flake do not count as independent.
/// [efron-stein-1981]
///
/// @param pieces     sums over each piece; Sums has + and -
/// @param statistic  a function of the sums over all pieces
/// @return the standard error is NaN where the statistic of some of them is not finite
template <class Sums, std::size_t kPieces, class Statistic>
Estimate jackknife(const std::array<Sums, kPieces>& pieces, const Statistic& statistic) {
    constexpr double kCount = kPieces;
    Sums total{};
    for (const Sums& s : pieces) total = total + s;
    std::array<double, kPieces> values;
    double mean = 0, variance = 0;
    for (std::size_t i = 0; i < kPieces; ++i) {
        values[i] = statistic(total - pieces[i]);
        mean += values[i] / kCount;
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
