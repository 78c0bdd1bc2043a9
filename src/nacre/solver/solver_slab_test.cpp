#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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
            sum += 4 * std::numbers::pi * d.weight[i] * d.mu[i] * d.weight[j] * d.mu[j] * f[i][j];
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

struct SlabCase {
    double albedo, depth, anisotropy, mu0, reflectance, transmittance;
};

TEST(SolverSlab, PigmentsMatchTheTables) {
    // [van-de-hulst-1980; prahl-1993], five to six digits.
    constexpr SlabCase kTable[] = {
        {.9, 2, .75, 1, .097395, .660958},  {.99, 1, 0, .5, .486518, .491628},
        {.99, 4, .5, .5, .619959, .306051}, {1, 1, 0, 1, .341329, .658671},
        {.9, 1, 0, 1, .267410, .591625},
    };
    for (const SlabCase& s : kTable) {
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
    constexpr SlabCase kRows[] = {
        {.95, 8, .8, 1, .2201871, .2816297},
        {.5, .2, -.3, 1, .0557785, .8414378},
        {.99, 64, .5, 1, .6646070, .0002388},
        {1, 16, .9, 1, .4405689, .5594311},
    };
    for (const SlabCase& s : kRows) {
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

// The substrate alone under a smooth interface, by the light that goes back and forth between them:
// T(i) T(o)/n^2 s/pi / (1 - s r), r the interface's reflectance of diffuse light from inside.
//                                                                              [saunderson-1942]
double bare_substrate(double substrate, double ior, double theta_i, double theta_o) {
    double inside = 0;  // Int 2 mu F d mu, 1 beyond the critical angle
    const double critical = std::sqrt(1 - 1 / (ior * ior));
    const Quadrature rule = gauss_legendre(64, 0, std::numbers::pi / 2);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        // In the angle outside, t: mu^2 = 1 - sin^2 t/n^2, 2 mu d mu = sin 2t dt/n^2.
        inside += rule.weights[i] * std::sin(2 * rule.nodes[i]) / (ior * ior) *
                  optics::dielectric_reflectance(1.0, ior, std::cos(rule.nodes[i]));
    }
    inside += critical * critical;
    const auto enter = [&](double theta) {
        return 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta));
    };
    return enter(theta_i) * enter(theta_o) / (ior * ior) * substrate / std::numbers::pi /
           (1 - substrate * inside);
}

// What a layer without extinction is, in each way that a recipe can state it.
std::vector<paint::Recipe> empty_layers(double ior) {
    paint::Recipe binder_alone = flake_paint(0.1, 0, 1, 2, ior);
    binder_alone.layers[0].flakes.clear();
    paint::Recipe among_others = binder_alone;
    among_others.layers.insert(among_others.layers.end(), 2, among_others.layers[0]);
    paint::Recipe clear_pigment = pigment_paint(0, 1, 0, ior);
    std::get<paint::PigmentCoefficients>(clear_pigment.layers[0].pigments[0].body)
        .absorption_per_mm = 0.0;
    return {binder_alone, among_others, flake_paint(0.1, 0, 1, 2, ior), clear_pigment};
}

TEST(SolverSlab, WithoutExtinctionTheSubstrateShows) {
    for (const double ior : {1.0, 1.5}) {
        for (const double substrate : {0.0, 0.5, 1.0}) {
            for (const paint::Recipe& recipe : empty_layers(ior)) {
                const SolvedPaint paint = over_substrate(recipe, substrate);
                for (const double theta_o : {0.0, 0.5, 1.2}) {
                    const double expected = bare_substrate(substrate, ior, 0.8, theta_o);
                    // Coefficients are kept to the tolerance; order 0 to a 64th of it.
                    EXPECT_NEAR(paint.brdf(0.8, theta_o, 2.0)[0], expected, 2e-6 * expected + 1e-12)
                        << "n = " << ior << ", substrate " << substrate;
                }
            }
        }
    }
}

TEST(SolverSlab, ThinLayersApproachTheSubstrate) {
    // Whatever a layer does is of first order in its optical depth.
    for (const double ior : {1.0, 1.5}) {
        for (double depth = 1e-30; depth < 1e-5; depth *= 10) {
            const paint::Recipe pigment = pigment_paint(0.5, depth, 0.3, ior);
            const paint::Recipe flakes = flake_paint(0.1, 0.5, 0.2, depth, ior);
            for (const paint::Recipe& recipe : {pigment, flakes}) {
                const double expected = bare_substrate(0.5, ior, 0.8, 0.5);
                // A narrow lobe of density 1/(pi alpha^2) near the specular direction.
                EXPECT_NEAR(over_substrate(recipe, 0.5).brdf(0.8, 0.5, 2.0)[0], expected,
                            2e-6 * expected + 20 * depth)
                    << "n = " << ior << ", depth " << depth;
            }
        }
    }
}

TEST(SolverSlab, ALayerMayBeEmptyAtSomeWavelengths) {
    paint::Recipe recipe = pigment_paint(0.9, 1, 0, 1.5);
    const paint::Recipe grey = recipe;
    const auto& present = std::get<paint::PigmentCoefficients>(grey.layers[0].pigments[0].body);
    auto& pigment = std::get<paint::PigmentCoefficients>(recipe.layers[0].pigments[0].body);
    pigment.scattering_per_mm = spectra::Spectrum({500, 600}, {0, present.scattering_per_mm(550)});
    pigment.absorption_per_mm = spectra::Spectrum({500, 600}, {0, present.absorption_per_mm(550)});
    recipe.substrate_reflectance = 0.5;
    const std::vector<double> f = solve(recipe, {400, 500, 600, 700}).brdf(0.8, 0.5, 2.0);
    const double bare = bare_substrate(0.5, 1.5, 0.8, 0.5);
    const double covered = over_substrate(grey, 0.5).brdf(0.8, 0.5, 2.0)[0];
    // The spectral basis and the coefficients are kept to 1e-4 of the peak, order 0 to less.
    EXPECT_NEAR(f[0], bare, 1e-5 * bare);
    EXPECT_NEAR(f[1], bare, 1e-5 * bare);
    EXPECT_NEAR(f[2], covered, 1e-5 * covered);
    EXPECT_NEAR(f[3], covered, 1e-5 * covered);
}

TEST(SolverSlab, ARoughCoatOverNothingShowsTheSubstrate) {
    // Without extinction and at a roughness that hardly turns light, the substrate's light as under a
    // smooth interface, away from the interface's own lobe.
    paint::Recipe recipe = empty_layers(1.5)[0];
    recipe.clearcoat = paint::Clearcoat{45, 0.0, 0.02};
    recipe.substrate_reflectance = 0.5;
    const SolvedPaint paint = solve(recipe, kOneWavelength);
    const double expected = bare_substrate(0.5, 1.5, 0.8, 0.2);
    // Fresnel's factors change by the square of the slopes.
    EXPECT_NEAR(paint.brdf(0.8, 0.2, 1.0)[0], expected, 2e-3 * expected);
}

}  // namespace
}  // namespace nacre::solver
