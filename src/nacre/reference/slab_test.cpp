#include <gtest/gtest.h>

#include "nacre/core/quadrature.h"
#include "nacre/reference/test_support.h"

// Plane albedos against published slabs and closed forms.

namespace nacre::reference {
namespace {

using test::kWorstZ;
using test::z_score;

Albedo albedo_of(const layers::Recipe& recipe, double mu, std::uint64_t samples,
                 std::uint64_t seed = 1) {
    const std::vector<Direction> incident{{test::degrees_of_cosine(mu), 0}};
    return reference_albedo(recipe, incident, std::vector<double>{550},
                            {.samples = samples, .seed = seed})
        .at(0);
}

// Printed with five or six digits: half of the last one is below a hundredth of a standard error.

TEST(PigmentSlab, MatchesTablesOfReflectanceAndTransmittance) {
    struct Case {
        double albedo, depth, anisotropy, mu, reflectance, transmittance;
    };
    // Without an interface; van de Hulst 1980 and an independent adding-doubling program.
    constexpr Case kCases[] = {
        {.9, 2, .75, 1, .097395, .660958},  {.99, 1, 0, .5, .486518, .491628},
        {.99, 4, .5, .5, .619959, .306051}, {1, 1, 0, 1, .341329, .658671},
        {.9, 1, 0, 1, .267410, .591625},
    };
    for (const Case& c : kCases) {
        const auto recipe = test::paint(1, {test::pigment_layer(c.albedo, c.depth, c.anisotropy)});
        const Albedo albedo = albedo_of(recipe, c.mu, 140'000);
        EXPECT_LT(std::abs(z_score(albedo.reflectance, c.reflectance)), kWorstZ)
            << c.albedo << ' ' << c.depth << ' ' << albedo.reflectance.mean;
        EXPECT_LT(std::abs(z_score(albedo.absorbed_by_substrate, c.transmittance)), kWorstZ)
            << c.albedo << ' ' << c.depth << ' ' << albedo.absorbed_by_substrate.mean;
    }
}

TEST(PigmentSlab, SemiInfiniteUnderAnInterfaceMatchesTheTable) {
    const auto recipe = test::paint(1.5, {test::pigment_layer(.9, 100, 0)});
    const Albedo albedo = albedo_of(recipe, 1, 140'000);
    EXPECT_LT(std::abs(z_score(albedo.reflectance, .25992)), kWorstZ) << albedo.reflectance.mean;
}

TEST(FlakeSlab, MatchesAddingDoublingOfTheDesignNotes) {
    struct Case {
        double index, alpha, beta, reflectance, transmittance, mu, total_reflected, transmitted;
    };
    // Index 1: published in the design notes from adding-doubling and Monte Carlo; transmitted < 0:
    // not known. Index 1.5: the total includes the interface's mirror.
    constexpr Case kCases[] = {
        {1, .1, 2, 1, 0, .8, .66557, .33443},
        {1, .1, 2, .6, 0, .8, .32101, .18172},
        {1.5, .2, 2, 1, 0, .9, .58769, -1},
        {1.5, .3, 4, .6, 0, .95, .27608, -1},
    };
    for (const Case& c : kCases) {
        const auto recipe = test::paint(
            c.index, {test::flake_layer(c.beta, c.alpha, c.reflectance, c.transmittance)});
        const Albedo albedo = albedo_of(recipe, c.mu, 140'000);
        EXPECT_LT(std::abs(z_score(albedo.reflectance, c.total_reflected)), kWorstZ)
            << c.index << ' ' << c.alpha << ' ' << albedo.reflectance.mean;
        if (c.transmitted >= 0) {
            EXPECT_LT(std::abs(z_score(albedo.absorbed_by_substrate, c.transmitted)), kWorstZ)
                << c.index << ' ' << c.alpha << ' ' << albedo.absorbed_by_substrate.mean;
        }
    }
}

TEST(FlakeSlab, NearlyFlatFlakesObeyKubelkaAndMunk) {
    // S = R, K = 1 - R - T, depth beta, light and flakes along one line.  [kubelka-1948]
    constexpr double kAlpha = 0.005;  // leaves the line by some alpha^2: far below the noise
    struct Case {
        double beta, reflectance, transmittance;
    };
    for (const Case& c : {Case{2, .7, .3}, Case{.5, .2, .8}, Case{3, .6, .1}}) {
        const double k_over_s = (1 - c.reflectance - c.transmittance) / c.reflectance;
        const double a = 1 + k_over_s, b = std::sqrt(a * a - 1);
        const double depth = c.beta * c.reflectance;
        const double expected = b < 1e-6 ? depth / (1 + depth) : 1 / (a + b / std::tanh(b * depth));
        const auto recipe =
            test::paint(1, {test::flake_layer(c.beta, kAlpha, c.reflectance, c.transmittance)});
        const Albedo albedo = albedo_of(recipe, 1, 140'000);
        EXPECT_LT(std::abs(z_score(albedo.reflectance, expected)), kWorstZ)
            << albedo.reflectance.mean << ' ' << expected;
    }
}

TEST(FlakeSlab, LosslessFlakesLoseNoLight) {
    for (double index : {1.0, 1.5}) {
        const auto recipe = test::paint(index, {test::flake_layer(1.5, .3, .7, .3)});
        const Albedo albedo = albedo_of(recipe, .6, 35'000);
        const double sum = albedo.reflectance.mean + albedo.absorbed_by_substrate.mean;
        // Roulette alone makes the sum fluctuate, so the two errors bound its own.
        const double error =
            albedo.reflectance.standard_error + albedo.absorbed_by_substrate.standard_error;
        EXPECT_NEAR(sum, 1, kWorstZ * error) << "index " << index;
    }
}

TEST(FlakeSlab, ThickLosslessFlakesReflectEverything) {
    const auto recipe = test::paint(1, {test::flake_layer(300, .5, 1, 0)});
    const Albedo albedo = albedo_of(recipe, .8, 5'000);
    EXPECT_GT(albedo.reflectance.mean, 0.985);  // the rest, some 1/300, comes through
    EXPECT_NEAR(albedo.reflectance.mean + albedo.absorbed_by_substrate.mean, 1, 1e-9);
}

TEST(FlakeSlab, LosslessPaintOverWhiteReflectsEverything) {
    const auto recipe = test::paint(1.5, {test::flake_layer(1, .2, .4, .6)}, 1.0);
    const Albedo albedo = albedo_of(recipe, .7, 20'000);
    EXPECT_LT(std::abs(z_score(albedo.reflectance, 1)), kWorstZ) << albedo.reflectance.mean;
    EXPECT_EQ(albedo.absorbed_by_substrate.mean, 0);
}

TEST(Clearcoat, AbsorbsByBeerAndLambert) {
    // Black below: what reaches the substrate went once through the coat at the refracted angle.
    layers::Recipe recipe = test::paint(1, {test::flake_layer(1e-6, .1, 0, 1)});
    recipe.clearcoat = layers::Clearcoat{45, 20.0, 0};
    const Albedo albedo = albedo_of(recipe, .5, 1000);
    EXPECT_NEAR(albedo.absorbed_by_substrate.mean, std::exp(-0.045 * 20 / .5), 1e-12);
    EXPECT_EQ(albedo.reflectance.mean, 0);
}

TEST(PigmentSlab, DeepAbsorptionOverWhiteGroundFollowsBeerAndLambert) {
    // Nothing scatters but the ground: exp(-depth) down, and the mean of exp(-depth / mu) over
    // Lambert's law up. Most walks end by lot on their way, and those must bring nothing.
    constexpr double kDepth = 1.5;
    const auto recipe = test::paint(1, {test::pigment_layer(0, kDepth, 0)}, 1);
    const Albedo albedo = albedo_of(recipe, 1, 140'000);
    const Quadrature mu = gauss_legendre(64, 0, 1);
    double up = 0;
    for (std::size_t i = 0; i < mu.nodes.size(); ++i)
        up += 2 * mu.weights[i] * mu.nodes[i] * std::exp(-kDepth / mu.nodes[i]);
    const double expected = std::exp(-kDepth) * up;
    EXPECT_LT(std::abs(z_score(albedo.reflectance, expected)), kWorstZ)
        << albedo.reflectance.mean << " against " << expected;
    EXPECT_LT(albedo.reflectance.standard_error, 0.01 * expected);
}

}  // namespace
}  // namespace nacre::reference
