#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "nacre/bsdf/tabulated/brdf_table.h"

namespace nacre::bsdf {

/// The truncated singular value decomposition of a raw table: for each channel, the n^2 x m matrix
/// of polar angle pairs against azimuths is approximated by a sum of k products
///
///     g(i, o, j) = sum_k left[i, o][k] right[k][j].
///
/// Reciprocal, as the raw table is: rows (i, o) and (o, i) are the same. [mir-2022] compress
/// Ergun's tables with k = (r^2 + r)/2, r the rank of the azimuthal factor and k that of its
/// products with the reflectance; sizes are n^2 k + m k floats a channel.
struct CompressedBrdfTable {
    std::string paint;
    BrdfGrid grid;
    /// Terms kept, k; 0 for a channel that is zero to rounding and not stored.
    std::array<int, 3> rank{};
    std::vector<float> left;   ///< [i][o][channel][k]
    std::vector<float> right;  ///< [azimuth][channel][k]

    static constexpr int kMaxTerms = 64;  ///< per channel

    int terms() const { return rank[0] + rank[1] + rank[2]; }
    std::size_t bytes() const { return (left.size() + right.size()) * sizeof(float); }

    spectra::Rgb interpolate(const BrdfCell& cell) const {
        const int all = terms();
        std::array<float, 3 * kMaxTerms> factor;
        const float* at = right.data() + static_cast<std::size_t>(cell.azimuth) * all;
        for (int k = 0; k < all; ++k) {
            factor[k] = cell.azimuth_weight[0] * at[k] + cell.azimuth_weight[1] * at[all + k] +
                        cell.azimuth_weight[2] * at[2 * all + k] +
                        cell.azimuth_weight[3] * at[3 * all + k];
        }
        spectra::Rgb g;
        for (int corner = 0; corner < 4; ++corner) {
            const float* row = left.data() + cell.pair[corner] * all;
            int k = 0;
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (const int end = k + rank[c]; k < end; ++k) sum += row[k] * factor[k];
                g[c] += cell.pair_weight[corner] * sum;
            }
        }
        return g;
    }

    friend bool operator==(const CompressedBrdfTable&, const CompressedBrdfTable&) = default;
};

/// k = (r^2 + r)/2.
constexpr int terms_of_rank(int r) { return (r * r + r) / 2; }

struct CompressionSettings {
    /// r, 1 to kMaxRank, so that k = (r^2 + r)/2; 0: the smallest that meets `tolerance`.
    int rank = 0;
    /// The relative_error() that is good enough; (0, 1).
    double tolerance = 1e-3;
    /// Values below zero, of colours outside the gamut of Rec. 709, count as zero: a channel that
    /// has no others is then left out.
    bool clip_to_gamut = false;

    static constexpr int kMaxRank = 10;

    friend bool operator==(const CompressionSettings&, const CompressionSettings&) = default;
};

/// Errors count relative to the largest values that a row's two directions have (relative_error):
/// plain least squares would spend all terms on the few directions near grazing where the table of
/// a paint without a coat, or with a rough one, is largest. Singular values come from the
/// eigenvalues of the m x m Gram matrix in double precision: the error of what is kept is that of
/// single precision, 1e-7. A channel whose largest value is below kZeroChannel of the table's
/// largest is left out.
/// @throws DomainError if a setting is out of range; Error if no rank meets the tolerance
CompressedBrdfTable compress(const RawBrdfTable& raw, const CompressionSettings& settings = {});

inline constexpr double kZeroChannel = 1e-6;

/// How much a table lost: || compressed - raw || / || raw || over all values of all channels, the
/// squares of row (i, o) divided by peak_i peak_o, the largest values that each direction has.
double relative_error(const CompressedBrdfTable& compressed, const RawBrdfTable& raw);

}  // namespace nacre::bsdf
