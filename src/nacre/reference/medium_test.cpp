#include "nacre/reference/medium.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "nacre/core/quadrature.h"
#include "nacre/reference/test_support.h"

namespace nacre::reference {
namespace {

constexpr std::array<double, 1> kWavelength{550};

Flakes flakes_of(double alpha, double reflectance, double transmittance) {
    const auto species = test::flakes(1, alpha, reflectance, transmittance);
    return {1, alpha, FlakeOptics(species, optics::Material(1.5), kWavelength)};
}

Direction3 direction(double mu, double phi) {
    const double s = std::sqrt(1 - mu * mu);
    return {s * std::cos(phi), s * std::sin(phi), mu};
}

/// Over the whole sphere: Gauss-Legendre in the angle to `axis`, equal steps around it. About the
/// travel direction the kernels are smooth in these, the grazing reflections forwards included.
double integrate_sphere(const Direction3& axis, const std::function<double(const Direction3&)>& f) {
    constexpr int kSteps = 512, kNodes = 256;
    const Direction3 across = axis.unitOrthogonal(), third = axis.cross(across);
    const Quadrature rule = gauss_legendre(kNodes, 0, std::numbers::pi);
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double sine = std::sin(rule.nodes[i]), cosine = std::cos(rule.nodes[i]);
        for (int k = 0; k < kSteps; ++k) {
            const double phi = 2 * std::numbers::pi * k / kSteps;
            sum += rule.weights[i] * sine *
                   f(cosine * axis + sine * (std::cos(phi) * across + std::sin(phi) * third));
        }
    }
    return sum * 2 * std::numbers::pi / kSteps;
}

struct ProjectedArea {
    double alpha, mu, value;
};
// Mean projected area of Beckmann flakes: SciPy 1.17.1, nested integrate.quad over the two slopes
// with a break at the kink, epsrel 1e-12; at mu = 1 that is sqrt(pi)/alpha erfcx(1/alpha).
constexpr ProjectedArea kProjectedAreas[] = {
    {.1, 1, .995073188}, {.1, .5, .497536594}, {.1, .2, .199090779}, {.1, .05, .069458091},
    {.3, 1, .960019857}, {.3, .5, .480303234}, {.3, .2, .225844008}, {.3, .05, .163769345},
};

TEST(Flakes, ExtinctionOfOpaqueFlakesIsTheirMeanProjectedArea) {
    for (const auto& [alpha, mu, value] : kProjectedAreas)
        EXPECT_NEAR(flakes_of(alpha, 0, 0).extinction(mu)[0] / value, 1, kExtinctionRelativeError)
            << "alpha " << alpha << ", mu " << mu;
}

TEST(Flakes, ExtinctionOfFlatFlakesIsTheCosine) {
    constexpr double kAlpha = 0.005;  // the smallest a recipe may ask for
    // E|w.m| = mu E(1 + s^2)^(-1/2) = mu (1 - alpha^2/2 + O(alpha^4)) far from grazing
    for (double mu : {0.2, 0.5, 1.0})
        EXPECT_NEAR(flakes_of(kAlpha, 0, 0).extinction(mu)[0], mu * (1 - kAlpha * kAlpha / 2),
                    1e-8);
}

TEST(Flakes, ExtinctionIsOneMinusTransmittanceOfTheOpaqueOne) {
    const double opaque = flakes_of(.3, 0, 0).extinction(.4)[0];
    EXPECT_NEAR(flakes_of(.3, .2, .7).extinction(.4)[0], 0.3 * opaque, 1e-14);
}

TEST(Slab, TabulatedExtinctionKeepsToTheQuadrature) {
    for (double alpha : {0.02, 0.1, 0.5}) {
        Slab slab;
        slab.flakes.push_back(flakes_of(alpha, .5, .2));
        Slab tabulated = slab;
        tabulated.tabulate_extinction();
        const double along_normal = slab.extinction(1)[0];
        for (int i = 0; i < kExtinctionTableIntervals; i += i < 100 ? 1 : 20) {
            const double mu = (i + 0.5) / kExtinctionTableIntervals;
            EXPECT_NEAR(tabulated.extinction(mu)[0], slab.extinction(mu)[0],
                        kExtinctionTableError * along_normal)
                << "alpha " << alpha << ", mu " << mu;
        }
    }
}

TEST(Flakes, ScatteringIntegratesToTheExtinctionOfPerfectMirrors) {
    for (double alpha : {0.1, 0.3, 0.5}) {
        const Flakes species = flakes_of(alpha, 1, 0);
        for (double mu : {0.05, 0.2, 0.5, 0.97}) {
            const Direction3 in = direction(-mu, 0.3);
            const double integral = integrate_sphere(
                in, [&](const Direction3& out) { return species.scattering(in, out)[0]; });
            const double extinction = species.extinction(mu)[0];
            EXPECT_NEAR(integral / extinction, 1, 10 * kExtinctionRelativeError)
                << "alpha " << alpha << ", mu " << mu;
        }
    }
}

TEST(Flakes, ScatteringIsReciprocal) {
    const Flakes species = flakes_of(.2, .8, .1);
    const Direction3 in = direction(-.9, 0), out = direction(.7, .3);
    const double forward = species.scattering(in, out)[0];
    EXPECT_GT(forward, 0.01);
    EXPECT_NEAR(species.scattering(-out, -in)[0], forward, 1e-15);
}

TEST(Flakes, ForwardDirectionIsNotScattered) {
    const Flakes species = flakes_of(.2, .8, .1);
    const Direction3 level(0.6, 0.8, 0);
    EXPECT_EQ(species.scattering(level, level)[0], 0);
    EXPECT_EQ(species.scattering(level, -level)[0], 0) << "its normal would lie in the plane";
}

TEST(Flakes, TableOfAPlateletKeepsToTheTransferMatrix) {
    layers::FlakeSpecies species;
    species.amount = layers::AreaDensity{1};
    optics::Platelet body;
    body.core = {optics::Material(1.58), 500, {}};
    body.coats = {{optics::Material(2.5), 150, {}}};
    species.body = body;
    const optics::Material binder(1.5);
    const std::array<double, 3> wavelengths{400, 550, 700};
    const FlakeOptics flake(species, binder, wavelengths);
    std::vector<double> cosines;  // between the nodes, where a linear table is worst
    for (int i = 0; i < kPlateletTableIntervals; i += 3)
        cosines.push_back((i + 0.5) / kPlateletTableIntervals);
    const auto exact = optics::platelet_table(body, binder, cosines, wavelengths);
    double worst = 0;
    for (std::size_t i = 0; i < cosines.size(); ++i) {
        for (std::size_t j = 0; j < wavelengths.size(); ++j) {
            worst = std::max(worst, std::abs(flake.reflectance(cosines[i])[j] -
                                             exact.reflectance[i * wavelengths.size() + j]));
            worst = std::max(worst, std::abs(flake.transmittance(cosines[i])[j] -
                                             exact.transmittance[i * wavelengths.size() + j]));
        }
    }
    EXPECT_LT(worst, kPlateletTableError);
    EXPECT_GT(worst, 0);
}

TEST(Pigment, ScatteringIntegratesToItsRateWithItsMeanCosine) {
    for (double g : {-0.5, 0.0, 0.7}) {
        Pigment pigment{Lanes{}, g};
        pigment.scattering_per_um[0] = 0.2;
        const Direction3 in = direction(0.4, 1);
        const auto scattering = [&](const Direction3& out) {
            return pigment.scattering(in, out)[0];
        };
        EXPECT_NEAR(integrate_sphere(in, scattering), 0.2, 1e-12);
        EXPECT_NEAR(integrate_sphere(
                        in, [&](const Direction3& out) { return in.dot(out) * scattering(out); }),
                    0.2 * g, 1e-12);
    }
}

}  // namespace
}  // namespace nacre::reference
