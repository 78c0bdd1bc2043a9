#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/parallel.h"
#include "nacre/core/rng.h"
#include "nacre/optics/material.h"
#include "nacre/reference/test_support.h"

// What the tests of this folder share: walks in numbers, and the statistics of what they bring.

namespace nacre::volume::test {

using reference::Estimate;
using reference::test::flake_layer;
using reference::test::kWorstZ;
using reference::test::paint;
using reference::test::pigment_layer;
using reference::test::worked_paint;
using reference::test::z_score;

/// Eight wavelengths of the grid on which films are computed, so that nothing is interpolated.
inline constexpr bsdf::Wavelengths kOnGrid{420, 460, 500, 540, 580, 620, 660, 690};

/// What a recipe may hold: flakes that let light pass, a pigment, an absorbing clearcoat, two
/// layers and a ground; different at every wavelength.
inline layers::Recipe pearl() {
    layers::Layer top = flake_layer(0.8, 0.15, 0, 0);
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, {60}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 110, {5}}};
    top.flakes[0].body = platelet;
    layers::Layer below = pigment_layer(0.8, 1.0, 0.4);
    below.flakes = flake_layer(30, 0.3, 0.5, 0.2).flakes;
    below.flakes[0].amount = layers::AreaDensity{0.004};
    layers::Recipe recipe = paint(1.5, {top, below}, 0.3);
    recipe.name = "pearl";
    recipe.clearcoat.emplace();
    recipe.clearcoat->thickness_um = 40;
    recipe.clearcoat->absorption_per_mm = spectra::Spectrum({400, 700}, {8, 1});
    return recipe;
}

inline Vec3f from_degrees(double theta, double phi) {
    const double t = theta * std::numbers::pi / 180, p = phi * std::numbers::pi / 180;
    return {static_cast<float>(std::sin(t) * std::cos(p)),
            static_cast<float>(std::sin(t) * std::sin(p)), static_cast<float>(std::cos(t))};
}

/// Estimates of several quantities at eight wavelengths: [quantity][lane].
using Estimates = std::vector<std::array<Estimate, kLanes>>;

/// What a sample is worth for each quantity, appended as (quantity, value).
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
            const float u_lobe = rng.uniform_float(), x = rng.uniform_float();
            const auto sample = surface.sample(wi, u_lobe, {x, rng.uniform_float()});
            if (!sample) continue;
            std::fill(values.begin(), values.end(), FloatLanes{});
            score(*sample, values);
            for (std::size_t q = 0; q < quantities; ++q) {
                const auto v = __builtin_convertvector(values[q], DoubleLanes);
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
            const double mean = sum[lane] / n;
            const double variance = std::max(0.0, squares[lane] / n - mean * mean) * n / (n - 1);
            result[q][lane] = {mean, std::sqrt(variance / n)};
        }
    }
    return result;
}

/// Share of the light from wi that leaves again, mirror included.
inline std::array<Estimate, kLanes> walked_albedo(const bsdf::BoundBsdf& surface, Vec3f wi,
                                                  int count, std::uint64_t seed = 1) {
    return estimate(surface, wi, count, 1, seed,
                    [](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
                        values[0] = s.weight;
                    })[0];
}

inline bool is_mirror_image(Vec3f wi, Vec3f wo) {
    return std::abs(wi.x + wo.x) < 1e-6f && std::abs(wi.y + wo.y) < 1e-6f &&
           std::abs(wi.z - wo.z) < 1e-6f;
}

}  // namespace nacre::volume::test
