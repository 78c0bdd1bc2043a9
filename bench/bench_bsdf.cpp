// How long one evaluation, sample or density of the micro-flake model takes, for eight wavelengths
// on one core.
//
//   ./dev bench --benchmark_filter=Microflake

#include <benchmark/benchmark.h>

#include "bsdf_queries.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::bsdf {
namespace {

template <class F>
void run(benchmark::State& state, F&& f) {
    static const auto bound = Microflake(std::make_shared<const solver::SolvedPaint>(solver::solve(
                                             bench_pearl(), spectra::default_wavelengths_nm())))
                                  .bind(kBenchWavelengths);
    static const std::vector<Query> queries = make_queries(*bound);
    run_queries(state, *bound, queries, f);
}

void BM_MicroflakeEval8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.eval(q.wi, q.wo); });
}
BENCHMARK(BM_MicroflakeEval8Wavelengths);

void BM_MicroflakeSample8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.sample(q.wi, q.u_select, q.u); });
}
BENCHMARK(BM_MicroflakeSample8Wavelengths);

void BM_MicroflakePdf(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.pdf(q.wi, q.wo); });
}
BENCHMARK(BM_MicroflakePdf);

}  // namespace
}  // namespace nacre::bsdf
