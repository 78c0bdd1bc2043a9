#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/random.h"
#include "nacre/testing/directions.h"

// Only for tests of surfaces: statistics of their samples.

namespace nacre::bsdf {

using test::direction;

/// Chi-square of sampled directions against the density, over bins of cosine and azimuth, with one
/// more bin for what is not a direction (the specular lobe, and samples that do not leave), as a
/// standard normal variable: the cube root of chi-square over its mean is normal.
/// [wilson-hilferty-1931] For lobes so wide that midpoints of a 16th of a bin integrate them: some
/// 10 deg.
inline double chi_square_z_score(const BoundBsdf& bound, Vec3f wi, std::uint64_t seed,
                                 int samples) {
    constexpr int kCosines = 12, kAzimuths = 16, kSub = 16;
    std::vector<double> expected(kCosines * kAzimuths + 1, 0.0), found(expected);
    for (int c = 0; c < kCosines * kSub; ++c) {
        const double z = (c + 0.5) / (kCosines * kSub), s = std::sqrt(1 - z * z);
        for (int a = 0; a < kAzimuths * kSub; ++a) {
            const double phi = 2 * std::numbers::pi * (a + 0.5) / (kAzimuths * kSub);
            const Vec3f wo = {static_cast<float>(s * std::cos(phi)),
                              static_cast<float>(s * std::sin(phi)), static_cast<float>(z)};
            expected[c / kSub * kAzimuths + a / kSub] += bound.pdf(wi, wo) * samples * 2 *
                                                         std::numbers::pi /
                                                         (kCosines * kSub * kAzimuths * kSub);
        }
    }
    double inside = 0;
    for (double e : expected) inside += e;
    EXPECT_LE(inside, 1.001 * samples);
    expected.back() = samples - inside;
    Rng rng(seed, 1);
    for (int i = 0; i < samples; ++i) {
        const auto s =
            bound.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
        if (!s || s->kind == SampleKind::specular) {
            ++found.back();
            continue;
        }
        double phi = std::atan2(s->wo.y, s->wo.x);
        if (phi < 0) phi += 2 * std::numbers::pi;
        const int c = std::min(static_cast<int>(s->wo.z * kCosines), kCosines - 1);
        const int a =
            std::min(static_cast<int>(phi / (2 * std::numbers::pi) * kAzimuths), kAzimuths - 1);
        ++found[c * kAzimuths + a];
    }
    double statistic = 0, rare_expected = 0, rare_found = 0;
    int bins = 0;
    for (std::size_t b = 0; b < expected.size(); ++b) {
        if (expected[b] < 10) {
            rare_expected += expected[b];
            rare_found += found[b];
            continue;
        }
        statistic += std::pow(found[b] - expected[b], 2) / expected[b];
        ++bins;
    }
    if (rare_expected >= 10) {
        statistic += std::pow(rare_found - rare_expected, 2) / rare_expected;
        ++bins;
    }
    EXPECT_GT(bins, 20);
    const double freedom = bins - 1, spread = 2 / (9 * freedom);
    return (std::cbrt(statistic / freedom) - (1 - spread)) / std::sqrt(spread);
}

/// Mean of the weights of sample() at one wavelength, misses counting as 0: the albedo,
/// specular reflection included; and the standard error of that mean.
struct MeanWeight {
    double mean, error;
};
inline MeanWeight mean_weight(const BoundBsdf& bound, Vec3f wi, int lane, int samples,
                              std::uint64_t seed) {
    Rng rng(seed, 1);
    double sum = 0, square = 0;
    for (int i = 0; i < samples; ++i) {
        const auto s =
            bound.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
        const double w = s ? s->weight[lane] : 0.0;
        sum += w;
        square += w * w;
    }
    const double mean = sum / samples;
    return {mean, std::sqrt(std::max(0.0, square / samples - mean * mean) / samples)};
}

}  // namespace nacre::bsdf
