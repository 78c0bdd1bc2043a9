#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "nacre/core/random.h"
#include "nacre/core/vec.h"

// Binomial numbers that are a function of a key: the splits of a hierarchy that is never stored.
// The same n, p and key give the same number, in whatever order they are asked for.

namespace nacre::sparkle {

/// Counts up to which half_binomial() has the exact distribution.
inline constexpr std::uint64_t kExactHalfBinomial = 256;
/// Variance n p (1 - p) up to which binomial() has the exact distribution.
inline constexpr double kExactBinomialVariance = 16;
/// Beyond, by how much the variance may be off, in counts squared; the mean is exact.
inline constexpr double kBinomialVarianceError = 1e-2;

namespace detail {

inline constexpr std::uint64_t kNextBits = 0x9e3779b97f4a7c15u;

// Rounds a nearly Gaussian number of this mean and variance to one of its two neighbours, with the
// probabilities that keep the mean; the rounding adds 1/6 to the variance, which is subtracted
// before. The distribution is the binomial one of 64 fair trials, interpolated linearly: a popcount
// plus the difference of two uniforms, of variance 16 + 1/6. Its kurtosis is that of a binomial of
// 64, 3 - 1/32, where a Gaussian has 3. It ends at eight standard deviations.
inline double rounded_bell(double mean, double variance, std::uint64_t key) {
    const std::uint64_t spread = mix_bits(key + kNextBits);
    const double heads = std::popcount(mix_bits(key)) - 32;
    const double smooth =
        (static_cast<double>(spread >> 32) - static_cast<double>(spread & 0xffffffffu)) * 0x1p-32;
    const double bell = (heads + smooth) * std::sqrt((variance - 1.0 / 6) / (16 + 1.0 / 6));
    return std::floor(mean + bell + to_unit_double(mix_bits(key + 2 * kNextBits)));
}

}  // namespace detail

/// How many of n fair trials, n < 2^53, succeed. Exact distribution up to kExactHalfBinomial trials
/// (their bits are counted); beyond, nearly Gaussian with the exact mean n/2 and variance n/4.
inline std::uint64_t half_binomial(std::uint64_t n, std::uint64_t key) {
    if (n > kExactHalfBinomial) {
        const double x = static_cast<double>(n);
        return static_cast<std::uint64_t>(detail::rounded_bell(0.5 * x, 0.25 * x, key));
    }
    std::uint64_t heads = 0;
    for (; n >= 64; n -= 64, key += detail::kNextBits) heads += std::popcount(mix_bits(key));
    if (n > 0) heads += std::popcount(mix_bits(key) >> (64 - n));
    return heads;
}

/// How many of n trials, n < 2^53, succeed with probability p in [0, 1]. Exact distribution, by
/// inversion, while the variance is at most kExactBinomialVariance; beyond, nearly Gaussian with
/// the exact mean and a variance to kBinomialVarianceError.
inline std::uint64_t binomial(std::uint64_t n, double p, std::uint64_t key) {
    if (n == 0 || p <= 0) return 0;
    if (p >= 1) return n;
    if (p > 0.5) return n - binomial(n, 1 - p, key);
    const double trials = static_cast<double>(n), variance = trials * p * (1 - p);
    if (variance > kExactBinomialVariance) {
        // It ends at 8 standard deviations; a probability below 2^-60 lies outside [0, n].
        return static_cast<std::uint64_t>(
            std::clamp(detail::rounded_bell(trials * p, variance, key), 0.0, trials));
    }
    // From P(0) = (1 - p)^n >= e^-33 upwards by the ratio of neighbours.
    double u = to_unit_double(mix_bits(key)), probability = std::exp(trials * std::log1p(-p));
    const double odds = p / (1 - p);
    std::uint64_t k = 0;
    while (u >= probability && k < n) {
        u -= probability;
        probability *= odds * static_cast<double>(n - k) / static_cast<double>(k + 1);
        // The tail beyond is below the resolution of u.
        if (probability < 0x1p-60 && static_cast<double>(k) > trials * p) break;
        ++k;
    }
    return k;
}

// A tree of spherical triangles over the normals of facets.

/// The upper hemisphere as four octants, each halved along its edges into four triangles, over and
/// over. A triangle's mass is the fraction of facets whose normals it holds: the integral of
/// D(m) (m.n), Beckmann's distribution per projected area, which is 1 over the hemisphere.
/// [jakob-2014, section 4.2]
///
/// D is the same in all octants, so one is stored and the others are turned onto it: memory
/// 0.1 to 6 MB, by depth.
class NormalTree {
 public:
    /// @param alpha     Beckmann roughness, in [1e-4, 2]
    /// @param edge_rad  triangles are halved until their edges are about as long, at most
    ///                  kMaxDepth times
    /// @throws DomainError out of range
    NormalTree(double alpha, double edge_rad);

    static constexpr int kMaxDepth = 7;
    int depth() const { return depth_; }

    /// Which triangle: two bits for the octant, then two for each level from the top.
    using Code = std::uint32_t;
    /// The smallest triangle that holds m, a unit vector upwards.
    Code locate(Vec3f m) const;
    /// Fraction of the facets in a smallest triangle.
    double mass(Code leaf) const;

    /// A number of facets for each of the four parts of a node.
    struct Parts {
        std::uint64_t count[4];
    };
    /// Splits n facets among the octants.
    static Parts split_octants(std::uint64_t n, std::uint64_t key);
    /// Splits n facets of a triangle among its parts, multinomially by their masses. `node` counts
    /// the triangles of an octant from 0, its own; the parts of `node` are 4 node + 1 .. 4.
    /// @param wanted  bit i: part i is asked for; others may be left at 0
    Parts split(std::uint32_t node, std::uint64_t n, std::uint64_t key, unsigned wanted = 15) const;

 private:
    struct Node {
        Vec3f corner_planes[3];  // positive side: the part at that corner
        // Of each of the first three parts of kOrder, given that it is none of those before it.
        double probability[3];
    };
    // Parts in the order in which they take their facets: the corner nearest the pole and the
    // middle first, as they are asked for most.
    static constexpr int kOrder[4] = {2, 3, 0, 1};

    void build(std::uint32_t node, int level, Vec3f a, Vec3f b, Vec3f c, double alpha);

    int depth_;
    std::vector<Node> nodes_;     // those that are split
    std::vector<double> masses_;  // all, within an octant of mass 1/4
};

}  // namespace nacre::sparkle
