#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/math.h"
#include "nacre/testing/layers.h"

// The closed form of single scattering.

namespace nacre::solver {
namespace {

using test::flake_species;
using test::kOneWavelength;

// An absorbing clearcoat, flakes and pigment over flakes of another species.
PaintMedium two_layers() {
    paint::Recipe recipe = test::flake_paint(0.15, 0.5, 0.2, 1.2, 1.5);
    recipe.layers[0].pigments.push_back({paint::PigmentCoefficients{20.0, 10.0, 0.4}});
    recipe.layers.push_back({25, {flake_species(0.4, 0.8, 0.0)}, {}});
    recipe.clearcoat = paint::Clearcoat{40, 5.0, 0.0};
    return make_medium(recipe, kOneWavelength);
}

double transmitted(double theta) {
    return 1 - optics::dielectric_reflectance(1.0, 1.5, std::cos(theta));
}

TEST(SingleScattering, IsTheDepthIntegralOverThinSublayers) {
    const PaintMedium medium = two_layers();
    const Quadrature unit = gauss_legendre(24, 0, 1);
    for (const double theta_i : {0.1, 0.8, 1.5}) {
        for (const double theta_o : {0.0, 0.7, 1.3}) {
            for (const double phi : {std::numbers::pi, 2.0, 0.0}) {
                const double mu_i = inside_cosine(1.5, theta_i), mu_o = inside_cosine(1.5, theta_o);
                const double path = 1 / mu_i + 1 / mu_o;
                double sum = 0, above = 5.0 * 0.04 * path;
                for (const LayerMedium& layer : medium.layers) {
                    const double rate =
                        extinction(layer, mu_i, 0)[0] / mu_i + extinction(layer, mu_o, 0)[0] / mu_o;
                    for (int k = 0; k < 24; ++k) {
                        const double z = layer.thickness_um * unit.nodes[k];
                        sum += layer.thickness_um * unit.weights[k] * std::exp(-above - rate * z) *
                               backscattering(layer, mu_i, mu_o, phi, 0)[0] / (mu_i * mu_o);
                    }
                    above += rate * layer.thickness_um;
                }
                const double expected = transmitted(theta_i) * transmitted(theta_o) / 2.25 * sum;
                // 24 Gauss nodes integrate an exponential of depth < 20 to rounding.
                EXPECT_NEAR(single_scattering(medium, theta_i, theta_o, phi)[0], expected,
                            1e-12 * expected);
            }
        }
    }
}

TEST(SingleScattering, DoesNotDependOnHowALayerIsDivided) {
    paint::Recipe whole = test::flake_paint(0.1, 0.6, 0.1, 1.5, 1.5), cut = whole;
    cut.layers.clear();
    for (const double thickness : {1.0, 4.0, 10.0}) {
        cut.layers.push_back(whole.layers[0]);
        cut.layers.back().thickness_um = thickness;
    }
    for (const double theta : {0.0, 0.5, 1.55}) {
        const double expected =
            single_scattering(make_medium(whole, kOneWavelength), 0.6, theta, std::numbers::pi)[0];
        EXPECT_NEAR(
            single_scattering(make_medium(cut, kOneWavelength), 0.6, theta, std::numbers::pi)[0],
            expected, 1e-13 * expected);
    }
}

TEST(SingleScattering, ThinLayersApproachKernelTimesThickness) {
    const PaintMedium medium =
        make_medium(test::flake_paint(0.2, 0.6, 0, 1e-9, 1.5), kOneWavelength);
    const double mu_i = inside_cosine(1.5, 0.6), mu_o = inside_cosine(1.5, 0.3);
    const double expected = transmitted(0.6) * transmitted(0.3) / 2.25 * 1e-8 *
                            backscattering(medium.layers[0], mu_i, mu_o, std::numbers::pi, 0)[0] /
                            (mu_i * mu_o);
    // Attenuation over the depth of 1e-9, and nothing cancels.
    EXPECT_NEAR(single_scattering(medium, 0.6, 0.3, std::numbers::pi)[0], expected,
                2e-9 * expected);
}

TEST(SingleScattering, FollowsADispersiveBinder) {
    paint::Recipe recipe = test::flake_paint(0.2, 0.6, 0, 1, 1.5);
    recipe.binder =
        optics::Material("binder", {400, 700}, std::vector<optics::ComplexIndex>{1.6, 1.45});
    const std::vector<double> wavelengths = {420, 500, 550, 690};
    const auto all = single_scattering(make_medium(recipe, wavelengths), 0.9, 0.7, 3.0);
    ASSERT_EQ(all.size(), wavelengths.size());
    for (std::size_t w = 0; w < wavelengths.size(); ++w) {
        const auto one = single_scattering(make_medium(recipe, {wavelengths[w]}), 0.9, 0.7, 3.0);
        EXPECT_NEAR(all[w], one[0], 1e-14 * one[0]);
        if (w > 0) {
            EXPECT_NE(all[w], all[w - 1]);
        }
    }
}

TEST(SingleScattering, IsReciprocal) {
    const PaintMedium medium = two_layers();
    for (const double phi : {0.0, 1.0, std::numbers::pi}) {
        const double f = single_scattering(medium, 10 * kDegree, 80 * kDegree, phi)[0];
        EXPECT_NEAR(single_scattering(medium, 80 * kDegree, 10 * kDegree, phi)[0], f, 1e-13 * f);
    }
}

}  // namespace
}  // namespace nacre::solver
