#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/bsdf/models/nacre_arrays.h"
#include "nacre/paint/expansion.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/statistics.h"

// The nacre model of flakes as they are (docs/flakes.md).

namespace nacre::bsdf {
namespace {

/// Two species with all that flakes may have.
paint::Recipe recipe_of_real_flakes() {
    paint::FlakeSpecies metal = metal_flake(20, 0.7, 0.1);
    metal.quantiles = paint::DiameterQuantiles{8, 18, 36};
    metal.edge_um = 0.3;
    metal.waviness = 0.06;
    metal.orientation.law = paint::Orientation::Law::ggx;
    metal.orientation.alpha_bottom = 0.12;
    paint::FlakeSpecies pearl = pearl_flake(15);
    std::get<optics::Platelet>(pearl.body).coated_sides = optics::Platelet::CoatedSides::one;
    pearl.waviness = 0.1;
    return paint_of({metal, pearl});
}

const SparklingModel& model_of_real_flakes() {
    static const SparklingModel model(recipe_of_real_flakes());
    return model;
}

TEST(NacreFlakes, AreSpeciesOfTheirOwn) {
    const SparklingModel& model = model_of_real_flakes();
    const paint::Recipe whole = paint::expanded(model.paint->recipe);
    ASSERT_EQ(whole.layers.size(), model.paint->medium.layers.size());
    std::size_t species = 0;
    for (std::size_t l = 0; l < whole.layers.size(); ++l) {
        EXPECT_EQ(whole.layers[l].flakes.size(), model.paint->medium.layers[l].flakes.size());
        species += whole.layers[l].flakes.size();
    }
    EXPECT_EQ(model.nacre.tables().species.size(), species);
    EXPECT_GT(species, 20u);
}

TEST(NacreFlakes, MeanOverPatchesIsTheMicroflakeModel) {
    const SparklingModel& model = model_of_real_flakes();
    const auto smooth = Microflake(model.paint).bind(kOnGrid);
    PatchMemory memory(model.bound->patch_memory_bytes());
    for (const auto& [theta_o, phi] : {std::pair(27.0, 176.0), std::pair(50.0, 190.0)}) {
        constexpr int kPatches = 20000, kTurns = 8;
        double sum = 0, squares = 0;
        Rng rng(21);
        for (int n = 0; n < kPatches; ++n) {
            Patch patch = random_square_patch(rng, 0.03);
            memory.forget();
            patch.memory = &memory;
            double f = 0;
            for (int t = 0; t < kTurns; ++t) {
                const double turn = 360.0 * t / kTurns;
                f += model.bound
                         ->evaluate_on(patch, direction(35, turn), direction(theta_o, phi + turn))
                         .f[3] /
                     kTurns;
            }
            sum += f;
            squares += f * f;
        }
        const double mean = sum / kPatches;
        const double error = std::sqrt((squares / kPatches - mean * mean) / kPatches);
        EXPECT_GT(error, 0);
        EXPECT_LT(error, 0.02 * mean);
        EXPECT_NEAR(mean, smooth->eval(direction(35, 0), direction(theta_o, phi))[3],
                    test::kWorstZ * error);
    }
}

// Drawn by its own sampling and by Lambert's law the light of a patch is the same.
TEST(NacreFlakes, SamplesWhatTheyReflect) {
    paint::FlakeSpecies wavy = metal_flake(6, 0.7, 0.2);
    wavy.waviness = 0.15;
    const SparklingModel model(paint_of({wavy}));
    Rng rng(4);
    const Patch patch = random_square_patch(rng, 0.01);
    const Vec3f wi = direction(40, 30);
    constexpr int kSamples = 200000;
    double own = 0, own2 = 0, even = 0, even2 = 0;
    for (int n = 0; n < kSamples; ++n) {
        const float u_select = rng.uniform_float();
        const Vec2f u = {rng.uniform_float(), rng.uniform_float()};
        const auto s = model.bound->sample_on(patch, wi, u_select, u);
        const double weight = s && s->kind != SampleKind::specular ? s->weight[3] : 0;
        own += weight / kSamples;
        own2 += weight * weight / kSamples;
        if (s && s->kind != SampleKind::specular && n % 100 == 0) {
            const BsdfValue value = model.bound->evaluate_on(patch, wi, s->wo);
            EXPECT_NEAR(value.pdf / s->pdf, 1, 1e-3);
        }
        const float r = std::sqrt(u.x), angle = 2 * std::numbers::pi_v<float> * u.y;
        const Vec3f wo = {r * std::cos(angle), r * std::sin(angle), std::sqrt(1 - u.x)};
        if (wo.z <= 0) continue;
        const double f = std::numbers::pi * model.bound->evaluate_on(patch, wi, wo).f[3];
        even += f / kSamples;
        even2 += f * f / kSamples;
    }
    const double error = std::sqrt((own2 - own * own + even2 - even * even) / kSamples);
    EXPECT_LT(error, 0.03 * even);
    EXPECT_NEAR(own, even, test::kWorstZ * error);
}

TEST(NacreFlakes, ArraysTellPlanesFromTheirWaves) {
    paint::FlakeSpecies flake = metal_flake(20, 0.7, 0.2);
    flake.waviness = 0.1;
    const NacreArrays arrays = nacre_arrays(
        std::make_shared<const solver::SolvedPaint>(solver::solve(paint_of({flake}), {550})), {});
    ASSERT_EQ(arrays.species.size(), 1u);
    EXPECT_DOUBLE_EQ(arrays.species[0].alpha, 0.2);
    EXPECT_DOUBLE_EQ(arrays.species[0].waviness, 0.1);
    // Of the mean: both together.
    EXPECT_DOUBLE_EQ(arrays.layers[0].flakes[0].alpha, std::hypot(0.2, 0.1));
}

TEST(NacreFlakes, ArraysOfTheMeanAreThoseOfAll) {
    for (const double roughness : {0.0, 0.15}) {
        paint::FlakeSpecies pearl = pearl_flake(15);
        std::get<optics::Platelet>(pearl.body).coats[0].spread.standard_deviation_nm = 8;
        paint::Recipe recipe = paint_of({metal_flake(20, 0.7, 0.2), pearl});
        recipe.clearcoat = paint::Clearcoat{40, 1.0, roughness};
        const auto paint = std::make_shared<const solver::SolvedPaint>(
            solver::solve(recipe, std::vector<double>{450, 550, 650}));
        const NacreArrays all = nacre_arrays(paint, {}),
                          mean = nacre_arrays(paint, {}, ArrayParts::mean);
        EXPECT_FALSE(all.probability.empty() || all.albedo.empty());
        EXPECT_TRUE(mean.probability.empty() && mean.albedo.empty());
        ASSERT_EQ(all.species.size(), 2u);
        ASSERT_EQ(mean.species.size(), 2u);
        EXPECT_GT(all.species[1].film_sets, 0);
        EXPECT_EQ(mean.species[1].film_sets, 0);
        EXPECT_EQ(mean.species[0].field.key, all.species[0].field.key);
        EXPECT_EQ(mean.smooth, all.smooth);
        EXPECT_EQ(mean.smooth_basis, all.smooth_basis);
        EXPECT_EQ(mean.layers[0].extinction_per_um, all.layers[0].extinction_per_um);
        EXPECT_EQ(mean.layers[0].flakes[1].reflectance, all.layers[0].flakes[1].reflectance);
        EXPECT_EQ(mean.masked, all.masked);
        ASSERT_TRUE(mean.hot_spot && all.hot_spot);
        EXPECT_EQ(mean.hot_spot->species[0].coupling, all.hot_spot->species[0].coupling);
        EXPECT_EQ(mean.hot_spot->compensation, all.hot_spot->compensation);

        const NacreArrays without = nacre_arrays(paint, {.hot_spot = false}, ArrayParts::mean);
        EXPECT_FALSE(without.hot_spot);
        EXPECT_EQ(without.smooth, microflake_arrays(paint, ArrayParts::mean).smooth);
        EXPECT_EQ(without.smooth, microflake_arrays(paint).smooth);
    }
}

}  // namespace
}  // namespace nacre::bsdf
