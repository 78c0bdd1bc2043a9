#include <gtest/gtest.h>

#include <cmath>

#include "nacre/layers/solver.h"
#include "nacre/layers/test_support.h"

// The chosen nodes and orders against a solution with many more of both.

namespace nacre::layers {
namespace {

using test::kDegree;
using test::kOneWavelength;

// Largest difference to a converged solution over the plane of incidence and outside it, over the
// peak of the BRDF for that incidence.
double worst_error(const Recipe& recipe) {
    const SolvedPaint paint = solve(recipe, kOneWavelength);
    SolverSettings fine;
    fine.exit_nodes = (paint.report.exit_nodes + paint.report.exit_nodes / 2 + 7) / 4 * 4;
    fine.inner_nodes = fine.exit_nodes;
    fine.most_orders = SolverSettings::kMostOrders;
    fine.tolerance = 1e-6;
    const SolvedPaint converged = solve(recipe, kOneWavelength, fine);
    double worst = 0;
    for (const double theta_i : {0.0, 30.0, 60.0, 80.0, 89.0}) {
        double peak = 0, error = 0;
        for (const double phi : {0.0, 90.0, 170.0, 180.0}) {
            for (const double theta_o : {0.0, 15.0, 31.0, 47.0, 60.0, 73.0, 83.0, 89.0}) {
                const double i = theta_i * kDegree, o = theta_o * kDegree, p = phi * kDegree;
                const double expected = converged.brdf(i, o, p)[0];
                peak = std::max(peak, expected);
                error = std::max(error, std::abs(paint.brdf(i, o, p)[0] - expected));
            }
        }
        worst = std::max(worst, error / peak);
    }
    return worst;
}

struct Case {
    double alpha, reflectance, transmittance, depth, ior;
};

// Quick ones; docs/solver.md has the whole grid down to roughness 0.02.
class SolverAccuracy : public testing::TestWithParam<Case> {};

TEST_P(SolverAccuracy, StaysBelowAThousandthOfThePeak) {
    const Case& c = GetParam();
    const double error =
        worst_error(test::flake_paint(c.alpha, c.reflectance, c.transmittance, c.depth, c.ior));
    EXPECT_LT(error, 1e-3);
    EXPECT_GT(error, 0);  // two resolutions, not one compared with itself
    RecordProperty("error", std::to_string(error));
}

INSTANTIATE_TEST_SUITE_P(Grid, SolverAccuracy,
                         testing::Values(Case{0.05, 1, 0, 1, 1.5}, Case{0.1, 0.6, 0, 1e-3, 1.5},
                                         Case{0.1, 1, 0, 1, 1.5}, Case{0.1, 1, 0, 1e4, 1.5},
                                         Case{0.1, 0.3, 0.7, 1e4, 1.5}, Case{0.3, 1, 0, 1e-3, 1.5},
                                         Case{0.3, 1, 0, 1e4, 1.5}, Case{0.5, 1, 0, 1, 1.5},
                                         Case{0.5, 0.6, 0, 1e4, 1.5}, Case{0.2, 1, 0, 1, 1.0},
                                         Case{0.5, 1, 0, 1e4, 1.0}),
                         [](const auto& info) {
                             const Case& c = info.param;
                             return fmt::format("Alpha{:.0f}R{:.0f}T{:.0f}Depth1e{:.0f}Ior{:.0f}",
                                                100 * c.alpha, 100 * c.reflectance,
                                                100 * c.transmittance, std::log10(c.depth) + 3,
                                                10 * c.ior);
                         });

TEST(SolverAccuracy, AzimuthHasNoMeaningAtTheNormal) {
    // Bare flakes need hundreds of orders between grazing directions. None may show at the normal.
    const SolvedPaint paint = solve(test::flake_paint(0.1, 0.3, 0.7, 1, 1.0), kOneWavelength);
    ASSERT_GT(paint.report.orders, 500);
    const double peak = paint.brdf(0, 0, 0)[0];
    for (const double theta : {30.0, 60.0, 80.0, 89.0}) {
        const double back = paint.brdf(0, theta * kDegree, 0)[0];
        for (const double phi : {90.0, 175.0, 180.0}) {
            // The promised accuracy. Orders that ring between nodes would add up to ten times that.
            EXPECT_NEAR(paint.brdf(0, theta * kDegree, phi * kDegree)[0], back, 1e-3 * peak);
        }
    }
}

TEST(SolverAccuracy, PigmentsAndMixtures) {
    Recipe mixture = test::flake_paint(0.15, 0.7, 0.1, 1, 1.5);
    mixture.layers[0].pigments.push_back({30.0, 3.0, 0.5});
    mixture.layers.push_back(test::pigment_paint(0.999, 20, 0.3, 1.5).layers[0]);
    mixture.substrate_reflectance = 0.5;
    EXPECT_LT(worst_error(mixture), 1e-3);
    EXPECT_LT(worst_error(test::pigment_paint(1, 1e4, 0.8, 1.5)), 1e-3);
}

}  // namespace
}  // namespace nacre::layers
