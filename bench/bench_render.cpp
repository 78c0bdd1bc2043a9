// Samples a second of the path tracer, in processor time of all its threads: a ball under a uniform
// sky and one rectangle, with the smooth model of a silver paint, with a table of it as the RGL
// database has, and with single flakes; and the ball of `nacre render sphere`.
//
//   ./dev bench --benchmark_filter=Render

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "nacre/bsdf/measured/rgl.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/file.h"
#include "nacre/core/vec.h"
#include "nacre/io/recipe_file.h"
#include "nacre/measure/acquire.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/render.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::render {
namespace {

std::shared_ptr<const solver::SolvedPaint> silver() {
    static const auto paint = std::make_shared<const solver::SolvedPaint>(
        solver::solve(io::read_recipe(shipped_file("paints/metallic-silver.toml")),
                      spectra::default_wavelengths_nm()));
    return paint;
}

std::shared_ptr<const bsdf::Bsdf> microflake() {
    static const auto paint = std::make_shared<const bsdf::Microflake>(silver());
    return paint;
}

std::shared_ptr<const bsdf::Bsdf> single_flakes() {
    static const auto paint =
        std::make_shared<const bsdf::Nacre>(silver(), bsdf::NacreModel{.specimen = 1});
    return paint;
}

std::shared_ptr<const bsdf::Bsdf> measured() {
    static const auto table = [] {
        const std::vector<double>& wavelengths_nm = silver()->wavelengths_nm();
        std::vector<std::unique_ptr<const bsdf::BoundBsdf>> bound;
        for (std::size_t first = 0; first < wavelengths_nm.size(); first += kLanes) {
            bsdf::Wavelengths eight;
            for (std::size_t i = 0; i < eight.size(); ++i) {
                eight[i] = wavelengths_nm[std::min(first + i, wavelengths_nm.size() - 1)];
            }
            bound.push_back(microflake()->bind(eight));
        }
        const auto brdf = [&](double theta_i, double theta_o, double phi) {
            const auto direction = [](double theta, double azimuth) {
                return to_float(Vec3d{std::sin(theta) * std::cos(azimuth),
                                      std::sin(theta) * std::sin(azimuth), std::cos(theta)});
            };
            std::vector<double> values;
            for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
                values.push_back(bound[i / kLanes]->eval(direction(theta_i, 0),
                                                         direction(theta_o, phi))[i % kLanes]);
            }
            return values;
        };
        return measure::acquire_rgl("silver", brdf, wavelengths_nm, {});
    }();
    static const auto paint = std::make_shared<const bsdf::MeasuredRgl>(table);
    return paint;
}

SceneDescription ball_under_sky_and_rectangle() {
    SceneDescription scene = builtin_scene("sphere");
    scene.environment = ConstantEnvironment{.radiance = {.scale = 0.3}};
    scene.lights = {RectangleLight{.center_mm = {-300, -300, 600},
                                   .width_mm = 300,
                                   .height_mm = 300,
                                   .radiance = {.scale = 4}}};
    return scene;
}

void render_ball(benchmark::State& state, const SceneDescription& description,
                 const std::shared_ptr<const bsdf::Bsdf>& paint) {
    const Scene scene(description, {{"paint", paint}});
    const auto side = static_cast<int>(state.range(0));
    const RenderOptions options{.width = side, .height = side, .samples_per_pixel = 4};
    for (auto _ : state) benchmark::DoNotOptimize(render(scene, options));
    state.SetItemsProcessed(state.iterations() * side * side * options.samples_per_pixel);
}

void BM_RenderMicroflake(benchmark::State& state) {
    render_ball(state, ball_under_sky_and_rectangle(), microflake());
}
void BM_RenderMeasured(benchmark::State& state) {
    render_ball(state, ball_under_sky_and_rectangle(), measured());
}
void BM_RenderSingleFlakes(benchmark::State& state) {
    render_ball(state, ball_under_sky_and_rectangle(), single_flakes());
}
void BM_RenderDemoBall(benchmark::State& state) {
    render_ball(state, builtin_scene("sphere"), microflake());
}

void sizes(benchmark::internal::Benchmark* b) {
    b->ArgName("pixels")->Arg(512)->Arg(64)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK(BM_RenderMicroflake)->Apply(sizes);
BENCHMARK(BM_RenderMeasured)->Apply(sizes);
BENCHMARK(BM_RenderSingleFlakes)->Apply(sizes);
BENCHMARK(BM_RenderDemoBall)->Apply(sizes);

}  // namespace
}  // namespace nacre::render
