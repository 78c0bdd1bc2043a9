#include "nacre/layers/solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/quadrature.h"

namespace nacre::layers {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
const std::vector<double> kOneWavelength = {550.0};

// Flakes that reflect and pass the given shares at all angles; c = 0.1 per um, so that a thickness
// of 10 beta um has the dimensionless depth beta.
Recipe flake_paint(double alpha, double reflectance, double transmittance, double depth,
                   double ior) {
    Recipe recipe;
    recipe.binder = optics::Material(ior);
    FlakeSpecies flake;
    flake.amount = AreaDensity{0.1};
    flake.orientation.beckmann_alpha = alpha;
    flake.body = PrescribedFlake{reflectance, transmittance, 0.3};
    recipe.layers.push_back({10 * depth, {flake}, {}});
    return recipe;
}

Recipe pigment_paint(double albedo, double depth, double anisotropy, double ior) {
    Recipe recipe;
    recipe.binder = optics::Material(ior);
    Layer layer;
    layer.thickness_um = 1000 * std::min(depth, 1.0);
    const double per_mm = std::max(depth, 1.0);
    layer.pigments.push_back({per_mm * albedo, per_mm * (1 - albedo), anisotropy});
    recipe.layers.push_back(layer);
    return recipe;
}

// DESIGN section 2.4: two independent methods that agree within their error.
struct Worked {
    double theta_o_deg, phi_deg, total, single;
};
constexpr Worked kWorked[] = {
    {15, 180, 0.0986750, 0.0850942}, {30, 180, 0.660157, 0.630615},
    {45, 180, 1.21809, 1.17416},     {60, 180, 0.879130, 0.828999},
    {75, 180, 0.403080, 0.361052},   {0, 180, 0.00615526, 0.00215988},
    {30, 90, 0.00147852, 5.74e-5},   {45, 0, 2.5171e-5, 6.68e-13},
};

TEST(Solver, MatchesTheWorkedMetallic) {
    const SolvedPaint paint = solve(flake_paint(0.1, 0.6, 0.0, 1.5, 1.5), kOneWavelength);
    for (const Worked& w : kWorked) {
        SCOPED_TRACE(testing::Message() << w.theta_o_deg << ", " << w.phi_deg);
        const double theta_i = 45 * kDegree, theta_o = w.theta_o_deg * kDegree;
        const double single =
            paint.brdf(theta_i, theta_o, w.phi_deg * kDegree, Part::single)[0];
        const double total = paint.brdf(theta_i, theta_o, w.phi_deg * kDegree)[0];
        // The single part is a closed form given to three to six digits.
        EXPECT_NEAR(single, w.single, 1e-3 * w.single);
        // 1e-4 of the peak is what the issue asks; the tail is held closer.
        EXPECT_NEAR(total, w.total, 2e-6 + 5e-5 * w.total);
    }
}

TEST(Solver, MatchesChandrasekharsHalfSpace) {
    // Isotropic, albedo 0.9, no interface; H functions, DESIGN section 2.4.
    const SolvedPaint paint = solve(pigment_paint(0.9, 1e4, 0, 1.0), kOneWavelength);
    EXPECT_NEAR(paint.brdf(0, 0, 0)[0], 0.122572, 2e-6);
    EXPECT_NEAR(paint.brdf(0, 60 * kDegree, 1.0)[0], 0.137453, 2e-6);
}

}  // namespace
}  // namespace nacre::layers
