#include "nacre/montecarlo/interface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/quadrature.h"
#include "nacre/solver/rough_interface.h"
#include "nacre/testing/montecarlo.h"

namespace nacre::montecarlo {
namespace {

Vec3d at_cosine(double mu) { return {std::sqrt(1 - mu * mu), 0, mu}; }

TEST(SmoothInterface, RaysObeySnell) {
    const auto interface = make_smooth_interface(1.5);
    RandomStream random(1, 2, 3);
    const Vec3d outside(0.6, 0.48, 0.64);
    const auto entry = interface->enter(outside, random);
    EXPECT_NEAR(length(entry.travel), 1, 1e-15);
    EXPECT_LT(entry.travel.z, 0);
    EXPECT_NEAR(entry.travel.x, -outside.x / 1.5, 1e-15);
    EXPECT_NEAR(entry.travel.y, -outside.y / 1.5, 1e-15);
    EXPECT_EQ(interface->connect(outside, random).travel, -entry.travel);
}

TEST(SmoothInterface, ReflectsFourPercentOfNormalIncidence) {
    const auto interface = make_smooth_interface(1.5);
    RandomStream random(1, 2, 3);
    EXPECT_NEAR(interface->enter({0, 0, 1}, random).weight, 0.96, 1e-15);
    EXPECT_NEAR(interface->reflect_inside({0, 0, 1}, random).weight, 0.04, 1e-15);
}

TEST(SmoothInterface, ReflectsAllBeyondTheCriticalAngle) {
    const auto interface = make_smooth_interface(1.5);
    RandomStream random(1, 2, 3);
    const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
    EXPECT_EQ(interface->reflect_inside(at_cosine(critical - 1e-6), random).weight, 1);
    EXPECT_LT(interface->reflect_inside(at_cosine(critical + 1e-6), random).weight, 1);
    const auto grazing = interface->reflect_inside(at_cosine(0.1), random);
    EXPECT_DOUBLE_EQ(grazing.travel.z, -0.1);
    EXPECT_EQ(grazing.weight, 1);
}

TEST(SmoothInterface, ConnectionsConserveFlux) {
    // Isotropic radiance 1 inside: the flux that the inner side lets through is the flux that
    // connections find outside.
    const double index = 1.7;
    const auto interface = make_smooth_interface(index);
    RandomStream random(1, 2, 3);
    double connected = 0, let_through = 0;
    const Quadrature outside = gauss_legendre(256, 0, 1);
    for (std::size_t i = 0; i < outside.nodes.size(); ++i) {
        const double mu = outside.nodes[i];
        connected += outside.weights[i] * mu * interface->connect(at_cosine(mu), random).weight;
    }
    const Quadrature inside = gauss_legendre(1024, std::sqrt(1 - 1 / (index * index)), 1);
    for (std::size_t i = 0; i < inside.nodes.size(); ++i) {
        const double mu = inside.nodes[i];
        let_through +=
            inside.weights[i] * mu * (1 - interface->reflect_inside(at_cosine(mu), random).weight);
    }
    EXPECT_NEAR(connected, let_through, 1e-6);  // the square root at the critical angle
}

TEST(SmoothInterface, EqualIndicesAreNoInterface) {
    const auto interface = make_smooth_interface(1);
    RandomStream random(1, 2, 3);
    for (double mu : {1e-6, 0.3, 1.0}) {
        EXPECT_EQ(interface->enter(at_cosine(mu), random).weight, 1);
        EXPECT_EQ(interface->reflect_inside(at_cosine(mu), random).weight, 0);
        EXPECT_EQ(interface->connect(at_cosine(mu), random).weight, 1);
    }
}

TEST(SmoothInterface, SampledEventsHaveTheMeansOfTheWeightedOnes) {
    const auto interface = make_smooth_interface(1.5);
    RandomStream random(1, 2, 3);
    constexpr int kMeetings = 40'000;
    for (const double mu : {0.2, 0.8, 0.95}) {
        const Vec3d outside = at_cosine(mu), travel = at_cosine(mu);
        const auto entry = interface->enter(outside, random);
        const auto reflection = interface->reflect_inside(travel, random);
        int entered = 0, reflected = 0;
        for (int i = 0; i < kMeetings; ++i) {
            const auto in = interface->sample_from_outside(outside, random);
            const Vec3d specular(-outside.x, -outside.y, outside.z);
            EXPECT_LT(length(in.travel - (in.inside ? entry.travel : specular)), 1e-14);
            entered += in.inside;
            const auto out = interface->sample_from_inside(travel, random);
            if (out.inside) {
                EXPECT_LT(length(out.travel - reflection.travel), 1e-14);
            } else {
                EXPECT_NEAR(out.travel.x, 1.5 * travel.x, 1e-14) << "Snell";
                EXPECT_NEAR(length(out.travel), 1, 1e-14);
                EXPECT_GT(out.travel.z, 0);
            }
            reflected += out.inside;
        }
        const auto expect_fraction = [&](int count, double fraction) {
            const double deviation = std::sqrt(fraction * (1 - fraction) * kMeetings);
            EXPECT_NEAR(count, fraction * kMeetings, 4 * deviation) << mu;
        };
        expect_fraction(entered, entry.weight);
        expect_fraction(reflected, reflection.weight);
    }
}

}  // namespace

namespace {

using test::brdf;
using test::kGreen;
using test::kWorstZ;

paint::Recipe rough(paint::Recipe recipe, double roughness) {
    recipe.clearcoat = paint::Clearcoat{20, 0.0, roughness};
    return recipe;
}

/// Nothing but the interface: what comes in is lost.
paint::Recipe bare(double index, double roughness) {
    return rough(test::paint_of(index, {test::flake_layer(1e-6, .1, 0, 1)}), roughness);
}

Estimate reflectance(const paint::Recipe& recipe, double theta_deg, std::uint64_t samples) {
    return reference_albedo(recipe, std::vector<Direction>{{theta_deg, 0}}, kGreen,
                            {.samples = samples})
        .at(0)
        .reflectance;
}

TEST(RoughInterface, AlbedoMatchesTheIntegralOverFacets) {
    for (double alpha : {0.05, 0.3, 1.0}) {
        const solver::RoughInterface integrated(1.5, alpha);
        for (double theta : {0.0, 40.0, 75.0, 88.0}) {
            const Estimate found = reflectance(bare(1.5, alpha), theta, 20'000);
            EXPECT_LT(std::abs(z_score(found, integrated.albedo(theta * kDegree))), kWorstZ)
                << "alpha " << alpha << ", theta " << theta << ": " << found.value << " for "
                << integrated.albedo(theta * kDegree);
        }
    }
}

TEST(RoughInterface, BrdfMatchesFacetsAndMaskedLight) {
    // Grazing directions: elsewhere masked light is too rare for a z-score.
    const std::vector<Direction> outgoing{{75, 180}, {80, 60}, {85, 180}, {85, 0}};
    for (double alpha : {0.5, 1.0}) {
        const auto found = brdf(bare(1.5, alpha), {70, 0}, outgoing, {.samples = 100'000});
        for (std::size_t j = 0; j < outgoing.size(); ++j) {
            const double expected = solver::rough_interface_brdf(1.5, alpha, 70 * kDegree,
                                                                 outgoing[j].theta_deg * kDegree,
                                                                 outgoing[j].phi_deg * kDegree);
            // The solver's facets are exact, its m is interpolated in theta to some 1e-4.
            EXPECT_LT(std::abs(z_score(found[j], expected, 1e-4 * expected)), kWorstZ)
                << "alpha " << alpha << ", theta_o " << outgoing[j].theta_deg << ": "
                << found[j].value << " +- " << found[j].standard_error << " for " << expected;
        }
    }
}

TEST(RoughInterface, NarrowFacetsRefractAsTheSmoothInterface) {
    // Facets of slope 0.02 tilt refracted rays by less than a tenth of the flakes' spread.
    const auto paint = test::paint_of(1.5, {test::flake_layer(1, .3, .6, .2)}, 0.3);
    const std::vector<Direction> outgoing{{0, 0}, {20, 180}, {60, 90}};
    const auto narrow = brdf(rough(paint, 0.02), {45, 0}, outgoing, {.samples = 6'000, .seed = 1});
    const auto smooth = brdf(rough(paint, 0), {45, 0}, outgoing, {.samples = 6'000, .seed = 2});
    for (std::size_t j = 0; j < outgoing.size(); ++j)
        EXPECT_LT(std::abs(z_score(narrow[j], smooth[j])), kWorstZ)
            << narrow[j].value << ' ' << smooth[j].value;
}

TEST(RoughInterface, LosslessPaintReflectsEverything) {
    for (double alpha : {0.1, 0.7}) {
        const auto recipe =
            rough(test::paint_of(1.5, {test::flake_layer(1, .3, .4, .6)}, 1.0), alpha);
        for (double theta : {20.0, 80.0}) {
            const Estimate found = reflectance(recipe, theta, 5'000);
            EXPECT_NEAR(found.value, 1, 1e-9) << "no roulette, no loss: each walk returns 1";
        }
    }
}

TEST(RoughInterface, HelmholtzReciprocityHolds) {
    const auto recipe =
        rough(test::paint_of(
                  1.5, {test::flake_layer(1, .2, .6, .2), test::pigment_layer(.8, 1, .4)}, 0.7),
              0.3);
    const Direction a{10, 0}, b{65, 150};
    for (Part part : {Part::single, Part::multiple, Part::total}) {
        const auto there = brdf(recipe, a, {b}, {.samples = 4'000, .seed = 5, .part = part});
        const auto back = brdf(recipe, b, {a}, {.samples = 4'000, .seed = 6, .part = part});
        EXPECT_LT(std::abs(z_score(there[0], back[0])), kWorstZ)
            << there[0].value << ' ' << back[0].value;
        EXPECT_LT(there[0].standard_error, 0.15 * there[0].value);
    }
}

TEST(RoughInterface, BrdfIntegratesToTheAlbedo) {
    const auto recipe = rough(test::paint_of(1.5, {test::flake_layer(1, .5, .6, .2)}, 0.3), 0.5);
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
        integral.value += weight * found[i].value;
        integral.standard_error += weight * found[i].standard_error;  // a bound
    }
    const Estimate albedo = reflectance(recipe, 50, 50'000);
    EXPECT_LT(std::abs(z_score(albedo, integral)), kWorstZ)
        << albedo.value << ' ' << integral.value;
    EXPECT_LT(integral.standard_error, 0.2 * integral.value);
}

TEST(RoughInterface, RoughnessBelowItsRangeIsRefused) {
    EXPECT_THROW(reflectance(bare(1.5, 1e-5), 0, 10), DomainError);
}

}  // namespace
}  // namespace nacre::montecarlo
