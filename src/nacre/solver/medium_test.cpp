#include "nacre/solver/medium.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "nacre/core/error.h"
#include "nacre/core/vec.h"
#include "nacre/paint/beckmann.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/layers.h"

namespace nacre::solver {
namespace {

using test::kOneWavelength;
using ::testing::HasSubstr;

// Equations (3) to (6) of [mir-2022] as printed, with the exponent of (4) repaired: an independent
// form of the same kernel, which loses digits to cancellation.
double printed_kernel(double alpha, double c, double reflectance, double mu_i, double mu_o,
                      double phi) {
    // Travel cosines have opposite signs, and phi between directions of travel is pi away from
    // that between directions that point away from the surface.
    const double in = -mu_i, out = mu_o, travel = phi - std::numbers::pi, a2 = alpha * alpha;
    const double s_i = std::sqrt(1 - in * in), s_o = std::sqrt(1 - out * out), d = in - out;
    const double a = (in * in + out * out - 2) / (a2 * d * d), b = 2 * s_i * s_o / (a2 * d * d);
    const double x = 1 - in * out - s_i * s_o * std::cos(travel);
    const double density = std::sqrt(2.0) * std::pow(x, 1.5) * std::exp(a + b * std::cos(travel)) /
                           (std::numbers::pi * a2 * std::pow(std::abs(d), 3));
    return 0.5 * c * reflectance * density;
}

TEST(PaintMedium, KernelIsThePrintedOneWithoutItsCancellation) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> cosine(0.05, 0.999), azimuth(0, 2 * std::numbers::pi);
    int compared = 0;
    for (double alpha : {0.1, 0.3, 1.0}) {
        const PaintMedium m = make_medium(test::flake_paint(alpha, 0.6, 0, 1, 1.5), kOneWavelength);
        for (int k = 0; k < 2000; ++k) {
            const double mu_i = cosine(engine), mu_o = cosine(engine), phi = azimuth(engine);
            const double printed = printed_kernel(alpha, 0.1, 0.6, mu_i, mu_o, phi);
            if (printed < 1e-12) continue;  // far out in the tail there is nothing to compare
            // The printed exponent is a difference of terms of size 2/(alpha delta)^2.
            const double delta = mu_i + mu_o;
            const double rounding = 1e-15 * (10 + 8 / (alpha * alpha * delta * delta));
            ASSERT_NEAR(backscattering(m.layers[0], mu_i, mu_o, phi, 0)[0], printed,
                        rounding * printed);
            ++compared;
        }
    }
    EXPECT_GT(compared, 2000);
}

// c D(h) R / 2 from vectors, between directions of travel.
double vector_kernel(double alpha, double c, double reflectance, const Vec3d& in,
                     const Vec3d& out) {
    const Vec3d h = normalize(out - in);
    const double tan2 = (1 - h.z * h.z) / (h.z * h.z);
    return 0.5 * c * reflectance * paint::flake_density(tan2, alpha);
}

TEST(PaintMedium, ScatteringIntegratesToTheCrossSection) {
    // Int sigma_s p dw' over the whole sphere = sigma_t - sigma_a, for flakes with R = 0.6, T = 0.1.
    const double alpha = 0.4;
    const PaintMedium m = make_medium(test::flake_paint(alpha, 0.6, 0.1, 1, 1.5), kOneWavelength);
    const Quadrature cube_root = gauss_legendre(200, 0, 1);
    for (double mu : {0.95, 0.5, 0.2}) {
        const Vec3d in(std::sqrt(1 - mu * mu), 0, mu);
        double sum = 0;
        // Like |z - mu| near z = mu: split there.
        for (const Quadrature& cosine : {gauss_legendre(150, -1, mu), gauss_legendre(150, mu, 1)}) {
            for (std::size_t i = 0; i < cosine.nodes.size(); ++i) {
                const double z = cosine.nodes[i], s = std::sqrt(1 - z * z);
                // phi = pi x^3: next to the kink, lobes are narrow around phi = 0.
                for (std::size_t k = 0; k < cube_root.nodes.size(); ++k) {
                    const double x = cube_root.nodes[k], phi = std::numbers::pi * x * x * x;
                    sum += cosine.weights[i] * cube_root.weights[k] * 6 * std::numbers::pi * x * x *
                           vector_kernel(alpha, 0.1, 0.6, in,
                                         {s * std::cos(phi), s * std::sin(phi), z});
                }
            }
        }
        const double scattering =
            extinction(m.layers[0], mu, 0)[0] - losses(m.layers[0], mu, 0, 1).absorption[0][0];
        // for_each_normal errs by 1e-5, the sum here less.
        EXPECT_NEAR(sum, scattering, 3e-5 * scattering) << mu;
        // Both in closed form: c R s(mu), c (1 - T) s(mu).
        const double s = paint::projected_area(mu, alpha);
        EXPECT_NEAR(scattering, 0.1 * 0.6 * s, 1e-5 * s);
        EXPECT_NEAR(extinction(m.layers[0], mu, 0)[0], 0.1 * 0.9 * s, 1e-5 * s);
    }
}

TEST(PaintMedium, BackscatteringIsReciprocalEvenInAzimuthAndMatchesVectors) {
    paint::Recipe recipe = test::flake_paint(0.25, 0.7, 0.1, 1, 1.5);
    recipe.layers[0].pigments.push_back({paint::PigmentCoefficients{30.0, 5.0, 0.6}});
    const PaintMedium m = make_medium(recipe, kOneWavelength);
    std::mt19937 engine(2);
    std::uniform_real_distribution<double> cosine(0.01, 1), azimuth(0, 2 * std::numbers::pi);
    for (int k = 0; k < 1000; ++k) {
        const double mu_i = cosine(engine), mu_o = cosine(engine), phi = azimuth(engine);
        const double s_i = std::sqrt(1 - mu_i * mu_i), s_o = std::sqrt(1 - mu_o * mu_o);
        const double value = backscattering(m.layers[0], mu_i, mu_o, phi, 0)[0];
        ASSERT_NEAR(backscattering(m.layers[0], mu_o, mu_i, phi, 0)[0], value, 1e-12 * value);
        ASSERT_NEAR(backscattering(m.layers[0], mu_i, mu_o, -phi, 0)[0], value, 1e-12 * value);
        // Light comes from (mu_i, azimuth 0) and so travels away from it.
        const Vec3d in(-s_i, 0, -mu_i);
        const Vec3d out(s_o * std::cos(phi), s_o * std::sin(phi), mu_o);
        const double g = 0.6, turn = dot(in, out);
        const double pigment =
            0.03 * (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * turn, 1.5));
        const double expected = vector_kernel(0.25, 0.1, 0.7, in, out) + pigment;
        // Half vectors from differences lose digits where in and out nearly agree: 1e-10.
        ASSERT_NEAR(value, expected, 1e-10 * expected);
    }
}

TEST(PaintMedium, FlakesThatTransmitOrReflectAllAbsorbNothing) {
    const PaintMedium m = make_medium(test::flake_paint(0.1, 0.4, 0.6, 1, 1.5), kOneWavelength);
    for (double mu : {1.0, 0.3, 1e-3}) {
        const double lost = losses(m.layers[0], mu, 0, 1).absorption[0][0];
        EXPECT_GE(lost, 0);
        EXPECT_LT(lost, 1e-16 * 10);  // rounding of 1 - R - T, never negative
    }
}

TEST(PaintMedium, CarriesUnitsOverFromTheRecipe) {
    paint::Recipe recipe = test::pigment_paint(0.8, 3, 0.2, 1.6);  // 3 in 100 um
    recipe.clearcoat = paint::Clearcoat{40, spectra::Spectrum(2.5), 0.0};
    recipe.substrate_reflectance = spectra::Spectrum({400, 700}, {0.2, 0.5});
    const PaintMedium m = make_medium(recipe, {400, 550, 700});
    EXPECT_EQ(m.wavelength_count(), 3);
    EXPECT_EQ(m.ior, std::vector<double>({1.6, 1.6, 1.6}));
    EXPECT_NEAR(m.clearcoat_depth[1], 0.1, 1e-15);  // 2.5 per mm x 0.04 mm
    EXPECT_NEAR(m.layers[0].pigments[0].scattering_per_um[0], 2.4e-2, 1e-16);
    EXPECT_NEAR(m.substrate_reflectance[1], 0.35, 1e-15);
    EXPECT_NEAR(extinction(m.layers[0], 0.4, 0)[2], 3e-2, 1e-16);  // isotropic
}

TEST(PaintMedium, NamesThePigmentThatIsTooSharp) {
    const auto complaint = [](paint::Pigment pigment) {
        paint::Recipe recipe = test::flake_paint(0.1, 0.6, 0.1, 1, 1.5);
        // What is solved has more layers than the recipe where alpha changes with depth.
        recipe.layers[0].flakes[0].orientation.alpha_bottom = 0.3;
        recipe.layers.push_back(test::pigment_paint(0.8, 3, 0.97, 1.5).layers[0]);
        recipe.layers[1].pigments.push_back(std::move(pigment));
        return nacre::test::message_of<DomainError>([&] { make_medium(recipe, kOneWavelength); });
    };
    EXPECT_EQ(complaint({paint::PigmentCoefficients{10.0, 1.0, 0.97}}), "accepted");
    EXPECT_THAT(complaint({paint::PigmentCoefficients{10.0, 1.0, -0.98}}),
                HasSubstr("layer[1].pigment[1].anisotropy = -0.98: must be in [-0.97, 0.97]"));
    paint::PigmentParticles balls;
    balls.spheres.material = optics::Material(2.0);
    balls.spheres.diameter_nm = 9000;
    balls.amount = paint::PigmentVolume{0.1};
    EXPECT_THAT(complaint({balls}), HasSubstr("layer[1].pigment[1].diameter_nm = 9000: particles"));
}

TEST(PaintMedium, RefusesWhatTheRecipeForbids) {
    paint::Recipe recipe = test::flake_paint(0.1, 0.7, 0.5, 1, 1.5);  // R + T > 1
    EXPECT_THROW(make_medium(recipe, kOneWavelength), DomainError);
}

}  // namespace
}  // namespace nacre::solver
