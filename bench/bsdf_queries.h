#pragma once

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/random.h"
#include "nacre/paint/recipe.h"

// What the benchmarks of surfaces share: wavelengths, a paint, and the queries of a renderer.

namespace nacre::bsdf {

inline constexpr Wavelengths kBenchWavelengths = {418, 456, 493, 531, 568, 606, 643, 681};

/// Titania on mica, without a coat of its own: the paint of the solver's benchmarks.
inline paint::Recipe bench_pearl() {
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, {60}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 80, {5}}};
    paint::FlakeSpecies flake;
    flake.amount = paint::AreaDensity{0.1};
    flake.orientation.beckmann_alpha = 0.09;
    flake.body = platelet;
    paint::Recipe recipe;
    recipe.layers.push_back({15, {flake}, {}});
    return recipe;
}

struct Query {
    Vec3f wi, wo;
    float u_select;
    Vec2f u;
};

/// Incident directions over the hemisphere, outgoing ones as the model samples them.
inline std::vector<Query> make_queries(const BoundBsdf& bsdf) {
    std::vector<Query> queries;
    Rng rng(1, 1);
    while (queries.size() < 4096) {
        Query q;
        const float z = std::sqrt(rng.uniform_float()), s = std::sqrt(1 - z * z);
        const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
        q.wi = {s * std::cos(phi), s * std::sin(phi), z};
        q.u_select = rng.uniform_float();
        q.u = {rng.uniform_float(), rng.uniform_float()};
        const auto sample = bsdf.sample(q.wi, q.u_select, q.u);
        if (!sample || sample->kind != SampleKind::density) continue;
        q.wo = sample->wo;
        queries.push_back(q);
    }
    return queries;
}

/// One call of f(bsdf, query) after the other.
template <class F>
void run_queries(benchmark::State& state, const BoundBsdf& bsdf, const std::vector<Query>& queries,
                 F&& f) {
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(f(bsdf, queries[i]));
        i = (i + 1) % queries.size();
    }
}

}  // namespace nacre::bsdf
