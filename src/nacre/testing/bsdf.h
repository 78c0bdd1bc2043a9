#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/random.h"
#include "nacre/paint/recipe.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/statistics.h"

// Only for tests of surfaces: statistics of their samples.

namespace nacre::bsdf {

using test::direction;
using test::kOnGrid;

/// Those of rough interfaces and of the models of facets.
inline constexpr paint::FacetDistribution kFacetLaws[] = {paint::FacetDistribution::beckmann,
                                                          paint::FacetDistribution::ggx};

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

/// Values of pairs of directions are reciprocal and none is negative.
/// @param relative  of single precision: a few dozen roundings, some amplified by the exponent of a
///                  lobe
inline void expect_reciprocal(const BoundBsdf& bound, int pairs, float absolute = 1e-5f,
                              float relative = 1e-4f) {
    Rng rng(7, 1);
    for (int i = 0; i < pairs; ++i) {
        const Vec3f a = direction(89.9 * rng.uniform_double(), 360 * rng.uniform_double());
        const Vec3f b = direction(89.9 * rng.uniform_double(), 360 * rng.uniform_double());
        const FloatLanes forth = bound.eval(a, b), back = bound.eval(b, a);
        for (int lane = 0; lane < kLanes; ++lane) {
            ASSERT_GE(forth[lane], 0);
            ASSERT_NEAR(forth[lane], back[lane], absolute + relative * forth[lane]);
        }
    }
}

inline void expect_black_below_the_horizon(const BoundBsdf& bound) {
    const Vec3f up = direction(30), down = {0.6f, 0, -0.8f};
    EXPECT_GT(lane_max(bound.albedo(up)), 0);
    EXPECT_EQ(lane_max(bound.eval(up, down)), 0);
    EXPECT_EQ(lane_max(bound.eval(down, up)), 0);
    EXPECT_EQ(bound.pdf(up, down), 0);
    EXPECT_EQ(bound.pdf(down, up), 0);
    EXPECT_EQ(lane_max(bound.albedo(down)), 0);
    EXPECT_FALSE(bound.sample(down, 0.5f, {0.5f, 0.5f}).has_value());
}

/// pdf_lanes() is pdf() of each direction, above the horizon and below.
inline void expect_densities_of_eight(const BoundBsdf& bound, float relative) {
    Rng rng(5, 2);
    int above = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3f wi = direction(89.5 * rng.uniform_double(), 360 * rng.uniform_double());
        Vec3Lanes wo;
        for (int k = 0; k < kLanes; ++k) {
            // Where samples lie as well as anywhere, the mirror direction itself once.
            const auto s =
                bound.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
            const Vec3f anywhere =
                direction(180 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f to = k == 0            ? Vec3f{-wi.x, -wi.y, wi.z}
                             : k % 2 == 1 && s ? s->wo
                                               : anywhere;
            wo.x[k] = to.x;
            wo.y[k] = to.y;
            wo.z[k] = to.z;
        }
        const FloatLanes eight = bound.pdf_lanes(wi, wo);
        for (int k = 0; k < kLanes; ++k) {
            const float one = bound.pdf(wi, lane(wo, k));
            above += one > 0;
            EXPECT_NEAR(eight[k], one, relative * one) << wi.z << " to " << wo.z[k];
        }
    }
    EXPECT_GT(above, 300 * kLanes / 2);
    EXPECT_EQ(lane_max(bound.pdf_lanes({0.6f, 0, -0.8f}, splat(direction(30)))), 0);
}

/// How often sample() took the specular lobe, or another direction, and the largest weight of
/// those.
struct Drawn {
    int specular = 0, others = 0;
    float largest_weight = 0;
};

/// What sample() says of a direction is what evaluate(), pdf() and eval() say.
/// @param relative  of the density
inline Drawn expect_own_density_and_weight(const BoundBsdf& bound, int samples, float relative) {
    Rng rng(3, 1);
    Drawn drawn;
    for (int i = 0; i < samples; ++i) {
        const Vec3f wi = direction(89 * rng.uniform_double(), 40);
        const auto s =
            bound.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
        if (!s) continue;
        if (s->kind == SampleKind::specular) {
            ++drawn.specular;
            EXPECT_FLOAT_EQ(s->wo.z, wi.z);
            continue;
        }
        ++drawn.others;
        drawn.largest_weight = test::worse(drawn.largest_weight, lane_max(s->weight));
        const BsdfValue both = bound.evaluate(wi, s->wo);
        EXPECT_NEAR(s->pdf, both.pdf, relative * s->pdf);
        EXPECT_NEAR(s->pdf, bound.pdf(wi, s->wo), relative * s->pdf);
        const FloatLanes f = bound.eval(wi, s->wo);
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_NEAR(both.f[lane], f[lane], 1e-4f * f[lane]);
            EXPECT_NEAR(s->weight[lane], f[lane] * s->wo.z / s->pdf, 1e-3f * s->weight[lane]);
        }
    }
    return drawn;
}

/// The samples of flakes of a patch, one by one.
inline std::vector<FlakeSample> flake_samples(const BoundBsdf& surface, const Patch& patch,
                                              Vec3f wi, std::uint32_t random) {
    std::vector<FlakeSamples> groups;
    surface.sample_flakes(patch, wi, random, groups);
    std::vector<FlakeSample> flakes;
    for (const FlakeSamples& group : groups) {
        for (int lane = 0; lane < kLanes; ++lane)
            if (group.strength[lane] > 0) flakes.push_back(group.flake(lane));
    }
    return flakes;
}

}  // namespace nacre::bsdf
