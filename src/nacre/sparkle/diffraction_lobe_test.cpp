#include "nacre/sparkle/diffraction_lobe.h"

#include <gtest/gtest.h>

#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"

namespace nacre::sparkle {
namespace {

TEST(DiffractionLobe, HasTheContrastOfTheAiryPattern) {
    // Int K^2 over |q|, for d = 20 um in a binder of 1.5: of the Airy pattern by quadrature (its
    // tail beyond x = 400 holds less than 1e-6), of ours in closed form.
    const double d_over_lambda = 20 / (0.55 / 1.5);
    double airy = 0;
    const Quadrature rule = gauss_legendre(40, 0.0, 1.0);
    for (int panel = 0; panel < 100; ++panel) {
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double x = 4 * (panel + rule.nodes[i]);
            const double amplitude = 2 * std::cyl_bessel_j(1.0, x) / x;
            airy += 4 * rule.weights[i] * x * std::pow(amplitude, 4);
        }
    }
    airy *= std::numbers::pi / 8 * d_over_lambda * d_over_lambda;
    const double w = 2 * DiffractionLobe(0.1, 1.5).radius(20.0f);  // |q| = 2 slope
    const double e = DiffractionLobe::kLobePower;
    EXPECT_NEAR(e * e * 9 / (5 * std::numbers::pi * w * w), airy, 1e-4 * airy);
}

TEST(DiffractionLobe, HasUnitIntegral) {
    const Quadrature rule = gauss_legendre(8, 0.0, 1.0);
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double r = 0.03 * rule.nodes[i];
        sum += 0.03 * rule.weights[i] * 2 * std::numbers::pi * r *
               DiffractionLobe::density(static_cast<float>(r * r), 0.03f);
    }
    EXPECT_NEAR(sum, 1, 1e-6);
}

TEST(DiffractionLobe, BlurIsTheConvolutionWithTheSlopes) {
    const double alpha = 0.1;
    const DiffractionLobe lobe(alpha, 1.5);
    const Quadrature radial = gauss_legendre(48, 0.0, 1.0);
    constexpr int kAngles = 256;
    for (double width : {0.003, 0.017, 0.1, 0.27, 0.4}) {
        for (double p : {0.0, 0.04, 0.1, 0.23, 0.37}) {
            double sum = 0;
            for (std::size_t i = 0; i < radial.nodes.size(); ++i) {
                const double r = width * radial.nodes[i];
                for (int k = 0; k < kAngles; ++k) {
                    const double angle = 2 * std::numbers::pi * (k + 0.5) / kAngles;
                    const double x = p - r * std::cos(angle), y = r * std::sin(angle);
                    sum += radial.weights[i] * width * r * 2 * std::numbers::pi / kAngles * 3 /
                           (std::numbers::pi * width * width) *
                           std::pow(1 - r * r / (width * width), 2) *
                           std::exp((p * p - x * x - y * y) / (alpha * alpha));
                }
            }
            EXPECT_NEAR(lobe.blur(static_cast<float>(p * p), static_cast<float>(width)) / sum, 1,
                        DiffractionLobe::kBlurError)
                << width << ' ' << p;
        }
    }
}

TEST(DiffractionLobe, OfLargeFlakesIsNarrow) {
    const DiffractionLobe lobe(0.1, 1.5);
    EXPECT_NEAR(lobe.radius(10.0f) / lobe.radius(20.0f), 2, 1e-5);
    // Its edge leaves a coat of 1.5 some 2 deg beside the mirror direction: 1.16 lambda/d.
    EXPECT_NEAR(2 * 1.5 * lobe.radius(20.0f), 0.92 * 1.26 * 0.55 / 20, 1e-5);
    EXPECT_THROW(DiffractionLobe(0, 1.5), DomainError);
    EXPECT_THROW(DiffractionLobe(0.1, 0.9), DomainError);
}

}  // namespace
}  // namespace nacre::sparkle
