// How long a BRDF table takes to make and to compress, and how long one evaluation or sample of it
// takes for eight wavelengths on one core. Compare with bench_bsdf, which evaluates the same paint
// split.
//
//   ./dev bench --benchmark_filter=Table

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "nacre/bsdf/tabulated.h"
#include "nacre/core/rng.h"
#include "nacre/layers/brdf_table_svd.h"
#include "nacre/layers/solver.h"

namespace nacre::bsdf {
namespace {

struct Query {
    Vec3f wi, wo;
    float u_lobe;
    Vec2f u;
};

struct Setup {
    layers::SolvedPaint paint;
    std::shared_ptr<const layers::RawBrdfTable> raw;
    std::shared_ptr<const layers::CompressedBrdfTable> compressed;
    std::unique_ptr<const BoundBsdf> bound_raw, bound_compressed;
    std::vector<Query> queries;

    Setup() {
        optics::Platelet platelet;
        platelet.core = {optics::find_material("mica"), 500, {60}};
        platelet.coats = {{optics::find_material("TiO2_anatase"), 80, {5}}};
        layers::FlakeSpecies flake;
        flake.amount = layers::AreaDensity{0.1};
        flake.orientation.beckmann_alpha = 0.09;
        flake.body = platelet;
        layers::Recipe recipe;
        recipe.layers.push_back({15, {flake}, {}});
        paint = layers::solve(recipe, layers::default_wavelengths_nm());
        raw = std::make_shared<const layers::RawBrdfTable>(layers::make_raw_table(paint));
        compressed =
            std::make_shared<const layers::CompressedBrdfTable>(layers::compress(*raw, {3, 0.5}));
        const Wavelengths wavelengths = {418, 456, 493, 531, 568, 606, 643, 681};
        bound_raw = Tabulated(raw).bind(wavelengths);
        bound_compressed = Tabulated(compressed).bind(wavelengths);
        // Incident directions over the hemisphere, outgoing ones as the model samples them.
        Rng rng(1, 1);
        while (queries.size() < 4096) {
            Query q;
            const float z = std::sqrt(rng.uniform_float()), s = std::sqrt(1 - z * z);
            const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
            q.wi = {s * std::cos(phi), s * std::sin(phi), z};
            q.u_lobe = rng.uniform_float();
            q.u = {rng.uniform_float(), rng.uniform_float()};
            const auto sample = bound_raw->sample(q.wi, q.u_lobe, q.u);
            if (!sample || sample->mirror) continue;
            q.wo = sample->wo;
            queries.push_back(q);
        }
    }
    static const Setup& get() {
        static const Setup setup;
        return setup;
    }
    const BoundBsdf& bound(bool is_raw) const { return is_raw ? *bound_raw : *bound_compressed; }
};

void BM_TableMakeRaw(benchmark::State& state) {
    const layers::SolvedPaint& paint = Setup::get().paint;
    for (auto _ : state) benchmark::DoNotOptimize(layers::make_raw_table(paint));
}
BENCHMARK(BM_TableMakeRaw)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_TableCompress(benchmark::State& state) {
    const layers::CompressionSettings settings{static_cast<int>(state.range(0)), 0.5};
    for (auto _ : state) {
        benchmark::DoNotOptimize(layers::compress(*Setup::get().raw, settings));
    }
}
BENCHMARK(BM_TableCompress)->Arg(3)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();

template <bool is_raw>
void BM_TableEval8Wavelengths(benchmark::State& state) {
    const Setup& setup = Setup::get();
    std::size_t i = 0;
    for (auto _ : state) {
        const Query& q = setup.queries[i];
        benchmark::DoNotOptimize(setup.bound(is_raw).eval(q.wi, q.wo));
        i = (i + 1) % setup.queries.size();
    }
}
BENCHMARK(BM_TableEval8Wavelengths<true>)->Name("BM_TableRawEval8Wavelengths");
BENCHMARK(BM_TableEval8Wavelengths<false>)->Name("BM_TableSvdEval8Wavelengths");

template <bool is_raw>
void BM_TableSample8Wavelengths(benchmark::State& state) {
    const Setup& setup = Setup::get();
    std::size_t i = 0;
    for (auto _ : state) {
        const Query& q = setup.queries[i];
        benchmark::DoNotOptimize(setup.bound(is_raw).sample(q.wi, q.u_lobe, q.u));
        i = (i + 1) % setup.queries.size();
    }
}
BENCHMARK(BM_TableSample8Wavelengths<true>)->Name("BM_TableRawSample8Wavelengths");
BENCHMARK(BM_TableSample8Wavelengths<false>)->Name("BM_TableSvdSample8Wavelengths");

}  // namespace
}  // namespace nacre::bsdf
