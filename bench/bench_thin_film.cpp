// How long the thin-film model takes on one core: the Airy reflectance alone, and one evaluation,
// sample or density of the BRDF, for eight wavelengths.
//
//   ./dev bench --benchmark_filter=ThinFilm

#include <benchmark/benchmark.h>

#include "bsdf_queries.h"
#include "nacre/bsdf/models/thin_film.h"
#include "nacre/optics/airy.h"
#include "nacre/optics/antialiased.h"

namespace nacre::bsdf {
namespace {

// The first parameter set of the comparison of 2022.
paint::Recipe paint(paint::FacetDistribution law, bool coat) {
    paint::Recipe recipe;
    recipe.microfacet = paint::Microfacet{0.07, law, 1.8, 158.333, 1.08, 0.51, {}};
    if (coat) recipe.clearcoat = paint::Clearcoat{40, 0.0, 0};
    return recipe;
}

// Arguments of a benchmark: GGX or not, under a coat or not, the colour mode.
paint::Recipe paint(const benchmark::State& state) {
    return paint(static_cast<paint::FacetDistribution>(state.range(0)), state.range(1) != 0);
}
ThinFilmColour colour(const benchmark::State& state) {
    return static_cast<ThinFilmColour>(state.range(2));
}

template <class F>
void run(benchmark::State& state, F&& f) {
    const auto bound = ThinFilm(paint(state), colour(state)).bind(kBenchWavelengths);
    run_queries(state, *bound, make_queries(*bound), f);
}

void all_kinds(benchmark::internal::Benchmark* b) {
    b->ArgNames({"ggx", "coat", "colour"})
        ->Args({0, 0, 0})
        ->Args({1, 0, 0})
        ->Args({0, 1, 0})
        ->Args({0, 0, 1});
}

void BM_ThinFilmEval8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.eval(q.wi, q.wo); });
}
BENCHMARK(BM_ThinFilmEval8Wavelengths)->Apply(all_kinds);

void BM_ThinFilmSample8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.sample(q.wi, q.u_select, q.u); });
}
BENCHMARK(BM_ThinFilmSample8Wavelengths)->Apply(all_kinds);

void BM_ThinFilmPdf(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.pdf(q.wi, q.wo); });
}
BENCHMARK(BM_ThinFilmPdf)->Apply(all_kinds);

void BM_ThinFilmBind(benchmark::State& state) {
    const ThinFilm model(paint(state), colour(state));
    for (auto _ : state) benchmark::DoNotOptimize(model.bind(kBenchWavelengths));
}
BENCHMARK(BM_ThinFilmBind)->Apply(all_kinds);

const FloatLanes kInverse =
    make_lanes([](int i) { return 1 / static_cast<float>(kBenchWavelengths[i]); });

void BM_ThinFilmAiry8Wavelengths(benchmark::State& state) {
    const optics::AiryFilm film(1, 1.8, 1.08, 0.51);
    float cosine = 0.3f;
    for (auto _ : state) {
        benchmark::DoNotOptimize(film.reflectance(cosine, 158.333f, kInverse));
        cosine = cosine < 0.99f ? cosine + 0.0007f : 0.3f;
    }
}
BENCHMARK(BM_ThinFilmAiry8Wavelengths);

// Many facets of one angle, each of its own thickness.
void BM_ThinFilmAiryOfAnotherThickness8Wavelengths(benchmark::State& state) {
    const auto angle = optics::AiryFilm(1, 1.8, 1.08, 0.51).at(0.8f);
    float thickness_nm = 100;
    for (auto _ : state) {
        benchmark::DoNotOptimize(angle.reflectance(thickness_nm * kInverse));
        thickness_nm = thickness_nm < 200 ? thickness_nm + 0.07f : 100;
    }
}
BENCHMARK(BM_ThinFilmAiryOfAnotherThickness8Wavelengths);

void BM_ThinFilmMoments1Wavelength(benchmark::State& state) {
    const optics::AiryFilm film(1, 1.8, 1.08, 0.51);
    for (auto _ : state) benchmark::DoNotOptimize(film.moments(0.8, {148, 168}, 550));
}
BENCHMARK(BM_ThinFilmMoments1Wavelength);

void BM_ThinFilmAntialiasedRgb(benchmark::State& state) {
    const optics::AiryFilm film(1, 1.8, 1.08, 0.51);
    const optics::Antialiasing how{static_cast<optics::ObserverTransform>(state.range(0)),
                                   static_cast<int>(state.range(1))};
    for (auto _ : state) {
        benchmark::DoNotOptimize(optics::antialiased_rgb(film, 0.8, 158.333, how));
    }
}
BENCHMARK(BM_ThinFilmAntialiasedRgb)
    ->ArgNames({"paper", "orders"})
    ->Args({0, optics::kEveryOrder})
    ->Args({0, 3})
    ->Args({1, 3});

}  // namespace
}  // namespace nacre::bsdf
