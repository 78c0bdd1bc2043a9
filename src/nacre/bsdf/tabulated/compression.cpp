#include "nacre/bsdf/tabulated/compression.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/core/dense.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"

namespace nacre::bsdf {

namespace {

// Rows (i, 0 ... angles - 1) of one channel, values below `min_value` raised to it.
RowMajorMatrix slab(const RawBrdfTable& raw, int channel, std::size_t i, double min_value) {
    const int n = raw.grid.angles, m = raw.grid.azimuths;
    const float* at = raw.values.data() + 3 * i * n * m + channel;
    using Strided = Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, 1>, 0,
                               Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;
    return Strided(at, n, m, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>(3 * m, 3))
        .cast<double>()
        .cwiseMax(min_value);
}

// Largest value by polar node, over the other node, azimuth and channel.
std::vector<double> peaks(const RawBrdfTable& raw) {
    const std::size_t line = raw.values.size() / raw.grid.angles;
    std::vector<double> peak;
    for (auto at = raw.values.begin(); at != raw.values.end(); at += line) {
        float largest = 0;
        for (auto v = at; v != at + line; ++v) largest = std::max(largest, std::abs(*v));
        peak.push_back(largest);
    }
    return peak;
}

// Weight of a row's squared error.
double weight(const std::vector<double>& peak, std::size_t i, std::size_t o) {
    const double product = peak[i] * peak[o];
    return product > 0 ? 1 / product : 0.0;
}

double largest(const RawBrdfTable& raw, int channel, double min_value) {
    double peak = 0;
    for (std::size_t at = channel; at < raw.values.size(); at += 3) {
        peak = std::max(peak, std::abs(std::max<double>(raw.values[at], min_value)));
    }
    return peak;
}

// Right singular vectors as columns, the largest first, and the squares of their singular values.
struct Spectrum {
    Eigen::MatrixXd vectors;
    Eigen::VectorXd energy;
};

Spectrum decompose(const RawBrdfTable& raw, const std::vector<double>& peak, int channel,
                   double min_value) {
    const int m = raw.grid.azimuths;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(m, m);
    for (int i = 0; i < raw.grid.angles; ++i) {
        RowMajorMatrix rows = slab(raw, channel, i, min_value);
        for (int o = 0; o < raw.grid.angles; ++o) rows.row(o) *= std::sqrt(weight(peak, i, o));
        gram.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    }
    const SymmetricEigen eigen = symmetric_eigen(gram);
    return {eigen.vectors.rowwise().reverse(), eigen.values.reverse().cwiseMax(0.0)};
}

// Relative error over all channels if each keeps k terms.
double truncation_error(const std::array<Spectrum, 3>& channels, int k) {
    double lost = 0, all = 0;
    for (const Spectrum& s : channels) {
        const auto size = static_cast<int>(s.energy.size());
        all += s.energy.sum();
        if (k < size) lost += s.energy.tail(size - k).sum();
    }
    return all > 0 ? std::sqrt(lost / all) : 0.0;
}

int choose_rank(const std::array<Spectrum, 3>& channels, double tolerance) {
    for (int r = 1; r <= CompressionSettings::kMaxRank; ++r) {
        if (truncation_error(channels, terms_of_rank(r)) <= tolerance) return r;
    }
    throw Error(fmt::format(
        "a tolerance of {} is not met by r = {} ({} terms), which err by {:.2g}", tolerance,
        CompressionSettings::kMaxRank, terms_of_rank(CompressionSettings::kMaxRank),
        truncation_error(channels, terms_of_rank(CompressionSettings::kMaxRank))));
}

}  // namespace

CompressedBrdfTable compress(const RawBrdfTable& raw, const CompressionSettings& settings) {
    require_in_range(settings.rank, 0, CompressionSettings::kMaxRank, "rank r");
    if (!(settings.tolerance > 0 && settings.tolerance < 1)) {
        throw DomainError(fmt::format("tolerance = {} is outside (0, 1)", settings.tolerance));
    }
    const double min_value =
        settings.clip_to_gamut ? 0.0 : -std::numeric_limits<double>::infinity();
    std::array<double, 3> peak;
    for (int c = 0; c < 3; ++c) peak[c] = largest(raw, c, min_value);
    const double brightest = *std::max_element(peak.begin(), peak.end());
    const std::vector<double> scale = peaks(raw);
    std::array<Spectrum, 3> channels;
    parallel_for(0, 3, [&](std::size_t c) {
        channels[c] = decompose(raw, scale, static_cast<int>(c), min_value);
    });

    const int r = settings.rank > 0 ? settings.rank : choose_rank(channels, settings.tolerance);
    CompressedBrdfTable out;
    out.paint = raw.paint;
    out.grid = raw.grid;
    for (int c = 0; c < 3; ++c) {
        if (peak[c] > kZeroChannel * brightest) {
            out.rank[c] = std::min(terms_of_rank(r), raw.grid.azimuths);
        }
    }
    const int n = raw.grid.angles, m = raw.grid.azimuths, all = out.terms();
    out.left.resize(raw.grid.pairs() * all);
    out.right.resize(static_cast<std::size_t>(m) * all);
    int first = 0;
    for (int c = 0; c < 3; ++c) {
        const int k = out.rank[c];
        const Eigen::MatrixXd basis = channels[c].vectors.leftCols(k);
        for (int j = 0; j < m; ++j) {
            for (int t = 0; t < k; ++t) {
                out.right[static_cast<std::size_t>(j) * all + first + t] =
                    static_cast<float>(basis(j, t));
            }
        }
        parallel_for(0, k > 0 ? n : 0, [&](std::size_t i) {
            const RowMajorMatrix projected = slab(raw, c, i, min_value) * basis;
            for (int o = 0; o < n; ++o) {
                float* row = out.left.data() + (i * n + o) * all + first;
                for (int t = 0; t < k; ++t) row[t] = static_cast<float>(projected(o, t));
            }
        });
        first += k;
    }
    return out;
}

double relative_error(const CompressedBrdfTable& compressed, const RawBrdfTable& raw) {
    const int all = compressed.terms(), m = raw.grid.azimuths;
    const std::size_t pairs = raw.grid.pairs(), n = raw.grid.angles;
    const std::vector<double> peak = peaks(raw);
    double lost = 0, sum = 0;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        const float* left = compressed.left.data() + pair * all;
        const double w = weight(peak, pair / n, pair % n);
        for (int j = 0; j < m; ++j) {
            const float* right = compressed.right.data() + static_cast<std::size_t>(j) * all;
            int k = 0;
            for (int c = 0; c < 3; ++c) {
                const double exact = raw.values[3 * (pair * m + j) + c];
                double value = 0;
                for (const int end = k + compressed.rank[c]; k < end; ++k) {
                    value += static_cast<double>(left[k]) * right[k];
                }
                lost += w * (value - exact) * (value - exact);
                sum += w * exact * exact;
            }
        }
    }
    return sum > 0 ? std::sqrt(lost / sum) : 0.0;
}

}  // namespace nacre::bsdf
