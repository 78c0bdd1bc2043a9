#include "nacre/core/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "nacre/core/error.h"

namespace nacre {
namespace {

TEST(GaussLegendre, ClosedFormsForUpToThreeNodes) {
    const Quadrature one = gauss_legendre(1, -1, 1);
    EXPECT_EQ(one.nodes[0], 0);
    EXPECT_EQ(one.weights[0], 2);

    const Quadrature two = gauss_legendre(2, -1, 1);
    EXPECT_NEAR(two.nodes[0], -std::sqrt(1.0 / 3), kGaussLegendreError);
    EXPECT_NEAR(two.weights[1], 1, kGaussLegendreError);

    const Quadrature three = gauss_legendre(3, -1, 1);
    EXPECT_NEAR(three.nodes[0], -std::sqrt(0.6), kGaussLegendreError);
    EXPECT_EQ(three.nodes[1], 0);
    EXPECT_NEAR(three.weights[1], 8.0 / 9, kGaussLegendreError);
    EXPECT_NEAR(three.weights[2], 5.0 / 9, kGaussLegendreError);
}

TEST(GaussLegendre, IntegratesPolynomialsUpToDegreeTwoNMinusOne) {
    for (int n : {1, 2, 5, 16, 31, 64}) {
        const Quadrature rule = gauss_legendre(n, 0, 1);
        ASSERT_EQ(rule.nodes.size(), static_cast<size_t>(n));
        for (int degree = 0; degree < 2 * n; ++degree) {
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
            }
            // n products of weights whose errors are independent.
            EXPECT_NEAR(sum, 1.0 / (degree + 1), kGaussLegendreError) << n << " " << degree;
        }
    }
}

TEST(GaussLegendre, NodesIncreaseInsideTheIntervalAndWeightsSumToItsLength) {
    for (int n = 1; n <= 512; ++n) {
        const Quadrature rule = gauss_legendre(n, 2, 5);
        EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0), 3, 1e-12) << n;
        double last = 2;
        for (int i = 0; i < n; ++i) {
            ASSERT_GT(rule.nodes[i], last) << n;
            ASSERT_GT(rule.weights[i], 0) << n;
            last = rule.nodes[i];
        }
        ASSERT_LT(last, 5) << n;
    }
}

// From mpmath 1.3.0 with 40 digits: Newton's method on the recurrence of P_n, weights by
// 2 / ((1 - x^2) P_n'(x)^2).
TEST(GaussLegendre, NodesAndWeightsMatchFortyDigitArithmetic) {
    const struct {
        int n, index;
        double node, weight;
    } cases[] = {
        {16, 15, 0.989400934991649933, 0.0271524594117540949},
        {16, 14, 0.944575023073232576, 0.0622535239386478929},
        {16, 8, 0.0950125098376374402, 0.189450610455068496},
        {48, 47, 0.998771007252426119, 0.00315334605230583863},
        {48, 46, 0.993530172266350758, 0.0073275539012762621},
        {48, 24, 0.032380170962869362, 0.0647376968126839225},
        {200, 199, 0.999928071285069977, 0.000184590097471297444},
        {200, 198, 0.999621031280936396, 0.000429646630451057073},
        {200, 100, 0.00783429114230636928, 0.0156682617158322548},
        {512, 511, 0.999988990984381868, 0.000028252637373934692},
        {512, 510, 0.999941994606845654, 0.0000657657316592401958},
        {512, 256, 0.00306496218515939615, 0.00612990517540578576},
    };
    for (const auto& c : cases) {
        const Quadrature rule = gauss_legendre(c.n, -1, 1);
        EXPECT_NEAR(rule.nodes[c.index], c.node, kGaussLegendreError) << c.n << " " << c.index;
        EXPECT_NEAR(rule.weights[c.index], c.weight, kGaussLegendreError) << c.n << " " << c.index;
    }
}

TEST(GaussLegendre, RefusesEmptyAndReversedIntervals) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(gauss_legendre(0, 0, 1), DomainError);
    EXPECT_THROW(gauss_legendre(4, 1, 1), DomainError);
    EXPECT_THROW(gauss_legendre(4, 1, 0), DomainError);
    EXPECT_THROW(gauss_legendre(4, nan, 1), DomainError);
    EXPECT_THROW(gauss_legendre(4, 0, std::numeric_limits<double>::infinity()), DomainError);
}

// [abramowitz-stegun-1964, eq. 9.1.18]: the mean of cos(z cos phi) is J_0(z).
TEST(Quadrature, CosinesOfAHalfTurnGiveMeansOverIt) {
    for (const int n : {16, 24}) {
        const Quadrature& rule = half_turn_cosines(n);
        double mean_square = 0, bessel = 0;
        for (int k = 0; k < n; ++k) {
            mean_square += rule.weights[k] * rule.nodes[k] * rule.nodes[k];
            bessel += rule.weights[k] * std::cos(3.0 * rule.nodes[k]);
        }
        EXPECT_NEAR(mean_square, 0.5, 1e-12);
        EXPECT_NEAR(bessel, std::cyl_bessel_j(0, 3.0), 1e-9);
    }
}

}  // namespace
}  // namespace nacre
