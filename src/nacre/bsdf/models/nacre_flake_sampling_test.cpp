#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/statistics.h"

// Flakes that are sampled one by one, and what is left beside them.

namespace nacre::bsdf {
namespace {

using test::kWorstZ;
using test::Sample;

constexpr float kUnweighed = std::numeric_limits<float>::infinity();

Patch apart(Rng& rng, double side_mm) {
    Patch patch = random_square_patch(rng, side_mm);
    patch.flakes = Patch::Flakes::sampled;
    return patch;
}

double side_of_flakes(double flakes) {
    return std::sqrt(flakes / model_with_every_feature().flakes_per_mm2());
}

// Over all patches the flakes and what is left beside them add up to the mean, whether each flake
// is resolved (4 a patch) or some stand for many (1000).
TEST(NacreFlakeSampling, FlakesAndTheRestAddUpToTheMean) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        const Vec3f wi = direction(30, 20), wo = direction(24, 205);
        const FloatLanes mean = model.bound->eval(wi, wo);
        for (const double flakes : {4.0, 1000.0}) {
            Rng rng(31, 1);
            Sample ratio;
            for (int n = 0; n < 120000; ++n) {
                const Patch patch = apart(rng, side_of_flakes(flakes));
                const FloatLanes f = model.bound->evaluate_on(patch, wi, wo).f +
                                     model.bound->flakes_at(patch, wi, wo, kUnweighed);
                ratio.add(f[3] / mean[3]);
            }
            EXPECT_NEAR(ratio.mean(), 1, kWorstZ * ratio.error()) << flakes;
            EXPECT_GT(ratio.error(), 1e-4);
            EXPECT_LT(ratio.error(), 0.03);
        }
    }
}

// Under light from everywhere: each flake sampled by its own lobe, against directions drawn without
// knowing of flakes. The two share the value of a flake and nothing of the sampling.
TEST(NacreFlakeSampling, LobesReflectWhatTheirFlakesDo) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        const Vec3f wi = direction(30, 20);
        Rng rng(7, 1);
        Sample by_flake, drawn;
        int most = 0;
        for (int n = 0; n < 40000; ++n) {
            const Patch patch = apart(rng, side_of_flakes(4));
            const std::vector<FlakeSample> flakes =
                flake_samples(*model.bound, patch, wi, static_cast<std::uint32_t>(n) * 977u);
            const int count = static_cast<int>(flakes.size());
            most = std::max(most, count);
            double sum = 0;
            for (int k = 0; k < count; ++k) {
                EXPECT_GT(flakes[k].strength, 0);
                sum += model.bound->flake_weight(patch, wi, flakes[k])[3];
            }
            by_flake.add(sum);
            for (int draw = 0; draw < 2; ++draw) {
                const auto s = model.bound->sample(wi, rng.uniform_float(),
                                                   {rng.uniform_float(), rng.uniform_float()});
                drawn.add(s && s->kind == SampleKind::density
                              ? model.bound->flakes_at(patch, wi, s->wo, kUnweighed)[3] * s->wo.z /
                                    s->pdf
                              : 0.0);
            }
        }
        EXPECT_GT(most, 4);
        EXPECT_LT(by_flake.error(), 0.01 * by_flake.mean());
        EXPECT_LT(drawn.error(), 0.1 * drawn.mean());
        EXPECT_NEAR(by_flake.mean(), drawn.mean(),
                    kWorstZ * std::hypot(by_flake.error(), drawn.error()));
    }
}

// A flake is chosen by a guess of what it reflects: what the guess misses is noise of pictures. Without
// where the light comes from, and the films' colours, it missed 11 to 18 %. So is what the guess of its
// colour misses, per wavelength.
TEST(NacreFlakeSampling, TheGuessIsWhatTheFlakesReflect) {
    paint::FlakeSpecies wavy = metal_flake(18, 0.9);
    wavy.waviness = 0.06;
    struct Case {
        paint::FlakeSpecies flake;
        double roughness, guess, miss, colour_miss;
    };
    // Found with six seeds: guesses off by up to 1.1, 0.9 and 2.8 %; they miss up to 4, 8 and, as the sum
    // hangs on few flakes, 17 to 32 %. Flakes without films have one colour, and the colours of films
    // change fast with the angle on the flake at 60 deg: 39 %.
    // Of paints that ship 0.01 to 0.06 is missed under smooth coats, 0.06 to 0.16 under a rough one.
    for (const Case& c : {Case{wavy, 0, 0.02, 0.05, 1e-6}, Case{pearl_flake(18), 0, 0.02, 0.1, 0.4},
                          Case{wavy, 0.12, 0.04, 0.4, 1e-6}}) {
        paint::Recipe recipe = paint_of({c.flake});
        recipe.clearcoat = paint::Clearcoat{0, spectra::Spectrum(0.0), c.roughness};
        const SparklingModel model(recipe, {.specimen = 1});
        const double side_mm = std::sqrt(10 / model.flakes_per_mm2());
        for (const double deg : {1.0, 30.0, 60.0}) {
            const Vec3f wi = direction(deg, 20);
            Rng rng(8, 1);
            double guessed = 0, reflected = 0, squares = 0;
            FloatLanes missed{}, in_all{};  // squares of what colours miss, and of what there is
            for (int n = 0; n < 500; ++n) {
                const Patch patch = apart(rng, side_mm);
                for (const FlakeSample& flake :
                     flake_samples(*model.bound, patch, wi, static_cast<std::uint32_t>(n) * 977u)) {
                    const FloatLanes weight = model.bound->flake_weight(patch, wi, flake);
                    const double light = lane_sum(response_of_eye(kOnGrid) * weight);
                    const FloatLanes miss = weight - static_cast<float>(light) * flake.colour;
                    missed += miss * miss / flake.strength;
                    in_all += weight * weight / flake.strength;
                    EXPECT_NEAR(lane_sum(response_of_eye(kOnGrid) * flake.colour), 1, 1e-5);
                    guessed += flake.strength;
                    reflected += light;
                    squares += light * light / flake.strength;
                }
            }
            EXPECT_NEAR(guessed, reflected, c.guess * reflected)
                << deg << " deg, roughness " << c.roughness;
            const double miss = std::sqrt(squares * guessed / (reflected * reflected) - 1);
            EXPECT_LT(miss, c.miss) << deg << " deg, roughness " << c.roughness;
            EXPECT_GT(miss, 1e-3);
            for (int w = 0; w < kLanes; ++w) {
                EXPECT_LT(std::sqrt(missed[w] / in_all[w]), c.colour_miss)
                    << deg << " deg, lane " << w;
            }
        }
    }
}

// The two ways to find light, weighed against each other, find it once.
TEST(NacreFlakeSampling, WeighedWaysAddUp) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        const Vec3f wi = direction(30, 20);
        constexpr float kPdf = 0.5f * std::numbers::inv_pi_v<float>;  // of a direction upwards
        Rng rng(9, 1);
        Sample alone, both;
        for (int n = 0; n < 20000; ++n) {
            const Patch patch = apart(rng, side_of_flakes(4));
            const std::vector<FlakeSample> flakes =
                flake_samples(*model.bound, patch, wi, static_cast<std::uint32_t>(n) * 977u);
            const int count = static_cast<int>(flakes.size());
            double unweighed = 0, weighed = 0;
            for (int k = 0; k < count; ++k) {
                const double w = model.bound->flake_weight(patch, wi, flakes[k])[3];
                unweighed += w;
                weighed += w * power_heuristic(flakes[k].pdf, kPdf);
            }
            const float z = rng.uniform_float();
            const Vec3f wo = direction(std::acos(z) / kDegree, 360 * rng.uniform_double());
            weighed += model.bound->flakes_at(patch, wi, wo, kPdf)[3] * wo.z / kPdf;
            alone.add(unweighed);
            both.add(weighed);
        }
        EXPECT_NEAR(alone.mean(), both.mean(), kWorstZ * std::hypot(alone.error(), both.error()));
        EXPECT_LT(both.error(), 0.02 * both.mean());
    }
}

// How many of some numbers would give as even a sum, were all alike, of how many there are.
double evenness(const std::vector<double>& parts) {
    double sum = 0, squares = 0;
    for (const double part : parts) {
        sum += part;
        squares += part * part;
    }
    return sum * sum / (squares * static_cast<double>(parts.size()));
}

// Flakes that a patch shows by their edges weigh little, and have fewer directions or none at all:
// directions matter nearly alike, and flakes do not.
TEST(NacreFlakeSampling, DirectionsGoWithTheWeightsOfFlakes) {
    paint::FlakeSpecies wavy = metal_flake(18, 0.9);
    wavy.waviness = 0.06;
    const SparklingModel model(paint_of({wavy}), {.specimen = 1});
    Rng rng(12, 1);
    Sample of_directions, of_flakes;
    for (int n = 0; n < 500; ++n) {
        const Patch patch = apart(rng, std::sqrt(10 / model.flakes_per_mm2()));
        std::vector<double> directions;
        std::map<int, double> by_flake;
        for (const FlakeSample& sample : flake_samples(*model.bound, patch, direction(30, 20),
                                                       static_cast<std::uint32_t>(n) * 977u)) {
            directions.push_back(sample.strength);
            by_flake[sample.flake] += sample.strength;
        }
        ASSERT_FALSE(directions.empty());
        std::vector<double> flakes;
        for (const auto& [flake, strength] : by_flake) flakes.push_back(strength);
        of_directions.add(evenness(directions));
        of_flakes.add(evenness(flakes));
    }
    EXPECT_NEAR(of_directions.mean(), 0.78, 0.03);
    EXPECT_LT(of_flakes.mean(), 0.65);
}

// However many species there are, none of their flakes is forgotten: some ten of each are sampled.
TEST(NacreFlakeSampling, FlakesOfManySpeciesAreAllSampled) {
    std::vector<paint::FlakeSpecies> species;
    constexpr int kSpecies = 64;
    for (int s = 0; s < kSpecies; ++s) {
        species.push_back(metal_flake(10, 0.5));
        species.back().amount = paint::AreaDensity{0.004};
    }
    const SparklingModel model(paint_of(std::move(species)));
    Rng rng(2, 1);
    const std::vector<FlakeSample> flakes =
        flake_samples(*model.bound, apart(rng, 0.1), direction(30, 20), 1);
    EXPECT_GT(flakes.size(), 512u);
    std::vector<int> by_species(kSpecies);
    for (const FlakeSample& flake : flakes) ++by_species[flake.species];
    EXPECT_THAT(by_species, testing::Each(testing::Gt(0)));
}

// A renderer may trace the specular reflection besides: none but the lower numbers choose it.
TEST(NacreFlakeSampling, TheSpecularReflectionIsThatOfTheLowerNumbers) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const BoundBsdf& surface = *model_with_every_feature(rough).bound;
        Rng rng(35, 1);
        int specular = 0, others = 0;
        for (int n = 0; n < 2000; ++n) {
            const Patch patch = apart(rng, side_of_flakes(4));
            const Vec3f wi = direction(85 * rng.uniform_double(), 360 * rng.uniform_double());
            const float u_select = rng.uniform_float();
            const Vec2f u = {rng.uniform_float(), rng.uniform_float()};
            const bool lower = u_select < surface.specular_probability(wi);
            for (const auto& s :
                 {surface.sample(wi, u_select, u), surface.sample_on(patch, wi, u_select, u)}) {
                if (!s) continue;
                ASSERT_EQ(s->kind == SampleKind::specular, lower);
                ++(lower ? specular : others);
            }
        }
        EXPECT_TRUE(rough ? specular == 0 : specular > 100);
        EXPECT_GT(others, 1000);
    }
}

TEST(NacreFlakeSampling, WhatIsLeftDoesNotDependOnWhoSamplesFlakes) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        const Vec3f wi = direction(30, 20), wo = direction(24, 205);
        Rng rng(3, 1);
        for (const double flakes : {0.5, 20.0, 1e4}) {
            Patch patch = apart(rng, side_of_flakes(flakes));
            const BsdfValue sampled = model.bound->evaluate_on(patch, wi, wo);
            patch.flakes = Patch::Flakes::left_out;
            const BsdfValue left_out = model.bound->evaluate_on(patch, wi, wo);
            EXPECT_NEAR(sampled.f[3], left_out.f[3], 1e-6f * sampled.f[3]) << flakes;
            EXPECT_EQ(sampled.pdf, left_out.pdf);
            EXPECT_LT(sampled.f[3], model.bound->eval(wi, wo)[3]);
        }
    }
}

}  // namespace
}  // namespace nacre::bsdf
