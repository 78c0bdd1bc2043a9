#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/math.h"
#include "nacre/core/quadrature.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/h_function.h"
#include "nacre/testing/paints.h"

// Particles far smaller than the wavelength scatter by Rayleigh's phase function 3/4 (1 + cos^2), for
// which a half space has a closed form: from Mie's series to Fourier orders, all against it.

namespace nacre::solver {
namespace {

/// BRDF of a half space that absorbs nothing, in the Fourier orders 0 to 2 of the azimuth from the
/// incident direction.                             [chandrasekhar-1960, sections 16, 44 and 45]
class RayleighHalfSpace {
 public:
    RayleighHalfSpace() {
        // The constant c is that with which all light comes back, at one angle; the test of the oracle
        // is that it does so at all.
        const double without = albedo(0.5), slope = albedo(0.5, 1) - without;
        c_ = (1 - without) / slope;
    }
    double order0(double x, double y, double c) const {
        return norm(x, y) * h0_(x) * h0_(y) * (3 - c * (x + y) + x * y);
    }
    double order0(double x, double y) const { return order0(x, y, c_); }
    /// The azimuth is that of the two directions away from the surface, 180 deg in the mirror direction.
    double order1(double x, double y) const {
        return norm(x, y) * 4 * x * y * std::sqrt((1 - x * x) * (1 - y * y)) * h1_(x) * h1_(y);
    }
    double order2(double x, double y) const {
        return norm(x, y) * (1 - x * x) * (1 - y * y) * h2_(x) * h2_(y);
    }
    double albedo(double mu) const { return albedo(mu, c_); }

 private:
    static double norm(double x, double y) { return 3.0 / 8 / (4 * std::numbers::pi * (x + y)); }
    double albedo(double mu, double c) const {
        const Quadrature rule = gauss_legendre(48, 0, 1);
        double sum = 0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double x = rule.nodes[i];
            sum += 2 * std::numbers::pi * rule.weights[i] * x * order0(x, mu, c);
        }
        return sum;
    }

    nacre::test::HFunction h0_{[](double x) { return 3.0 / 16 * (3 - x * x); }};
    nacre::test::HFunction h1_{[](double x) { return 3.0 / 8 * x * x * (1 - x * x); }};
    nacre::test::HFunction h2_{[](double x) { return 3.0 / 32 * (1 - x * x) * (1 - x * x); }};
    double c_ = 0;
};

TEST(RayleighLayer, TheClosedFormReturnsAllLight) {
    const RayleighHalfSpace half_space;
    for (const double mu : {0.05, 0.2, 0.8, 1.0}) EXPECT_NEAR(half_space.albedo(mu), 1, 1e-5) << mu;
}

// Light that lies evenly in all directions at the depth of a half space without loss is what a white
// ground returns: 12 mean free paths over one are that half space.
TEST(RayleighLayer, OfMieParticlesIsTheClosedForm) {
    // Of 10 nm the mean cosine, 6e-4, already shows: the first order is 3 % smaller at 75 and 80 deg.
    constexpr double kDiameter_nm = 4, kVolume = 0.5, kThickness_um = 1e6, kError = 1e-4;
    paint::Pigment pigment{paint::PigmentParticles{paint::PigmentVolume{kVolume},
                                                   {.material = optics::Material(1.5),
                                                    .diameter_nm = kDiameter_nm,
                                                    .crowding = optics::Crowding::independent}}};
    const SolvedPaint paint =
        solve(nacre::test::paint_of(1, {{kThickness_um, {}, {pigment}}}, 1.0), {550});
    const RayleighHalfSpace half_space;
    constexpr double kPi = std::numbers::pi;
    for (const double theta_i : {0.0, 20.0, 50.0, 75.0}) {
        for (const double theta_o : {10.0, 40.0, 80.0}) {
            SCOPED_TRACE(testing::Message() << theta_i << ", " << theta_o);
            const auto value = [&](double phi) {
                return paint.brdf(theta_i * kDegree, theta_o * kDegree, phi)[0];
            };
            const double x = std::cos(theta_i * kDegree), y = std::cos(theta_o * kDegree);
            const double towards = value(0), across = value(kPi / 2), away = value(kPi);
            EXPECT_NEAR((towards + away + 2 * across) / 4, half_space.order0(x, y), kError);
            EXPECT_NEAR((towards - away) / 2, half_space.order1(x, y), kError);
            EXPECT_NEAR((towards + away - 2 * across) / 4, half_space.order2(x, y), kError);
        }
    }
}

}  // namespace
}  // namespace nacre::solver
