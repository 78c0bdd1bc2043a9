#include <gtest/gtest.h>

#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/layers/rough_interface.h"
#include "nacre/reference/air_interface.h"
#include "nacre/reference/test_support.h"

namespace nacre::reference {
namespace {

using test::brdf;
using test::kGreen;
using test::kWorstZ;
using test::z_score;

constexpr double kDegree = std::numbers::pi / 180;

layers::Recipe rough(layers::Recipe recipe, double roughness) {
    recipe.clearcoat = layers::Clearcoat{20, 0.0, roughness};
    return recipe;
}

/// Nothing but the interface: what comes in is lost.
layers::Recipe bare(double index, double roughness) {
    return rough(test::paint(index, {test::flake_layer(1e-6, .1, 0, 1)}), roughness);
}

Estimate reflectance(const layers::Recipe& recipe, double theta_deg, std::uint64_t samples) {
    return reference_albedo(recipe, std::vector<Direction>{{theta_deg, 0}}, kGreen,
                            {.samples = samples})
        .at(0)
        .reflectance;
}

TEST(RoughInterface, AlbedoMatchesTheIntegralOverFacets) {
    for (double alpha : {0.05, 0.3, 1.0}) {
        const layers::RoughInterface integrated(1.5, alpha);
        for (double theta : {0.0, 40.0, 75.0, 88.0}) {
            const Estimate found = reflectance(bare(1.5, alpha), theta, 20'000);
            EXPECT_LT(std::abs(z_score(found, integrated.albedo(theta * kDegree))), kWorstZ)
                << "alpha " << alpha << ", theta " << theta << ": " << found.mean << " for "
                << integrated.albedo(theta * kDegree);
        }
    }
}

TEST(RoughInterface, BrdfMatchesFacetsAndMaskedLight) {
    // Grazing directions: elsewhere masked light is too rare for a z-score.
    const std::vector<Direction> outgoing{{75, 180}, {80, 60}, {85, 180}, {85, 0}};
    for (double alpha : {0.5, 1.0}) {
        const auto found = brdf(bare(1.5, alpha), {70, 0}, outgoing, {.samples = 5'000});
        for (std::size_t j = 0; j < outgoing.size(); ++j) {
            const double expected = layers::rough_interface_brdf(1.5, alpha, 70 * kDegree,
                                                                 outgoing[j].theta_deg * kDegree,
                                                                 outgoing[j].phi_deg * kDegree);
            // The solver's facets are exact, its m is interpolated in theta to some 1e-4.
            EXPECT_LT(std::abs(z_score(found[j], expected, 1e-4 * expected)), kWorstZ)
                << "alpha " << alpha << ", theta_o " << outgoing[j].theta_deg << ": "
                << found[j].mean << " +- " << found[j].standard_error << " for " << expected;
        }
    }
}

TEST(RoughInterface, NarrowFacetsRefractAsTheSmoothInterface) {
    // Facets of slope 0.02 tilt refracted rays by less than a tenth of the flakes' spread.
    const auto paint = test::paint(1.5, {test::flake_layer(1, .3, .6, .2)}, 0.3);
    const std::vector<Direction> outgoing{{0, 0}, {20, 180}, {60, 90}};
    const auto narrow = brdf(rough(paint, 0.02), {45, 0}, outgoing, {.samples = 6'000, .seed = 1});
    const auto smooth = brdf(rough(paint, 0), {45, 0}, outgoing, {.samples = 6'000, .seed = 2});
    for (std::size_t j = 0; j < outgoing.size(); ++j)
        EXPECT_LT(std::abs(z_score(narrow[j], smooth[j])), kWorstZ)
            << narrow[j].mean << ' ' << smooth[j].mean;
}

TEST(RoughInterface, LosslessPaintReflectsEverything) {
    for (double alpha : {0.1, 0.7}) {
        const auto recipe = rough(test::paint(1.5, {test::flake_layer(1, .3, .4, .6)}, 1.0), alpha);
        for (double theta : {20.0, 80.0}) {
            const Estimate found = reflectance(recipe, theta, 5'000);
            EXPECT_NEAR(found.mean, 1, 1e-9) << "no roulette, no loss: each walk returns 1";
        }
    }
}

TEST(RoughInterface, HelmholtzReciprocityHolds) {
    const auto recipe = rough(
        test::paint(1.5, {test::flake_layer(1, .2, .6, .2), test::pigment_layer(.8, 1, .4)}, 0.7),
        0.3);
    const Direction a{10, 0}, b{65, 150};
    for (Part part : {Part::single, Part::multiple, Part::total}) {
        const auto there = brdf(recipe, a, {b}, {.samples = 4'000, .seed = 5, .part = part});
        const auto back = brdf(recipe, b, {a}, {.samples = 4'000, .seed = 6, .part = part});
        EXPECT_LT(std::abs(z_score(there[0], back[0])), kWorstZ)
            << there[0].mean << ' ' << back[0].mean;
        EXPECT_LT(there[0].standard_error, 0.15 * there[0].mean);
    }
}

TEST(RoughInterface, BrdfIntegratesToTheAlbedo) {
    const auto recipe = rough(test::paint(1.5, {test::flake_layer(1, .5, .6, .2)}, 0.3), 0.5);
    const Quadrature mu = gauss_legendre(10, 0, 1);
    constexpr int kPhiSteps = 12;
    std::vector<Direction> outgoing;
    for (double m : mu.nodes)
        for (int k = 0; k < kPhiSteps; ++k)
            outgoing.push_back({test::degrees_of_cosine(m), 360.0 * (k + 0.5) / kPhiSteps});
    const auto found = brdf(recipe, {50, 0}, outgoing, {.samples = 150});
    Estimate integral;
    for (std::size_t i = 0; i < outgoing.size(); ++i) {
        const std::size_t j = i / kPhiSteps;
        const double weight = mu.weights[j] * mu.nodes[j] * 2 * std::numbers::pi / kPhiSteps;
        integral.mean += weight * found[i].mean;
        integral.standard_error += weight * found[i].standard_error;  // a bound: as if in step
    }
    const Estimate albedo = reflectance(recipe, 50, 50'000);
    EXPECT_LT(std::abs(z_score(albedo, integral)), kWorstZ) << albedo.mean << ' ' << integral.mean;
    EXPECT_LT(integral.standard_error, 0.2 * integral.mean);
}

TEST(RoughInterface, RoughnessTooSmallToWalkIsRefused) {
    EXPECT_THROW(reflectance(bare(1.5, 1e-5), 0, 10), DomainError);
}

}  // namespace
}  // namespace nacre::reference
