#include "nacre/volume/flake_candidates.h"

#include <gtest/gtest.h>

#include "nacre/core/quadrature.h"
#include "nacre/flakes/beckmann.h"

namespace nacre::volume {
namespace {

TEST(FlakeCandidates, AreaIsTheMeanOfTheFoldedGaussian) {
    for (const double alpha : {0.005, 0.1, 0.5, 1.0}) {
        for (const double mu : {0.0, 0.01, 0.1, 0.5, 0.95, 1.0}) {
            const double sine = std::sqrt(1 - mu * mu);
            // The tail beyond 6 alpha holds exp(-36); the kink gets a panel on each side.
            const double reach = 6 * alpha;
            const double kink = sine > 0 ? std::min(reach, mu / sine) : reach;
            double mean = 0;
            const auto add = [&](double from, double to) {
                if (!(to > from)) return;
                const Quadrature rule = gauss_legendre(80, from, to);
                for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                    const double p = rule.nodes[i];
                    mean += rule.weights[i] * std::abs(mu - sine * p) *
                            std::exp(-p * p / (alpha * alpha)) /
                            (alpha * std::sqrt(std::numbers::pi));
                }
            };
            add(-reach, kink);
            add(kink, reach);
            EXPECT_NEAR(candidate_area(mu, alpha), mean, 1e-12) << mu << ' ' << alpha;
            EXPECT_EQ(candidate_area(mu, alpha), candidate_area(-mu, alpha));
        }
    }
}

TEST(FlakeCandidates, AreaGrowsWithTheCosine) {
    // Else its value at the end of a ray would be no majorant. Where flakes are narrow it is the
    // cosine itself, to a rounding.
    for (const double alpha : {0.005, 0.1, 1.0}) {
        double last = 0;
        for (int i = 0; i <= 2000; ++i) {
            const double area = candidate_area(i / 2000., alpha);
            EXPECT_GE(area, last * (1 - 1e-15)) << i << ' ' << alpha;
            last = area;
        }
        EXPECT_EQ(last, 1);
    }
}

TEST(FlakeCandidates, ThoseThatAreRealHaveTheProjectedAreaOfTheFlakes) {
    // E[m_z] over candidates, times their area, against the quadrature over flake normals.
    reference::RandomStream random(1, 2, 3);
    constexpr int kDraws = 100'000;
    for (const double alpha : {0.1, 0.6}) {
        for (const double mu : {0.02, 0.3, 0.8, -0.8, 1.0}) {
            const double sine = std::sqrt(1 - mu * mu);
            double sum = 0, squares = 0;
            for (int i = 0; i < kDraws; ++i) {
                const auto [p, q] = sample_candidate(mu, sine, alpha, random);
                const double upright = 1 / std::sqrt(1 + p * p + q * q);
                sum += upright;
                squares += upright * upright;
            }
            const double mean = sum / kDraws;
            const double error = std::sqrt((squares / kDraws - mean * mean) / kDraws);
            const double expected =
                flakes::projected_area(std::abs(mu), alpha) / candidate_area(mu, alpha);
            EXPECT_LT(std::abs(mean - expected), 4 * error + 1e-9) << mu << ' ' << alpha;
        }
    }
}

TEST(FlakeCandidates, SlopesFollowWhatIsSeen) {
    // Histogram of the slope along the ray against the integral of its density: chi-square of 20
    // bins, 19 degrees of freedom, exceeds 43.8 once in 1000.
    reference::RandomStream random(4, 5, 6);
    constexpr int kDraws = 200'000, kBins = 20;
    const double alpha = 0.3;
    for (const double mu : {-0.9, 0.1, 0.5}) {
        const double sine = std::sqrt(1 - mu * mu);
        std::array<double, kBins> expected{}, found{};
        const auto bin_edge = [&](int i) { return alpha * (-2.5 + 5. * i / kBins); };
        for (int i = 0; i < kBins; ++i) {
            const double from = i == 0 ? -6 * alpha : bin_edge(i);
            const double to = i == kBins - 1 ? 6 * alpha : bin_edge(i + 1);
            constexpr int kSteps = 4000;
            for (int k = 0; k < kSteps; ++k) {
                const double p = from + (to - from) * (k + .5) / kSteps;
                expected[i] += (to - from) / kSteps * std::abs(mu - sine * p) *
                               std::exp(-p * p / (alpha * alpha)) /
                               (alpha * std::sqrt(std::numbers::pi) * candidate_area(mu, alpha));
            }
        }
        double across_sq = 0;
        for (int i = 0; i < kDraws; ++i) {
            const auto [p, q] = sample_candidate(mu, sine, alpha, random);
            const int bin = static_cast<int>(std::floor((p / alpha + 2.5) / 5 * kBins));
            found[std::clamp(bin, 0, kBins - 1)] += 1;
            across_sq += q * q;
        }
        double chi_square = 0;
        for (int i = 0; i < kBins; ++i) {
            const double n = kDraws * expected[i];
            ASSERT_GT(n, 10);
            chi_square += (found[i] - n) * (found[i] - n) / n;
        }
        EXPECT_LT(chi_square, 43.8) << mu;
        // Across: variance alpha^2 / 2, whose estimate scatters by its square root of 2 / draws.
        EXPECT_NEAR(across_sq / kDraws / (alpha * alpha / 2), 1, 4 * std::sqrt(2. / kDraws));
    }
}

}  // namespace
}  // namespace nacre::volume
