// How long one walk of light takes, for eight wavelengths on one core: position-free, and through a
// shell of paint on a sphere of 50 mm with either tracking; and how long it takes to bind a walk to
// a set of wavelengths. And the reference: walks that connect to the six angles of an instrument,
// on all cores.
//
//   ./dev bench --benchmark_filter='Walk|Reference'

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "nacre/core/file.h"
#include "nacre/core/random.h"
#include "nacre/io/recipe_file.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/montecarlo/reference.h"
#include "nacre/montecarlo/shell_walk.h"

namespace nacre::montecarlo {
namespace {

constexpr bsdf::Wavelengths kWavelengths{418, 456, 493, 531, 568, 606, 643, 681};

paint::Recipe paint(const std::string& name) {
    return io::read_recipe(shipped_file("paints/" + name + ".toml"));
}

using Surface = std::unique_ptr<const bsdf::BoundBsdf>;

Surface plane(const paint::Recipe& recipe) { return PlaneWalk(recipe).bind(kWavelengths); }
Surface delta(const paint::Recipe& recipe) {
    return ShellWalk(recipe, {.radius_mm = 50}).bind(kWavelengths);
}
Surface simpson(const paint::Recipe& recipe) {
    return ShellWalk(recipe, {.radius_mm = 50, .tracking = Tracking::simpson}).bind(kWavelengths);
}

/// From incident directions cosine-distributed over the hemisphere.
void BM_Walk8Wavelengths(benchmark::State& state, Surface (*make)(const paint::Recipe&),
                         const std::string& name) {
    const Surface surface = make(paint(name));
    Rng rng(1, 1);
    std::int64_t left = 0;
    for (auto _ : state) {
        const float z = std::sqrt(rng.uniform_float()), s = std::sqrt(1 - z * z);
        const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
        const float u_select = rng.uniform_float(), u = rng.uniform_float();
        const auto sample = surface->sample({s * std::cos(phi), s * std::sin(phi), z}, u_select,
                                            {u, rng.uniform_float()});
        benchmark::DoNotOptimize(sample);
        left += sample.has_value();
    }
    state.SetItemsProcessed(state.iterations());
    state.counters["left"] = static_cast<double>(left) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(BM_Walk8Wavelengths, metallic_gray_plane, plane, "metallic-gray");
BENCHMARK_CAPTURE(BM_Walk8Wavelengths, metallic_gray_delta, delta, "metallic-gray");
BENCHMARK_CAPTURE(BM_Walk8Wavelengths, metallic_gray_simpson, simpson, "metallic-gray");
BENCHMARK_CAPTURE(BM_Walk8Wavelengths, cadmium_red_plane, plane, "cadmium-red");
BENCHMARK_CAPTURE(BM_Walk8Wavelengths, cadmium_red_delta, delta, "cadmium-red");
BENCHMARK_CAPTURE(BM_Walk8Wavelengths, cadmium_red_simpson, simpson, "cadmium-red");
BENCHMARK_CAPTURE(BM_Walk8Wavelengths, tio2_mica_80_delta, delta, "tio2-mica-80");

/// What a renderer pays once for each set of wavelengths.
void BM_WalkBind(benchmark::State& state, const std::string& name) {
    const ShellWalk model(paint(name), {.radius_mm = 50});
    for (auto _ : state) benchmark::DoNotOptimize(model.bind(kWavelengths));
}
BENCHMARK_CAPTURE(BM_WalkBind, metallic_gray, "metallic-gray");
BENCHMARK_CAPTURE(BM_WalkBind, tio2_mica_80, "tio2-mica-80");

/// `variance` is relative, at 45as45 and 550 nm: times the time of an iteration it is what counts.
void BM_ReferenceSixAngles(benchmark::State& state, const std::string& name) {
    constexpr std::uint64_t kWalks = 20'000;
    const paint::Recipe recipe = paint(name);
    const std::vector<Direction> incident = {{45, 0}};
    const std::vector<Direction> outgoing = {{60, 180}, {30, 180}, {20, 180},
                                             {0, 0},    {30, 0},   {65, 0}};
    const std::vector<double> wavelengths_nm = {550};
    double variance = 0;
    for (auto _ : state) {
        const Estimate f = reference_brdf(recipe, incident, outgoing, wavelengths_nm,
                                          {.samples = kWalks, .seed = 1})[3];
        variance = std::pow(f.standard_error / f.value, 2);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(kWalks) * state.iterations());
    state.counters["variance"] = variance;
}
BENCHMARK_CAPTURE(BM_ReferenceSixAngles, metallic_silver, "metallic-silver")->UseRealTime();
BENCHMARK_CAPTURE(BM_ReferenceSixAngles, satin_silver, "satin-silver")->UseRealTime();
BENCHMARK_CAPTURE(BM_ReferenceSixAngles, white_pearl, "white-pearl")->UseRealTime();

}  // namespace
}  // namespace nacre::montecarlo
