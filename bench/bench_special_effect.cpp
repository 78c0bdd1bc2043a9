// How long it takes to count facets, and to evaluate and sample the special-effect model, by the
// number of facets on the object and in the footprint.
//
//   ./dev bench --benchmark_filter='Facet|SpecialEffect'

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "nacre/bsdf/models/special_effect.h"
#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/sparkle/facet_field.h"

namespace nacre::bsdf {
namespace {

constexpr double kAlpha = 0.07, kCone_deg = 3;

Vec3f direction(double theta_deg, double phi_deg) {
    return to_float(polar_direction(theta_deg, phi_deg));
}

// Squares at random places and angles on the object, that hold `facets` facets on average.
std::vector<Patch> patches(double facets_on_object, double facets) {
    std::vector<Patch> out;
    Rng rng(1, 2);
    const double side = std::sqrt(std::min(0.2, facets / facets_on_object));
    for (int i = 0; i < 4096; ++i) {
        const double turn = 2 * std::numbers::pi * rng.uniform_double();
        const float c = static_cast<float>(side * std::cos(turn));
        const float s = static_cast<float>(side * std::sin(turn));
        const double u = side + (1 - 2 * side) * rng.uniform_double();
        out.push_back({u, side + (1 - 2 * side) * rng.uniform_double(), {c, s}, {-s, c}});
    }
    return out;
}

const sparkle::FacetField& field(double facets) {
    static std::map<double, sparkle::FacetField> fields;
    return fields.try_emplace(facets, facets, kAlpha, kCone_deg, 1).first->second;
}

struct View {
    const char* name;
    Vec3f wi, wo;
};
const View kViews[] = {{"peak", direction(30, 0), direction(30, 180)},
                       {"8 deg off peak", direction(30, 0), direction(38, 180)},
                       {"25 deg off peak", direction(30, 0), direction(55, 180)}};

// Arguments: log10 of the facets on the object; 100 times the facets in the footprint; view.
void BM_FacetCount(benchmark::State& state) {
    const double on_object = std::pow(10.0, state.range(0)), in_patch = 0.01 * state.range(1);
    const sparkle::FacetField& facets = field(on_object);
    const auto all = patches(on_object, in_patch);
    const View& view = kViews[state.range(2)];
    state.SetLabel(view.name);
    std::size_t i = 0;
    double counted = 0, queries = 0;
    for (auto _ : state) {
        const Patch& p = all[i];
        const auto tally = facets.count({p.u, p.v, p.edge_1, p.edge_2}, view.wi, view.wo);
        counted += static_cast<double>(tally.count);
        ++queries;
        i = (i + 1) % all.size();
    }
    state.counters["counted"] = counted / queries;
}
BENCHMARK(BM_FacetCount)
    ->ArgNames({"log10_K", "centi_facets", "view"})
    ->ArgsProduct({{5, 7, 9, 12}, {5, 100, 500, 10000, 100000, 1000000, 100000000}, {0}})
    ->ArgsProduct({{9}, {5, 500, 100000, 100000000}, {1, 2}});

void BM_FacetFieldConstruction(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            sparkle::FacetField(std::pow(10.0, state.range(0)), kAlpha, kCone_deg, 1));
    }
}
BENCHMARK(BM_FacetFieldConstruction)
    ->ArgName("log10_K")
    ->Arg(5)
    ->Arg(12)
    ->Unit(benchmark::kMillisecond);

// The model at eight wavelengths, from directions and to directions as it samples them.
struct Setup {
    std::unique_ptr<const BoundBsdf> bsdf;
    std::vector<Patch> on;
    struct Query {
        Vec3f wi, wo;
        float u_select;
        Vec2f u;
    };
    std::vector<Query> queries;

    Setup(double on_object, double in_patch) : on(patches(on_object, in_patch)) {
        paint::Recipe recipe;
        recipe.microfacet =
            paint::Microfacet{.alpha = kAlpha,
                              .film_ior = 1.8,
                              .film_thickness_nm = 158.333,
                              .base_ior = 1.08,
                              .base_extinction = 0.51,
                              .facets = paint::MicrofacetFacets{on_object, kCone_deg, 10}};
        bsdf = SpecialEffect(recipe, 1).bind({418, 456, 493, 531, 568, 606, 643, 681});
        Rng rng(3, 3);
        while (queries.size() < on.size()) {
            const float z = std::sqrt(rng.uniform_float()), s = std::sqrt(1 - z * z);
            const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
            Query q{{s * std::cos(phi), s * std::sin(phi), z},
                    {},
                    rng.uniform_float(),
                    {rng.uniform_float(), rng.uniform_float()}};
            const auto sample = bsdf->sample(q.wi, q.u_select, q.u);
            if (!sample) continue;
            q.wo = sample->wo;
            queries.push_back(q);
        }
    }
    static const Setup& get(double on_object, double in_patch) {
        static std::map<std::pair<double, double>, Setup> setups;
        const std::pair key{on_object, in_patch};
        if (const auto found = setups.find(key); found != setups.end()) return found->second;
        return setups.try_emplace(key, on_object, in_patch).first->second;
    }
};

template <class F>
void run(benchmark::State& state, F&& f) {
    const Setup& setup = Setup::get(1e9, 0.01 * state.range(0));
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(f(*setup.bsdf, setup.on[i], setup.queries[i]));
        i = (i + 1) % setup.queries.size();
    }
}

// As in bench_nacre.
void footprints(benchmark::internal::Benchmark* b) {
    b->ArgName("centi_facets")->Arg(5)->Arg(30)->Arg(500)->Arg(10000)->Arg(100000);
    b->Arg(1000000)->Arg(100000000);
}

void BM_SpecialEffectEvaluateOn8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Patch& p, const Setup::Query& q) {
        return b.evaluate_on(p, q.wi, q.wo);
    });
}
BENCHMARK(BM_SpecialEffectEvaluateOn8Wavelengths)->Apply(footprints);

void BM_SpecialEffectSampleOn8Wavelengths(benchmark::State& state) {
    run(state, [](const BoundBsdf& b, const Patch& p, const Setup::Query& q) {
        return b.sample_on(p, q.wi, q.u_select, q.u);
    });
}
BENCHMARK(BM_SpecialEffectSampleOn8Wavelengths)->Apply(footprints);

void BM_SpecialEffectMean8Wavelengths(benchmark::State& state) {
    run(state,
        [](const BoundBsdf& b, const Patch&, const Setup::Query& q) { return b.eval(q.wi, q.wo); });
}
BENCHMARK(BM_SpecialEffectMean8Wavelengths)->ArgName("centi_facets")->Arg(100);

void BM_SpecialEffectPdf(benchmark::State& state) {
    run(state,
        [](const BoundBsdf& b, const Patch&, const Setup::Query& q) { return b.pdf(q.wi, q.wo); });
}
BENCHMARK(BM_SpecialEffectPdf)->ArgName("centi_facets")->Arg(100);

}  // namespace
}  // namespace nacre::bsdf
