// How long one evaluation, sample or density of the micro-flake model takes, for eight wavelengths
// on one core.
//
//   ./dev bench --benchmark_filter=Microflake

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/bsdf/microflake.h"
#include "nacre/core/rng.h"
#include "nacre/layers/solver.h"

namespace nacre::bsdf {
namespace {

struct Query {
    Vec3f wi, wo;
    float u_lobe;
    Vec2f u;
};

// The directions that a renderer asks for: incident ones over the hemisphere, outgoing ones as the
// model samples them.
struct Setup {
    std::unique_ptr<const BoundBsdf> bsdf;
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
        const Microflake model(std::make_shared<const layers::SolvedPaint>(
            layers::solve(recipe, layers::default_wavelengths_nm())));
        bsdf = model.bind({418, 456, 493, 531, 568, 606, 643, 681});
        Rng rng(1, 1);
        while (queries.size() < 4096) {
            Query q;
            const float z = std::sqrt(rng.uniform_float()), s = std::sqrt(1 - z * z);
            const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
            q.wi = {s * std::cos(phi), s * std::sin(phi), z};
            q.u_lobe = rng.uniform_float();
            q.u = {rng.uniform_float(), rng.uniform_float()};
            const auto sample = bsdf->sample(q.wi, q.u_lobe, q.u);
            if (!sample || sample->mirror) continue;
            q.wo = sample->wo;
            queries.push_back(q);
        }
    }
    static const Setup& get() {
        static const Setup setup;
        return setup;
    }
};

template <class F>
void run(benchmark::State& state, F&& f) {
    const Setup& setup = Setup::get();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(f(*setup.bsdf, setup.queries[i]));
        i = (i + 1) % setup.queries.size();
    }
}

void BM_MicroflakeEval8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.eval(q.wi, q.wo); });
}
BENCHMARK(BM_MicroflakeEval8Wavelengths);

void BM_MicroflakeSample8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.sample(q.wi, q.u_lobe, q.u); });
}
BENCHMARK(BM_MicroflakeSample8Wavelengths);

void BM_MicroflakePdf(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Query& q) { return b.pdf(q.wi, q.wo); });
}
BENCHMARK(BM_MicroflakePdf);

}  // namespace
}  // namespace nacre::bsdf
