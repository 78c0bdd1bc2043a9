#include "nacre/fit/drawdown.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/core/random.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/errors.h"

namespace nacre::fit {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

const std::vector<double> kWavelengths_nm = {430, 550, 620};
/// A pigment whose absorption goes from weak to strong.
const paint::PigmentCoefficients kPigment{
    spectra::Spectrum(kWavelengths_nm, {600.0, 400.0, 300.0}),
    spectra::Spectrum(kWavelengths_nm, {100.0, 1500.0, 6000.0})};

paint::Recipe drawn(double thickness_um, double volume_fraction, double ground,
                    double anisotropy = 0) {
    paint::Recipe recipe;
    recipe.binder = optics::Material(1.5);
    recipe.substrate_reflectance = ground;
    paint::Layer& layer = recipe.layers.emplace_back();
    layer.thickness_um = thickness_um > 0 ? thickness_um : 1;
    if (thickness_um == 0) return recipe;
    paint::PigmentCoefficients pigment = kPigment;
    pigment.anisotropy = anisotropy;
    pigment.amount = paint::PigmentVolume{volume_fraction};
    layer.pigments.push_back({pigment});
    return recipe;
}

struct GroundName {
    const char* name;
    double inside;
};
constexpr GroundName kGrounds[] = {{"black", 0.02}, {"white", 0.85}};

Drawdown drawdown(DrawdownGeometry geometry, double anisotropy = 0,
                  const std::vector<double>& wavelengths_nm = kWavelengths_nm) {
    Drawdown out{wavelengths_nm, {}};
    for (const GroundName& ground : kGrounds) {
        for (const auto& [thickness, volume] :
             {std::pair{0.0, 0.1}, std::pair{15.0, 0.01}, std::pair{30.0, 0.03}}) {
            out.readings.push_back(
                {ground.name, thickness, volume,
                 drawdown_reflectance(drawn(thickness, volume, ground.inside, anisotropy),
                                      wavelengths_nm, geometry)});
        }
    }
    return out;
}

class DrawdownRoundTrip : public ::testing::TestWithParam<DrawdownGeometry> {};

TEST_P(DrawdownRoundTrip, FindsTheCoefficientsThatItWasMadeFrom) {
    // One with lobes, whose BRDF depends on azimuth.
    const double g = GetParam() == DrawdownGeometry::diffuse_8_included ? 0.4 : 0;
    const PigmentEstimate estimate =
        estimate_pigment(drawdown(GetParam(), g), {.geometry = GetParam(), .anisotropy = g});
    for (std::size_t i = 0; i < kWavelengths_nm.size(); ++i) {
        const double s = kPigment.scattering_per_mm(kWavelengths_nm[i]);
        const double a = kPigment.absorption_per_mm(kWavelengths_nm[i]);
        EXPECT_NEAR(estimate.scattering_per_mm[i], s, 2e-3 * s) << i;
        EXPECT_NEAR(estimate.absorption_per_mm[i], a, 2e-3 * a) << i;
    }
    EXPECT_LT(estimate.rms_residual, 1e-4);
    EXPECT_EQ(estimate.residuals.size(), 4u);
}

INSTANTIATE_TEST_SUITE_P(EachGeometry, DrawdownRoundTrip,
                         ::testing::Values(DrawdownGeometry::diffuse_8_included,
                                           DrawdownGeometry::diffuse_8_excluded,
                                           DrawdownGeometry::angle_45_0));

// Scattering that goes forward hides like less scattering that goes everywhere.
TEST(Drawdown, AnotherAnisotropyGivesNearlyTheSameTransportCoefficient) {
    const auto geometry = DrawdownGeometry::diffuse_8_included;
    const PigmentEstimate estimate =
        estimate_pigment(drawdown(geometry, 0), {.geometry = geometry, .anisotropy = 0.5});
    EXPECT_NEAR(0.5 * estimate.scattering_per_mm[0], 600, 0.2 * 600);
}

TEST(Drawdown, StandardErrorsAreThoseOfRepeatedReadings) {
    constexpr int kRepeats = 6;
    constexpr double kNoise = 0.002;
    const auto geometry = DrawdownGeometry::diffuse_8_included;
    const Drawdown exact = drawdown(geometry, 0, {430, 550});  // those that are asked below
    double z2 = 0;
    Rng rng(5);
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        Drawdown noisy = exact;
        for (DrawdownReading& reading : noisy.readings) {
            if (reading.thickness_um == 0) continue;
            for (double& value : reading.reflectance) {
                // Twelve uniform numbers less six: nearly normal, of variance 1.
                double normal = -6;
                for (int k = 0; k < 12; ++k) normal += rng.uniform_double();
                value = std::max(0.0, value + kNoise * normal);
            }
        }
        const PigmentEstimate estimate =
            estimate_pigment(noisy, {.geometry = geometry, .noise = kNoise});
        z2 += std::pow((estimate.scattering_per_mm[0] - 600) / *estimate.scattering_error[0], 2);
        z2 += std::pow((estimate.absorption_per_mm[1] - 1500) / *estimate.absorption_error[1], 2);
    }
    // Chi square with 12 degrees of freedom, between its quantiles of 0.0005 and 0.9995.
    EXPECT_GT(z2, 2.21);
    EXPECT_LT(z2, 34.8);
}

TEST(Drawdown, SaysWhereThePaintHidesItsGround) {
    const auto geometry = DrawdownGeometry::diffuse_8_included;
    Drawdown thick{{620}, {}};
    for (const GroundName& ground : kGrounds) {
        for (const double thickness : {0.0, 200.0}) {
            thick.readings.push_back(
                {ground.name, thickness, 0.2,
                 drawdown_reflectance(drawn(thickness, 0.2, ground.inside), {620}, geometry)});
        }
    }
    const PigmentEstimate estimate = estimate_pigment(thick, {.geometry = geometry});
    EXPECT_EQ(estimate.hidden_nm, std::vector<double>{620});
    // The ratio is known all the same.
    EXPECT_NEAR(estimate.absorption_per_mm[0] / estimate.scattering_per_mm[0], 20, 0.5);
    EXPECT_FALSE(estimate.scattering_error[0].has_value());  // two readings, two numbers
}

// A Lambertian ground under a smooth surface, by the solver and by Saunderson's formula.
TEST(Drawdown, GroundsUnderASurfaceAreSeenAsSaundersonSays) {
    for (const auto geometry :
         {DrawdownGeometry::diffuse_8_included, DrawdownGeometry::diffuse_8_excluded,
          DrawdownGeometry::angle_45_0}) {
        for (const double inside : {0.02, 0.5, 0.95}) {
            const std::vector<double> read =
                drawdown_reflectance(drawn(0, 0, inside), kWavelengths_nm, geometry);
            for (const double found :
                 ground_inside(read, kWavelengths_nm, optics::Material(1.5), geometry)) {
                EXPECT_NEAR(found, inside, 2e-5);
            }
        }
    }
    // Known: of diffuse light inside 1.5 the surface sends back 0.596.  [saunderson-1942]
    const double gloss = 0.04;
    EXPECT_NEAR(
        drawdown_reflectance(drawn(0, 0, 0.8), {550}, DrawdownGeometry::diffuse_8_included)[0],
        gloss + (1 - gloss) * (1 - 0.596) * 0.8 / (1 - 0.596 * 0.8), 1e-3);
}

TEST(Drawdown, RefusesWhatCannotTellScatteringFromAbsorption) {
    Drawdown one{{550}, {{"black", 0, 0, {0.05}}, {"black", 20, 0.1, {0.2}}}};
    EXPECT_THAT(message_of<DomainError>([&] { estimate_pigment(one); }),
                HasSubstr("over two grounds"));
    Drawdown lost{{550}, {{"black", 0, 0, {0.05}}, {"white", 20, 0.1, {0.2}}}};
    EXPECT_THAT(message_of<DomainError>([&] { estimate_pigment(lost); }),
                HasSubstr("ground = white: there is no reading of it bare"));
    Drawdown bright{{550}, {{"black", 0, 0, {0.05}}, {"black", 20, 0.1, {1.3}}}};
    EXPECT_THAT(message_of<DomainError>([&] { estimate_pigment(bright); }),
                HasSubstr("reflectance = 1.3: must be in [0, 1.2]"));
    Drawdown dark{{550}, {{"black", 0, 0, {0.001}}, {"black", 20, 0.1, {0.3}}}};
    EXPECT_THAT(message_of<DomainError>([&] { estimate_pigment(dark); }),
                HasSubstr("of the bare ground at 550 nm"));
}

TEST(Drawdown, KubelkaMunkConstantsAreThoseOfDiffuseLight) {
    // A layer that scatters far more than it absorbs, lit and read from all directions, by the
    // solver and by Kubelka's formula for the reflectance inside.           [kubelka-1948]
    const double K = 2, S = 60, thickness_mm = 0.1, ground = 0.3;
    paint::Recipe recipe;
    recipe.binder = optics::Material(1.0);  // no surface
    recipe.substrate_reflectance = ground;
    recipe.layers.push_back({1e3 * thickness_mm, {}, {{paint::PigmentKubelkaMunk{{K, S}, 0, {}}}}});
    const solver::SolvedPaint paint = solver::solve(recipe, {550});
    const Quadrature rule = gauss_legendre(24, 0, std::numbers::pi / 2);
    double read = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        for (std::size_t o = 0; o < rule.nodes.size(); ++o) {
            read += rule.weights[i] * rule.weights[o] * std::sin(2 * rule.nodes[i]) *
                    std::sin(2 * rule.nodes[o]) * std::numbers::pi *
                    paint.brdf(rule.nodes[i], rule.nodes[o], 0)[0];
        }
    }
    const double a = (S + K) / S, b = std::sqrt(a * a - 1);
    const double coth = 1 / std::tanh(b * S * thickness_mm);
    const double formula = (1 - ground * (a - b * coth)) / (a - ground + b * coth);
    // Two fluxes know no directions: what is left is their error.
    EXPECT_NEAR(read, formula, 0.02);
    EXPECT_GT(formula, 0.6);
}

}  // namespace
}  // namespace nacre::fit
