// How long a paint takes to solve: the whole, and its parts.
//
//   ./dev bench --benchmark_filter=Solve

#include <benchmark/benchmark.h>

#include <cmath>

#include "nacre/solver/impedance.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::solver {

using namespace paint;
namespace {

// TiO2 on mica in a binder of index 1.5; c = 0.1 per um, thickness 15 um.
Recipe pearl(double alpha) {
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, {60}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 80, {5}}};
    FlakeSpecies flake;
    flake.amount = AreaDensity{0.1};
    flake.orientation.beckmann_alpha = alpha;
    flake.body = platelet;
    Recipe recipe;
    recipe.layers.push_back({15, {flake}, {}});
    return recipe;
}

void BM_SolvePearl31Wavelengths(benchmark::State& state) {
    const Recipe recipe = pearl(1e-3 * static_cast<double>(state.range(0)));
    const auto wavelengths = spectra::default_wavelengths_nm();
    SolverReport report;
    for (auto _ : state) {
        const SolvedPaint paint = solve(recipe, wavelengths);
        benchmark::DoNotOptimize(paint.multiple_scattering.coefficient.data());
        report = paint.report;
    }
    state.counters["exit_nodes"] = report.exit_nodes;
    state.counters["orders"] = report.orders;
}
BENCHMARK(BM_SolvePearl31Wavelengths)
    ->ArgName("alpha_thousandths")
    ->Arg(20)
    ->Arg(50)
    ->Arg(90)
    ->Arg(200)
    ->Arg(500)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// The optics alone: films, spectra.
void BM_SolveMediumOnly(benchmark::State& state) {
    const Recipe recipe = pearl(0.09);
    const auto wavelengths = spectra::default_wavelengths_nm();
    for (auto _ : state) {
        const PaintMedium medium = make_medium(recipe, wavelengths);
        benchmark::DoNotOptimize(medium.ior.data());
    }
}
BENCHMARK(BM_SolveMediumOnly)->Unit(benchmark::kMillisecond)->UseRealTime();

// One slab on one core, eight wavelengths: compare its GFlop/s with the peak's.
void BM_SlabImpedance(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    constexpr int kDoublings = 6;
    LaneBuffer e(n * n), f(n * n), e0(n * n), f0(n * n);
    ImpedanceWorkspace work(n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            e0[i * n + j] = splat(i == j ? 2.0 + i : -0.5 / n);
            f0[i * n + j] = splat(i == j ? 2.0 + i : 0.5 / n);
        }
    }
    for (auto _ : state) {
        e = e0;
        f = f0;
        slab_impedance(e.data(), f.data(), 10.0, kDoublings, n, work);
        benchmark::DoNotOptimize(e.data());
    }
    // Flops of the inverse: n^3 (Cholesky, triangular inverse and Gram product a third each); of
    // each of the two steps of the start and of every doubling: 7/3 n^3 (Cholesky a third, solve and
    // Gram product one each).
    const double flops = kLanes * std::pow(n, 3) * (1.0 + (kDoublings + 2) * (7.0 / 3.0));
    state.counters["GFlop/s"] =
        benchmark::Counter(flops * 1e-9 * state.iterations(), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_SlabImpedance)
    ->ArgName("nodes")
    ->Arg(24)
    ->Arg(28)
    ->Arg(32)
    ->Arg(48)
    ->Arg(72)
    ->Unit(benchmark::kMicrosecond);

// What the core can do at best: multiply-adds of lanes in registers, nothing else.
void BM_PeakMultiplyAdd(benchmark::State& state) {
    constexpr int kChains = 12, kRounds = 1000;  // enough chains to hide the latency
    DoubleLanes sum[kChains] = {};
    const DoubleLanes factor = splat(0.999), term = splat(1e-3);
    for (auto _ : state) {
        for (int k = 0; k < kRounds; ++k) {
            for (DoubleLanes& x : sum) x = x * factor + term;
        }
        benchmark::DoNotOptimize(sum);
    }
    state.counters["GFlop/s"] = benchmark::Counter(
        2e-9 * kLanes * kChains * kRounds * state.iterations(), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_PeakMultiplyAdd);

}  // namespace
}  // namespace nacre::solver
