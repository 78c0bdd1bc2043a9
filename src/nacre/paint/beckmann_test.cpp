#include "nacre/paint/beckmann.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/statistics.h"

namespace nacre::paint {
namespace {

using nacre::test::message_of;

// Relative error of the sum over for_each_normal against s(mu): 16 radial nodes on either side of
// the slope at which flakes begin to be seen edge on, and exp(-26) of the normals left out.
constexpr double kNormalQuadratureError = 1e-5;
// brute_force() below: the midpoint rule steps over kinks in azimuth.
constexpr double kBruteForceError = 3e-5;

// s(1) = Int |cos m| D(m) dm = Int_0^inf 2 t/alpha^2 exp(-t^2/alpha^2) / sqrt(1 + t^2) dt
//      = (sqrt(pi)/alpha) erfcx(1/alpha).
double facing_area(double alpha) {
    const double x = 1 / alpha;
    // exp(x^2) overflows beyond x = 26; there the asymptotic series of erfcx has an error below its
    // first omitted term, 6.6/x^8 < 1e-10.
    const double erfcx =
        x < 20 ? std::exp(x * x) * std::erfc(x)
               : (1 - 0.5 / (x * x) + 0.75 / std::pow(x, 4) - 1.875 / std::pow(x, 6)) /
                     (x * std::sqrt(std::numbers::pi));
    return std::sqrt(std::numbers::pi) / alpha * erfcx;
}

// Int f(|w.m|) |w.m| D(m) dm by brute force over cos theta_m and phi: the midpoint rule in phi,
// Gauss in 200 panels of the slope.
template <class F>
double brute_force(double mu, double alpha, F&& f) {
    constexpr int kPanels = 200, kAzimuths = 720;
    const Quadrature unit = gauss_legendre(4, 0, 1);
    const double s = std::sqrt(1 - mu * mu), t_max = 6 * alpha;  // exp(-36) is left out
    double sum = 0;
    for (int p = 0; p < kPanels; ++p) {
        for (std::size_t k = 0; k < unit.nodes.size(); ++k) {
            const double t = t_max * (p + unit.nodes[k]) / kPanels;
            const double cos_m = 1 / std::sqrt(1 + t * t), sin_m = t * cos_m;
            // dm = sin dtheta dphi, dtheta = cos^2 dt; both hemispheres count, D is even.
            const double ring = t_max / kPanels * unit.weights[k] * 2 * sin_m * cos_m * cos_m *
                                flake_density(t * t, alpha);
            for (int a = 0; a < kAzimuths; ++a) {
                const double phi = 2 * std::numbers::pi * (a + 0.5) / kAzimuths;
                const double c = std::abs(mu * cos_m - s * sin_m * std::cos(phi));
                sum += ring * 2 * std::numbers::pi / kAzimuths * c * f(std::min(1.0, c));
            }
        }
    }
    return sum;
}

TEST(BeckmannFlakes, NormalsIntegrateToOneOverTheSphere) {
    for (double alpha : {0.02, 0.1, 0.3, 1.0, 2.0}) {
        // Int D dm = 4 pi Int_0^inf D t cos^3 dt, cos = (1 + t^2)^(-1/2); D cos^3 is a Gaussian.
        const Quadrature radial = gauss_legendre(64, 0, 6 * alpha);
        double sum = 0;
        for (std::size_t k = 0; k < radial.nodes.size(); ++k) {
            const double t = radial.nodes[k];
            sum += radial.weights[k] * 4 * std::numbers::pi * t * std::pow(1 + t * t, -1.5) *
                   flake_density(t * t, alpha);
        }
        EXPECT_NEAR(sum, 1.0, 1e-13) << alpha;  // exp(-36) = 2e-16 is cut off; 64 nodes: rounding
    }
}

TEST(BeckmannFlakes, DensityIsMicrofacetBeckmannTimesHalfTheCosine) {
    for (double alpha : {0.05, 0.4}) {
        for (double theta : {0.0, 0.02, 0.3, 1.2}) {
            const double tan2 = std::tan(theta) * std::tan(theta), c = std::cos(theta);
            const double microfacet = std::exp(-tan2 / (alpha * alpha)) /
                                      (std::numbers::pi * alpha * alpha * std::pow(c, 4));
            EXPECT_NEAR(flake_density(tan2, alpha), 0.5 * c * microfacet, 1e-12 * microfacet);
        }
    }
}

TEST(BeckmannFlakes, ProjectedAreaFaceOnHasAClosedForm) {
    for (double alpha : {0.005, 0.02, 0.1, 0.3, 0.5, 1.0, 2.0}) {
        EXPECT_NEAR(projected_area(1.0, alpha), facing_area(alpha), 1e-9) << alpha;  // beckmann.h
    }
}

TEST(BeckmannFlakes, ProjectedAreaMatchesTheTable) {
    struct Row {
        double alpha, mu, s;
    };
    // mpmath 1.3: quad(lambda t: 2 t/a^2 exp(-t^2/a^2)/sqrt(1 + t^2) P(t)), P the mean over azimuth
    // of |mu - s t cos phi|, 20 digits, split at t = mu/s; a midpoint rule over t and phi agrees.
    for (const Row& row :
         {Row{0.1, 1, .9950731878}, Row{0.1, .5, .4975365939}, Row{0.1, .2, .1990907791},
          Row{0.1, .05, .0694580910}, Row{0.3, 1, .9600198566}, Row{0.3, .5, .4803032343},
          Row{0.3, .2, .2258440078}, Row{0.3, .05, .1637693455}}) {
        EXPECT_NEAR(projected_area(row.mu, row.alpha), row.s, 1e-9 * row.s + 5e-11)
            << row.alpha << ' ' << row.mu;  // beckmann.h, and ten digits
    }
}

TEST(BeckmannFlakes, ProjectedAreaIsTheCosineWhereNoFlakeStandsEdgeOn) {
    // s(mu) = mu s(1) up to the fraction exp(-(mu / (alpha sin theta))^2) of normals beyond the
    // edge.
    for (double mu : {0.6, 0.8, 0.99}) {
        EXPECT_NEAR(projected_area(mu, 0.1), mu * facing_area(0.1), 1e-12);
    }
}

TEST(BeckmannFlakes, ProjectedAreaHasTheRightMeanOverDirections) {
    // The mean projection of a flat flake over all directions is 1/2, however flakes lie.
    const Quadrature mu = gauss_legendre(200, 0, 1);
    for (double alpha : {0.05, 0.1, 0.5, 2.0}) {
        double mean = 0;
        for (std::size_t k = 0; k < mu.nodes.size(); ++k) {
            mean += mu.weights[k] * projected_area(mu.nodes[k], alpha);
        }
        EXPECT_NEAR(mean, 0.5, 1e-9) << alpha;  // as s itself
    }
}

TEST(BeckmannFlakes, QuadratureOfNormalsSumsToTheProjectedArea) {
    double worst = 0;
    int cases = 0;
    for (double alpha : {0.02, 0.05, 0.1, 0.3, 0.5, 1.0}) {
        for (double mu : {1.0, 0.9, 0.75, 0.5, 0.2, 0.1, 0.05, 0.01, 1e-4, 0.0}) {
            double sum = 0;
            for_each_normal(mu, alpha, kNormalNodes, [&](double cosine, double weight) {
                EXPECT_GE(cosine, 0);
                EXPECT_LE(cosine, 1);
                EXPECT_GE(weight, 0);
                sum += weight;
            });
            const double s = projected_area(mu, alpha);
            worst = test::worse(worst, std::abs(sum - s) / s);
            ++cases;
        }
    }
    EXPECT_EQ(cases, 60);
    EXPECT_LT(worst, kNormalQuadratureError);
}

TEST(BeckmannFlakes, QuadratureOfNormalsMatchesBruteForce) {
    const auto f = [](double c) { return 0.2 + 0.8 * std::pow(1 - c, 5) * (1 - 0.3 * c); };
    for (double alpha : {0.05, 0.3, 1.0}) {
        for (double mu : {1.0, 0.6, 0.15, 0.03}) {
            double sum = 0;
            for_each_normal(mu, alpha, kNormalNodes,
                            [&](double c, double weight) { sum += weight * f(c); });
            const double expected = brute_force(mu, alpha, f);
            EXPECT_NEAR(sum, expected, (kNormalQuadratureError + kBruteForceError) * expected)
                << alpha << ' ' << mu;
        }
    }
}

// Fringes of a film: a phase of 100 rad over the cosines takes some 75 Chebyshev cosines, of which
// tables hold 257.
TEST(BeckmannFlakes, FringesTakeAsManyNodesAsTheirCosines) {
    const auto fringes = [](double c) { return 0.5 + 0.5 * std::cos(100 * c); };
    for (double alpha : {0.1, 0.4, 1.0}) {
        double worst = 0, worst_of_16 = 0;
        for (double mu : {1.0, 0.8, 0.4, 0.1}) {
            const double expected = brute_force(mu, alpha, fringes);
            const auto error = [&](int nodes) {
                double sum = 0;
                for_each_normal(mu, alpha, nodes,
                                [&](double c, double w) { sum += w * fringes(c); });
                return std::abs(sum - expected) / projected_area(mu, alpha);
            };
            worst = test::worse(worst, error(normal_nodes(alpha, 257)));
            worst_of_16 = test::worse(worst_of_16, error(kNormalNodes));
        }
        EXPECT_LT(worst, 1e-6) << alpha;  // found: 9e-8
        EXPECT_GT(worst_of_16, 3 * worst) << alpha;
    }
    EXPECT_EQ(normal_nodes(0.4, 1), kNormalNodes);
    EXPECT_EQ(normal_nodes(0.4, 513), 64);
}

TEST(BeckmannFlakes, RefusesCosinesAndRoughnessOutOfRange) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(projected_area(-0.1, 0.1), DomainError);
    EXPECT_THROW(projected_area(1.1, 0.1), DomainError);
    EXPECT_THROW(projected_area(kNaN, 0.1), DomainError);
    EXPECT_THROW(projected_area(0.5, 0.0), DomainError);
    EXPECT_THROW(projected_area(0.5, kNaN), DomainError);
    EXPECT_THAT(message_of<DomainError>([&] { projected_area(0.5, -1); }),
                ::testing::HasSubstr("alpha = -1"));
}

}  // namespace
}  // namespace nacre::paint
