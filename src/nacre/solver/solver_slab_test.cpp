#include <gtest/gtest.h>

#include <cmath>

#include "nacre/solver/solver.h"
#include "nacre/testing/layers.h"

// Total reflectance and transmittance of slabs against published and independently computed values.

namespace nacre::solver {
namespace {

using test::albedo;
using test::flake_paint;
using test::kOneWavelength;
using test::pigment_paint;

SolvedPaint over_substrate(paint::Recipe recipe, double reflectance) {
    recipe.substrate_reflectance = reflectance;
    return solve(recipe, kOneWavelength);
}

// Int 2 cos f_0 over both directions of the exit nodes, index-matched: the reflectance for diffuse
// light.
double diffuse(const std::vector<std::vector<double>>& f, const Directions& d) {
    double sum = 0;
    for (int i = 0; i < d.size(); ++i) {
        for (int j = 0; j < d.size(); ++j) {
            sum += 4 * kPi * d.weight[i] * d.mu[i] * d.weight[j] * d.mu[j] * f[i][j];
        }
    }
    return sum;
}

// A Lambertian substrate of reflectance g adds to an index-matched slab a smooth part, in order 0
// alone:
//     R(g) - R(0) = T t g/(1 - g r),   diffusely  r(g) - r(0) = t^2 g/(1 - g r),
// T from the light's direction, t and r for diffuse light. Two substrates give t, then T.
double transmittance(const paint::Recipe& recipe, double mu0) {
    const SolvedPaint black = over_substrate(recipe, 0), grey = over_substrate(recipe, 0.5),
                      white = over_substrate(recipe, 1);
    const Directions d =
        make_directions(1.0, static_cast<int>(black.multiple_scattering.exit_angle.size()), 0);
    const auto added = [&](const SolvedPaint& paint) {
        std::vector<std::vector<double>> f;
        for (double theta : d.exit_angle) {
            f.push_back(test::multiple_by_node(paint, theta));
            const std::vector<double> without = test::multiple_by_node(black, theta);
            for (std::size_t j = 0; j < without.size(); ++j) f.back()[j] -= without[j];
        }
        return diffuse(f, d);
    };
    const double diffuse_white = added(white), diffuse_grey = added(grey);
    // 1/(r(g) - r(0)) = (1/g - r)/t^2.
    const double t = 1 / std::sqrt(1 / diffuse_grey - 1 / diffuse_white);
    const double theta = std::acos(mu0);
    const double directed =
        test::multiple_albedo(white, theta) - test::multiple_albedo(black, theta);
    return directed * t / diffuse_white;
}

struct Slab {
    double albedo, depth, anisotropy, mu0, reflectance, transmittance;
};

TEST(SolverSlab, PigmentsMatchTheTables) {
    // [van-de-hulst-1980; prahl-1993], five to six digits.
    constexpr Slab kTable[] = {
        {.9, 2, .75, 1, .097395, .660958},  {.99, 1, 0, .5, .486518, .491628},
        {.99, 4, .5, .5, .619959, .306051}, {1, 1, 0, 1, .341329, .658671},
        {.9, 1, 0, 1, .267410, .591625},
    };
    for (const Slab& s : kTable) {
        SCOPED_TRACE(testing::Message() << "albedo " << s.albedo << ", depth " << s.depth);
        const paint::Recipe recipe = pigment_paint(s.albedo, s.depth, s.anisotropy, 1.0);
        // Five to six digits are known, and doubling starts with an error up to 1.5e-5 of the
        // depth.
        EXPECT_NEAR(albedo(solve(recipe, kOneWavelength), std::acos(s.mu0)), s.reflectance, 6e-6);
        EXPECT_NEAR(transmittance(recipe, s.mu0), s.transmittance, 1e-5);
    }
}

TEST(SolverSlab, PigmentsMatchAnotherAddingDoublingProgram) {
    // iadpython 0.5.3 (Prahl), normal incidence:
    //     iadpython.Sample(a=a, b=tau, g=g, n=1, quad_pts=16).rt()[:2]
    constexpr Slab kRows[] = {
        {.95, 8, .8, 1, .2201871, .2816297},
        {.5, .2, -.3, 1, .0557785, .8414378},
        {.99, 64, .5, 1, .6646070, .0002388},
        {1, 16, .9, 1, .4405689, .5594311},
    };
    for (const Slab& s : kRows) {
        SCOPED_TRACE(testing::Message() << "albedo " << s.albedo << ", depth " << s.depth);
        const paint::Recipe recipe = pigment_paint(s.albedo, s.depth, s.anisotropy, 1.0);
        // Its 16 nodes agree with its 32 to 3e-3 at g = 0.9 and 5e-4 at g = 0.8, 1e-5 elsewhere:
        // it does not resolve forward peaks, which it replaces by a delta function.
        const double error = std::abs(s.anisotropy) > 0.7 ? 1e-3 : 1e-5;
        EXPECT_NEAR(albedo(solve(recipe, kOneWavelength), 0), s.reflectance, error);
    }
}

TEST(SolverSlab, HalfSpaceUnderAnInterface) {
    // Albedo 0.9, isotropic, n = 1.5, normal incidence, specular reflection included:
    // docs/solver.md.
    const SolvedPaint paint = solve(pigment_paint(0.9, 1e4, 0, 1.5), kOneWavelength);
    EXPECT_NEAR(albedo(paint, 0) + 0.04, 0.25992, 1e-5);
}

TEST(SolverSlab, IndexMatchedFlakesMatchTheTables) {
    // By adding-doubling and Monte Carlo: docs/solver.md.
    const SolvedPaint opaque = solve(flake_paint(0.1, 1, 0, 2, 1.0), kOneWavelength);
    EXPECT_NEAR(albedo(opaque, std::acos(0.8)), 0.66557, 1e-5);

    const paint::Recipe grey = flake_paint(0.1, 0.6, 0, 2, 1.0);
    EXPECT_NEAR(albedo(solve(grey, kOneWavelength), std::acos(0.8)), 0.32101, 1e-5);
    EXPECT_NEAR(transmittance(grey, 0.8), 0.18172, 5e-5);
}

TEST(SolverSlab, CoatedFlakesMatchTheTables) {
    // Likewise; external cosines, the interface's specular reflection included.
    const auto total = [](const SolvedPaint& paint, double mu0) {
        return albedo(paint, std::acos(mu0)) + optics::dielectric_reflectance(1.0, 1.5, mu0);
    };
    EXPECT_NEAR(total(solve(flake_paint(0.2, 1, 0, 2, 1.5), kOneWavelength), 0.9), 0.58769, 2e-5);
    EXPECT_NEAR(total(solve(flake_paint(0.3, 0.6, 0, 4, 1.5), kOneWavelength), 0.95), 0.27608,
                2e-5);
}

TEST(SolverSlab, FlatFlakesWithoutAbsorptionFollowKubelkaAndMunk) {
    // alpha -> 0: every order of reflection stays in the mirror direction, and the light that comes
    // back is R beta/(1 + R beta).                                   [kubelka-1948, eq. 27]
    for (const double reflectance : {0.2, 0.7}) {
        const SolvedPaint paint =
            solve(flake_paint(0.05, reflectance, 1 - reflectance, 2, 1.0), kOneWavelength);
        const double flat = reflectance * 2 / (1 + reflectance * 2);
        // The first correction goes with the squared slope: projected areas differ from the cosine
        // by alpha^2/2 each way.
        EXPECT_NEAR(albedo(paint, 0), flat, 0.05 * 0.05) << reflectance;
    }
}

}  // namespace
}  // namespace nacre::solver
