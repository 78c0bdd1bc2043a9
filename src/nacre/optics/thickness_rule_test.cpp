#include "nacre/optics/thickness_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace nacre::optics {
namespace {

using Law = ThicknessSpread::Law;

struct Moments {
    double mass, mean, deviation;
};

Moments moments(const ThicknessRule& rule) {
    Moments m{0, 0, 0};
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        m.mass += rule.weights[i];
        m.mean += rule.weights[i] * rule.thickness_nm[i];
    }
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        m.deviation += rule.weights[i] * std::pow(rule.thickness_nm[i] - m.mean, 2);
    }
    m.deviation = std::sqrt(m.deviation);
    return m;
}

TEST(ThicknessRule, HasTheMomentsOfItsLaw) {
    // A normal law cut at c deviations keeps 1 - 2 c phi(c)/(2 Phi(c) - 1) of its variance.
    const double kept = 1 - 6 * std::exp(-4.5) / std::sqrt(2 * std::numbers::pi) /
                                std::erf(3 / std::numbers::sqrt2);
    for (int n : {6, 24, 25, 200}) {
        const auto uniform = moments(thickness_rule(300, {20, Law::uniform}, n));
        EXPECT_NEAR(uniform.mass, 1, 1e-14);
        EXPECT_NEAR(uniform.mean, 300, 1e-10);
        EXPECT_NEAR(uniform.deviation, 20, 1e-10);
        const auto normal = moments(thickness_rule(300, {20, Law::normal}, n));
        EXPECT_NEAR(normal.mass, 1, 1e-14);
        EXPECT_NEAR(normal.mean, 300, 1e-10);
        EXPECT_NEAR(normal.deviation, 20 * std::sqrt(kept), 1e-9);
    }
}

TEST(ThicknessRule, NormalLawIsCutAtZeroAndRenormalised) {
    // Mean 0 leaves the half-normal law, cut at three deviations.
    const double expected = 10 * std::sqrt(2 / std::numbers::pi) * (1 - std::exp(-4.5)) /
                            std::erf(3 / std::numbers::sqrt2);
    const auto half = moments(thickness_rule(0, {10, Law::normal}, 20));
    EXPECT_NEAR(half.mass, 1, 1e-14);
    EXPECT_NEAR(half.mean, expected, 1e-9);
    EXPECT_EQ(thickness_range(50, {100, Law::normal}).lo_nm, 0);
    EXPECT_EQ(thickness_range(50, {100, Law::uniform}).lo_nm, 0);
}

TEST(ThicknessRule, ItsMeanIsThatOfTheCutLaw) {
    for (const Law law : {Law::normal, Law::uniform}) {
        for (const double deviation : {0.0, 20.0, 34.0, 60.0, 100.0, 300.0}) {
            const ThicknessSpread spread{deviation, law};
            EXPECT_NEAR(mean_thickness_nm(100, spread),
                        moments(thickness_rule(100, spread, 24)).mean, 1e-9)
                << deviation;
        }
    }
    EXPECT_EQ(mean_thickness_nm(100, {30, Law::normal}), 100);
}

TEST(ThicknessRule, NodesStayInsideAndWeightsArePositive) {
    for (const Law law : {Law::normal, Law::uniform}) {
        const auto rule = thickness_rule(40, {30, law}, 24);
        const auto [lo, hi] = thickness_range(40, {30, law});
        ASSERT_EQ(rule.weights.size(), 24u);
        for (std::size_t i = 0; i < 24; ++i) {
            EXPECT_GT(rule.thickness_nm[i], lo);
            EXPECT_LT(rule.thickness_nm[i], hi);
            EXPECT_GT(rule.weights[i], 0);
        }
    }
}

TEST(ThicknessQuantile, SplitsTheLawIntoEqualFractions) {
    // Quantiles at the middles of many equal fractions have the moments of the law.
    for (const double mean_nm : {400.0, 60.0}) {  // the second is cut at zero
        for (const Law law : {Law::normal, Law::uniform}) {
            const ThicknessSpread spread{50, law};
            const ThicknessRule rule = thickness_rule(mean_nm, spread, 12);
            for (const int power : {1, 2, 3}) {
                double expected = 0, found = 0;
                for (std::size_t i = 0; i < rule.weights.size(); ++i) {
                    expected += rule.weights[i] * std::pow(rule.thickness_nm[i], power);
                }
                constexpr int kFractions = 4000;
                for (int i = 0; i < kFractions; ++i) {
                    const double t = thickness_quantile(mean_nm, spread, (i + 0.5) / kFractions);
                    found += std::pow(t, power) / kFractions;
                }
                EXPECT_NEAR(found, expected, 1e-4 * expected) << mean_nm << ' ' << power;
            }
            const auto [lo, hi] = thickness_range(mean_nm, spread);
            EXPECT_NEAR(thickness_quantile(mean_nm, spread, 0), lo, 1e-9);
            EXPECT_NEAR(thickness_quantile(mean_nm, spread, 1), hi, 1e-9);
        }
    }
    EXPECT_EQ(thickness_quantile(80, {}, 0.3), 80);
}

TEST(ThicknessRule, WithoutSpreadIsOneNode) {
    const auto rule = thickness_rule(80, {}, 7);
    EXPECT_EQ(rule.thickness_nm, std::vector<double>{80});
    EXPECT_EQ(rule.weights, std::vector<double>{1});
}

TEST(ThicknessArc, GivesTheCharacteristicFunctionOfTheLaw) {
    // E e^(i k d) of the uniform law is a sinc; k in 1/nm for up to 100 radians of spread.
    const ThicknessSpread spread{50, Law::uniform};
    const auto arc = thickness_arc(400, spread);
    const double half_nm = 50 * std::numbers::sqrt3;
    for (double k : {0.0, .01, .1, 1.0}) {
        std::complex<double> mean = 0;
        for (std::size_t i = 0; i < arc.weights.size(); ++i) {
            mean += arc.weights[i] * std::exp(std::complex<double>(0, k) * arc.thickness_nm[i]);
        }
        const double x = k * half_nm;
        const auto expected =
            (x == 0 ? 1 : std::sin(x) / x) * std::exp(std::complex<double>(0, 400 * k));
        EXPECT_LT(std::abs(mean - expected), 1e-7) << k;
    }
}

}  // namespace
}  // namespace nacre::optics
