// How long the nacre model takes to look at a patch and to evaluate and sample it, for eight
// wavelengths on one core, by the number of flakes in the footprint; and how long the smooth model
// takes, which is its mean. bench_special_effect has the same for facets that are counted.
//
//   ./dev bench --benchmark_filter=Nacre

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bsdf_queries.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::bsdf {
namespace {

struct Setup {
    std::shared_ptr<const solver::SolvedPaint> paint = std::make_shared<const solver::SolvedPaint>(
        solver::solve(bench_pearl(), spectra::default_wavelengths_nm()));
    Nacre nacre{paint, {.specimen = 1}};
    std::unique_ptr<const BoundBsdf> bound = nacre.bind(kBenchWavelengths);
    std::vector<Query> queries = make_queries(*bound);

    static const Setup& get() {
        static const Setup setup;
        return setup;
    }
    double flakes_per_mm2() const {
        const paint::FlakeSpecies& flake = paint->recipe.layers[0].flakes[0];
        const double radius_mm = 0.5e-3 * flake.diameter_um;
        return flake.area_density_per_um() * paint->recipe.layers[0].thickness_um /
               (std::numbers::pi * radius_mm * radius_mm);
    }
};

// Squares at random places and angles on a sphere of radius 100 mm, that hold `flakes` flakes on
// average.
std::vector<Patch> patches(double flakes) {
    std::vector<Patch> out;
    Rng rng(4, 2);
    const float side = static_cast<float>(std::sqrt(flakes / Setup::get().flakes_per_mm2()));
    for (int i = 0; i < 4096; ++i) {
        const float z = 2 * rng.uniform_float() - 1, s = std::sqrt(1 - z * z);
        const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
        const Vec3f n = {s * std::cos(phi), s * std::sin(phi), z};
        const Frame frame = Frame::around(n);
        const float turn = 2 * std::numbers::pi_v<float> * rng.uniform_float();
        const float c = side * std::cos(turn), d = side * std::sin(turn);
        Patch patch;
        patch.footprint = {
            100.0f * n, n, frame.s, {c * frame.s + d * frame.t, c * frame.t - d * frame.s}};
        out.push_back(patch);
    }
    return out;
}

template <class F>
void run(benchmark::State& state, F&& f) {
    const Setup& setup = Setup::get();
    const std::vector<Patch> all = patches(0.01 * static_cast<double>(state.range(0)));
    PatchMemory memory(setup.bound->patch_memory_bytes());
    std::size_t i = 0;
    for (auto _ : state) {
        Patch patch = all[i];
        patch.memory = &memory;
        memory.forget();
        benchmark::DoNotOptimize(f(*setup.bound, patch, setup.queries[i]));
        i = (i + 1) % all.size();
    }
}

void footprints(benchmark::internal::Benchmark* b) {
    b->ArgName("centi_flakes")->Arg(5)->Arg(30)->Arg(500)->Arg(10000)->Arg(100000);
    b->Arg(1000000)->Arg(100000000);
}

void BM_NacreEvaluateOn8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Patch& p, const Query& q) {
        return b.evaluate_on(p, q.wi, q.wo);
    });
}
BENCHMARK(BM_NacreEvaluateOn8Wavelengths)->Apply(footprints);

void BM_NacreSampleOn8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Patch& p, const Query& q) {
        return b.sample_on(p, q.wi, q.u_select, q.u);
    });
}
BENCHMARK(BM_NacreSampleOn8Wavelengths)->Apply(footprints);

// What a renderer does at each point: a sample of the light and one of the surface.
void BM_NacreEvaluateAndSampleOn8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Patch& p, const Query& q) {
        benchmark::DoNotOptimize(b.evaluate_on(p, q.wi, q.wo));
        return b.sample_on(p, q.wi, q.u_select, q.u);
    });
}
BENCHMARK(BM_NacreEvaluateAndSampleOn8Wavelengths)->Apply(footprints);

// Another pair of directions on a patch that has been looked at.
template <class F>
void run_again(benchmark::State& state, F&& f) {
    const Setup& setup = Setup::get();
    std::vector<Patch> all = patches(0.01 * static_cast<double>(state.range(0)));
    all.resize(64);
    std::vector<PatchMemory> memory(all.size(), PatchMemory(setup.bound->patch_memory_bytes()));
    for (std::size_t k = 0; k < all.size(); ++k) {
        all[k].memory = &memory[k];
        setup.bound->evaluate_on(all[k], setup.queries[k].wi, setup.queries[k].wo);
    }
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(f(*setup.bound, all[i % all.size()], setup.queries[i]));
        i = (i + 1) % setup.queries.size();
    }
}

void BM_NacreEvaluateAgain8Wavelengths(benchmark::State& state) {
    run_again(state, [](const BoundBsdf& b, const Patch& p, const Query& q) {
        return b.evaluate_on(p, q.wi, q.wo);
    });
}
BENCHMARK(BM_NacreEvaluateAgain8Wavelengths)->Apply(footprints);

void BM_NacreSampleAgain8Wavelengths(benchmark::State& state) {
    run_again(state, [](const BoundBsdf& b, const Patch& p, const Query& q) {
        return b.sample_on(p, q.wi, q.u_select, q.u);
    });
}
BENCHMARK(BM_NacreSampleAgain8Wavelengths)->Apply(footprints);

void BM_NacreLook(benchmark::State& state) {
    const Setup& setup = Setup::get();
    const std::vector<Patch> all = patches(0.01 * static_cast<double>(state.range(0)));
    const sparkle::FlakeField field({.density_per_mm2 = setup.flakes_per_mm2(), .alpha = 0.09}, 1);
    sparkle::FlakeView view;
    std::size_t i = 0;
    double found = 0;
    for (auto _ : state) {
        field.query(all[i].footprint, view);
        benchmark::DoNotOptimize(view);
        found += view.count;
        i = (i + 1) % all.size();
    }
    state.counters["found"] = found / static_cast<double>(state.iterations());
}
BENCHMARK(BM_NacreLook)->Apply(footprints);

void BM_NacreMean8Wavelengths(benchmark::State& state) {
    const Setup& setup = Setup::get();
    run_queries(state, *setup.bound, setup.queries,
                [](const BoundBsdf& b, const Query& q) { return b.evaluate(q.wi, q.wo); });
}
BENCHMARK(BM_NacreMean8Wavelengths);

void BM_NacreMeanSample8Wavelengths(benchmark::State& state) {
    const Setup& setup = Setup::get();
    run_queries(state, *setup.bound, setup.queries,
                [](const BoundBsdf& b, const Query& q) { return b.sample(q.wi, q.u_select, q.u); });
}
BENCHMARK(BM_NacreMeanSample8Wavelengths);

void BM_NacreBind(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(Setup::get().nacre.bind(kBenchWavelengths));
}
BENCHMARK(BM_NacreBind)->Unit(benchmark::kMicrosecond);

void BM_NacreConstruction(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(Nacre(Setup::get().paint, {.specimen = 1}));
}
BENCHMARK(BM_NacreConstruction)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nacre::bsdf
