// How long a BRDF table takes to make and to compress, and how long one evaluation or sample of it
// takes for eight wavelengths on one core. Compare with bench_bsdf, which evaluates the same paint
// split.
//
//   ./dev bench --benchmark_filter=Table

#include <benchmark/benchmark.h>

#include <memory>

#include "bsdf_queries.h"
#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::bsdf {
namespace {

struct Setup {
    solver::SolvedPaint paint;
    std::shared_ptr<const bsdf::RawBrdfTable> raw;
    std::shared_ptr<const bsdf::CompressedBrdfTable> compressed;
    std::unique_ptr<const BoundBsdf> bound_raw, bound_compressed;
    std::vector<Query> queries;

    Setup() {
        paint = solver::solve(bench_pearl(), spectra::default_wavelengths_nm());
        raw = std::make_shared<const bsdf::RawBrdfTable>(bsdf::make_raw_table(paint));
        compressed =
            std::make_shared<const bsdf::CompressedBrdfTable>(bsdf::compress(*raw, {3, 0.5}));
        bound_raw = Tabulated(raw).bind(kBenchWavelengths);
        bound_compressed = Tabulated(compressed).bind(kBenchWavelengths);
        queries = make_queries(*bound_raw);
    }
    static const Setup& get() {
        static const Setup setup;
        return setup;
    }
    const BoundBsdf& bound(bool is_raw) const { return is_raw ? *bound_raw : *bound_compressed; }
};

void BM_TableMakeRaw(benchmark::State& state) {
    const solver::SolvedPaint& paint = Setup::get().paint;
    for (auto _ : state) benchmark::DoNotOptimize(bsdf::make_raw_table(paint));
}
BENCHMARK(BM_TableMakeRaw)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_TableCompress(benchmark::State& state) {
    const bsdf::CompressionSettings settings{static_cast<int>(state.range(0)), 0.5};
    for (auto _ : state) {
        benchmark::DoNotOptimize(bsdf::compress(*Setup::get().raw, settings));
    }
}
BENCHMARK(BM_TableCompress)->Arg(3)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();

template <bool is_raw>
void BM_TableEval8Wavelengths(benchmark::State& state) {
    const Setup& setup = Setup::get();
    run_queries(state, setup.bound(is_raw), setup.queries,
                [](const BoundBsdf& b, const Query& q) { return b.eval(q.wi, q.wo); });
}
BENCHMARK(BM_TableEval8Wavelengths<true>)->Name("BM_TableRawEval8Wavelengths");
BENCHMARK(BM_TableEval8Wavelengths<false>)->Name("BM_TableSvdEval8Wavelengths");

template <bool is_raw>
void BM_TableSample8Wavelengths(benchmark::State& state) {
    const Setup& setup = Setup::get();
    run_queries(state, setup.bound(is_raw), setup.queries,
                [](const BoundBsdf& b, const Query& q) { return b.sample(q.wi, q.u_select, q.u); });
}
BENCHMARK(BM_TableSample8Wavelengths<true>)->Name("BM_TableRawSample8Wavelengths");
BENCHMARK(BM_TableSample8Wavelengths<false>)->Name("BM_TableSvdSample8Wavelengths");

}  // namespace
}  // namespace nacre::bsdf
