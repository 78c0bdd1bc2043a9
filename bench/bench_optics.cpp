#include <benchmark/benchmark.h>

#include "nacre/optics/fresnel.h"
#include "nacre/optics/thin_film.h"

// Thin films and flake averages, as solving a paint calls them: 31 wavelengths, 65 cosines.

namespace {

using namespace nacre::optics;

std::vector<double> wavelengths_nm() {
    std::vector<double> result;
    for (int i = 0; i <= 30; ++i) result.push_back(400 + 10 * i);
    return result;
}

std::vector<double> cosines() {
    std::vector<double> result;
    for (int i = 0; i <= 64; ++i) result.push_back(i / 64.0);
    return result;
}

void run(benchmark::State& state, const Platelet& platelet) {
    const auto wavelengths = wavelengths_nm();
    const auto mu = cosines();
    for (auto _ : state) {
        benchmark::DoNotOptimize(platelet_table(platelet, 1.5, mu, wavelengths));
    }
}

void BM_PlateletTitaniaOnMica(benchmark::State& state) {
    run(state, {{find_material("mica"), 500, {60}}, {{find_material("TiO2_anatase"), 80, {5}}}});
}
BENCHMARK(BM_PlateletTitaniaOnMica)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_PlateletHematiteOnSilica(benchmark::State& state) {
    run(state, {{find_material("SiO2"), 400, {40}}, {{find_material("Fe2O3"), 60, {10}}}});
}
BENCHMARK(BM_PlateletHematiteOnSilica)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_PlateletHematiteOnSilicaOnAluminium(benchmark::State& state) {
    run(state, {{find_material("Al"), 40, {4}},
                {{find_material("SiO2"), 350, {20}}, {find_material("Fe2O3"), 30, {4}}}});
}
BENCHMARK(BM_PlateletHematiteOnSilicaOnAluminium)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_StackOfThreeFilms(benchmark::State& state) {
    const ThinFilm films[] = {{2.5, 80}, {1.58, 500}, {2.5, 80}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            stack_reflectance(1.5, films, 1.5, 0.7, 550, Polarization::unpolarized));
    }
}
BENCHMARK(BM_StackOfThreeFilms);

void BM_DielectricReflectanceLanes(benchmark::State& state) {
    const auto cos_i = nacre::make_lanes([](int i) { return 0.1f + 0.1f * i; });
    for (auto _ : state) {
        benchmark::DoNotOptimize(fresnel_dielectric(nacre::splat(1.5f), cos_i));
    }
}
BENCHMARK(BM_DielectricReflectanceLanes);

}  // namespace
