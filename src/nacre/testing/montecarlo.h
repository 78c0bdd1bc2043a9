#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/montecarlo/reference.h"
#include "nacre/optics/material.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

// Only for tests of random walks: paints, and estimates by walks.

namespace nacre::montecarlo::test {

using namespace nacre::test;

inline const std::vector<double> kGreen{550};

inline std::vector<Estimate> brdf(const paint::Recipe& recipe, const Direction& incident,
                                  const std::vector<Direction>& outgoing,
                                  const ReferenceSettings& settings) {
    return reference_brdf(recipe, std::vector{incident}, outgoing, kGreen, settings);
}

inline double degrees_of_cosine(double cosine) {
    return std::acos(cosine) * 180 / std::numbers::pi;
}

/// Flakes that transmit light, a pigment, an absorbing clearcoat, two layers and a substrate, whose
/// optics differ between wavelengths.
inline paint::Recipe pearl() {
    paint::Layer top = flake_layer(0.8, 0.15, 0, 0);
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, {60}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 110, {5}}};
    top.flakes[0].body = platelet;
    paint::Layer below = pigment_layer(0.8, 1.0, 0.4);
    below.flakes = flake_layer(30, 0.3, 0.5, 0.2).flakes;
    below.flakes[0].amount = paint::AreaDensity{0.004};
    paint::Recipe recipe = paint_of(1.5, {top, below}, 0.3);
    recipe.name = "pearl";
    recipe.clearcoat.emplace();
    recipe.clearcoat->thickness_um = 40;
    recipe.clearcoat->absorption_per_mm = spectra::Spectrum({400, 700}, {8, 1});
    return recipe;
}

/// Estimates of several quantities at eight wavelengths: [quantity][lane].
using Estimates = std::vector<std::array<Estimate, kLanes>>;

/// Writes the value of each quantity for a sample into `values`, which are 0 before.
using Score = std::function<void(const bsdf::BsdfSample&, std::vector<FloatLanes>& values)>;

/// Means over `count` samples of `surface` from wi; walks are a function of (seed, number) alone.
inline Estimates estimate(const bsdf::BoundBsdf& surface, Vec3f wi, int count,
                          std::size_t quantities, std::uint64_t seed, const Score& score) {
    constexpr std::size_t kBlock = 4096;
    const std::size_t blocks = (static_cast<std::size_t>(count) + kBlock - 1) / kBlock;
    struct Sums {
        std::vector<DoubleLanes> sum, squares;
    };
    std::vector<Sums> of_block(blocks);
    parallel_for(0, blocks, [&](std::size_t b) {
        Sums& sums = of_block[b];
        sums.sum.resize(quantities);
        sums.squares.resize(quantities);
        std::vector<FloatLanes> values(quantities);
        Rng rng(seed, b);
        const std::size_t last = std::min<std::size_t>((b + 1) * kBlock, count);
        for (std::size_t i = b * kBlock; i < last; ++i) {
            const float u_select = rng.uniform_float(), x = rng.uniform_float();
            const auto sample = surface.sample(wi, u_select, {x, rng.uniform_float()});
            if (!sample) continue;
            std::fill(values.begin(), values.end(), FloatLanes{});
            score(*sample, values);
            for (std::size_t q = 0; q < quantities; ++q) {
                const DoubleLanes v = to_double(values[q]);
                sums.sum[q] += v;
                sums.squares[q] += v * v;
            }
        }
    });
    Estimates result(quantities);
    const double n = count;
    for (std::size_t q = 0; q < quantities; ++q) {
        DoubleLanes sum{}, squares{};
        for (const Sums& sums : of_block) {
            sum += sums.sum[q];
            squares += sums.squares[q];
        }
        for (int lane = 0; lane < kLanes; ++lane) {
            result[q][lane] = estimate_of_mean(sum[lane], squares[lane], n);
        }
    }
    return result;
}

/// The fraction of the light from wi that leaves again, specular reflection included.
inline std::array<Estimate, kLanes> walked_albedo(const bsdf::BoundBsdf& surface, Vec3f wi,
                                                  int count, std::uint64_t seed = 1) {
    return estimate(surface, wi, count, 1, seed,
                    [](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
                        values[0] = s.weight;
                    })[0];
}

}  // namespace nacre::montecarlo::test
