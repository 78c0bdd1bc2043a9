#include "nacre/solver/directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/optics/fresnel.h"

namespace nacre::solver {
namespace {

template <class F>
double integral(const Directions& d, F&& f) {
    double sum = 0;
    for (int i = 0; i < d.size(); ++i) sum += d.weight[i] * f(d.mu[i]);
    return sum;
}

// Fraction of diffuse light that a surface of index n reflects from outside, in closed form.
//                                                                  [walsh-1926]
double diffuse_reflectance(double n) {
    const double n2 = n * n, n4 = n2 * n2;
    return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
           2 * n * n2 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
           8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
}

TEST(Directions, IntegratePolynomialsInTheCosine) {
    for (double ior : {1.0, 1.3, 1.5, 2.0}) {
        const Directions d = make_directions(ior, 24, 24);
        for (int power = 0; power <= 6; ++power) {
            // Analytic in the angles, not polynomial: Gauss converges geometrically. 24 nodes a
            // panel suffice for all but rounding.
            EXPECT_NEAR(integral(d, [&](double mu) { return std::pow(mu, power); }),
                        1.0 / (power + 1), 1e-10)
                << ior << ' ' << power;
        }
    }
}

TEST(Directions, FluxWeightsSumToOneHalfAtTheCoarsestGrid) {
    // What the chosen resolution uses at least: 12 and 8 nodes.
    const Directions d = make_directions(1.5, 12, 8);
    EXPECT_NEAR(integral(d, [](double mu) { return mu; }), 0.5, 1e-8);
}

TEST(Directions, ResolveFresnelReflection) {
    for (double ior : {1.33, 1.5, 1.8}) {
        const Directions d = make_directions(ior, 16, 12);
        const double inside = 2 * integral(d, [&](double mu) {
                                  return mu * optics::dielectric_reflectance(ior, 1.0, mu);
                              });
        // Inside and outside are tied by the etendue: 1 - r_in = (1 - r_out)/n^2. Fresnel's
        // reflectance falls steeply towards grazing exit; 16 nodes in the angle outside give 1e-6.
        EXPECT_NEAR(inside, 1 - (1 - diffuse_reflectance(ior)) / (ior * ior), 1e-6) << ior;
    }
}

TEST(Directions, ThePanelsMeetAtTheCriticalAngle) {
    const Directions d = make_directions(1.5, 16, 12);
    const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
    ASSERT_EQ(d.exit_count, 16);
    ASSERT_EQ(d.size(), 28);
    double exit_width = 0;
    for (int i = 0; i < d.size(); ++i) {
        if (i < d.exit_count) {
            EXPECT_GT(d.mu[i], critical);
            EXPECT_NEAR(std::sin(d.exit_angle[i]), 1.5 * std::sqrt(1 - d.mu[i] * d.mu[i]), 1e-14);
            exit_width += d.weight[i];
        } else {
            EXPECT_LT(d.mu[i], critical);
        }
        if (i > 0) {
            EXPECT_LT(d.mu[i], d.mu[i - 1]);  // from the normal outwards
        }
    }
    EXPECT_NEAR(exit_width, 1 - critical, 1e-10);
}

TEST(Directions, WithoutAnInterfaceThereIsOnePanel) {
    const Directions d = make_directions(1.0, 20, 12);
    EXPECT_EQ(d.size(), 20);
    EXPECT_EQ(d.exit_count, 20);
    for (int i = 0; i < d.size(); ++i) EXPECT_EQ(d.mu[i], std::cos(d.exit_angle[i]));
}

TEST(Directions, RefuseAnIndexOutOfRange) {
    EXPECT_THROW(make_directions(0.9, 16, 12), DomainError);
    EXPECT_THROW(make_directions(3.1, 16, 12), DomainError);
    EXPECT_THROW(make_directions(std::nan(""), 16, 12), DomainError);
}

TEST(ExitInterpolation, IsExactForPolynomialsOfTheAngle) {
    for (int count : {4, 16, 64, 128}) {
        const Directions d = make_directions(1.5, count, 8);
        const ExitInterpolation interpolation(d.exit_angle);
        std::vector<double> weight(count);
        for (double theta : {0.0, 0.123, 0.8, 1.5, std::numbers::pi / 2}) {
            interpolation.weights_at(theta, weight.data());
            EXPECT_NEAR(std::accumulate(weight.begin(), weight.end(), 0.0), 1.0, 1e-13);
            for (int power : {1, 3}) {
                double sum = 0, size = 0;
                for (int i = 0; i < count; ++i) {
                    sum += weight[i] * std::pow(d.exit_angle[i], power);
                    size += std::abs(weight[i]);
                }
                // Rounding, times the size of weights that alternate beyond the last node.
                EXPECT_NEAR(sum, std::pow(theta, power), 1e-13 * size * 4) << count << ' ' << theta;
                EXPECT_LT(size, 10 * std::sqrt(count));  // Gauss nodes: at most like sqrt(count)
            }
        }
    }
}

TEST(ExitInterpolation, ReturnsNodesThemselves) {
    const Directions d = make_directions(1.5, 12, 8);
    const ExitInterpolation interpolation(d.exit_angle);
    std::vector<double> weight(12);
    interpolation.weights_at(d.exit_angle[5], weight.data());
    for (int i = 0; i < 12; ++i) EXPECT_EQ(weight[i], i == 5 ? 1.0 : 0.0);
}

TEST(InsideCosine, FollowsSnellAndKeepsDigitsAtGrazing) {
    EXPECT_NEAR(inside_cosine(1.5, std::numbers::pi / 2), std::sqrt(5.0) / 3, 1e-15);
    EXPECT_EQ(inside_cosine(1.5, 0), 1.0);
    const double grazing = std::numbers::pi / 2 - 1e-9;
    EXPECT_NEAR(inside_cosine(1.0, grazing), 1e-9, 4e-16);  // rounding of pi/2
}

}  // namespace
}  // namespace nacre::solver
