#include "nacre/paint/orientation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"

namespace nacre::paint {
namespace {

double density(const std::vector<SlopeComponent>& components, double slope) {
    double sum = 0;
    for (const SlopeComponent& c : components) {
        const double a2 = c.alpha * c.alpha;
        sum += c.fraction * std::exp(-slope * slope / a2) / (std::numbers::pi * a2);
    }
    return sum;
}

double ggx_density(double alpha, double slope) {
    const double x = 1 + slope * slope / (alpha * alpha);
    return 1 / (std::numbers::pi * alpha * alpha * x * x);
}

TEST(Orientation, OfGgxIsAMixtureOfBeckmanns) {
    for (const double alpha : {0.02, 0.05, 0.1, 0.2, 0.35, 0.5}) {
        const auto components = ggx_mixture(alpha);
        double all = 0;
        for (const SlopeComponent& c : components) {
            all += c.fraction;
            EXPECT_GT(c.fraction, 0);
            EXPECT_TRUE(limits::kOrientationAlpha.contains(c.alpha)) << c.alpha;
        }
        EXPECT_NEAR(all, 1, 1e-12);
        EXPECT_LE(components.size(), 11u);
        for (double slope = 0; slope <= kGgxSlope; slope += 0.02 * kGgxSlope) {
            EXPECT_NEAR(density(components, slope) / ggx_density(alpha, slope), 1,
                        alpha <= 0.2 ? kGgxError : kWideGgxError)
                << alpha << ' ' << slope;
        }
        // The fraction beyond a slope of 1 would be alpha^2 / (1 + alpha^2); these are all that is
        // moved, to slopes of about 1.
        double moved = 0;
        for (double s = 0.005; s < 20; s += 0.01) {
            moved += 0.5 * 0.01 * 2 * std::numbers::pi * s *
                     std::abs(density(components, s) - ggx_density(alpha, s));
        }
        EXPECT_LT(moved, alpha * alpha + 0.005) << alpha;
    }
}

TEST(Orientation, OfBeckmannIsLeftAsItIs) {
    const auto components = beckmann_mixture({0.123});
    ASSERT_EQ(components.size(), 1u);
    EXPECT_EQ(components[0].fraction, 1);
    EXPECT_EQ(components[0].alpha, 0.123);
}

/// The density of tilts, per degree, of a law of slopes p(s): 2 pi s p(s) ds/dtilt.
template <class Density>
TabulatedTilts table_of(const Density& slopes, double step_deg, double last_deg) {
    TabulatedTilts table;
    for (double tilt = 0; tilt <= last_deg; tilt += step_deg) {
        const double t = tilt * std::numbers::pi / 180, s = std::tan(t);
        table.tilts.push_back({tilt, 1e3 * s * slopes(s) / std::pow(std::cos(t), 2)});
    }
    return table;
}

TEST(Orientation, OfATableOfBeckmannsIsFound) {
    for (const double alpha : {0.06, 0.2}) {
        const TiltFit fit = fit_tilts(table_of(
            [&](double s) { return std::exp(-s * s / (alpha * alpha)); }, alpha * 8, alpha * 180));
        EXPECT_LT(fit.residual, 0.008);
        for (double s = 0; s < 2 * alpha; s += 0.1 * alpha) {
            const double expected =
                std::exp(-s * s / (alpha * alpha)) / (std::numbers::pi * alpha * alpha);
            EXPECT_NEAR(density(fit.components, s) / expected, 1, 0.06) << alpha << ' ' << s;
        }
    }
}

TEST(Orientation, OfATableOfGgxIsFound) {
    const TiltFit fit = fit_tilts(table_of([](double s) { return ggx_density(0.1, s); }, 0.5, 60));
    EXPECT_LT(fit.residual, 0.005);
    for (double s = 0; s < 0.4; s += 0.02) {
        EXPECT_NEAR(density(fit.components, s) / ggx_density(0.1, s), 1, 0.1) << s;
    }
}

// Flakes that all lean by 10 deg are no mixture of laws that are highest for flat ones.
TEST(Orientation, OfARingIsRefused) {
    Orientation ring;
    ring.law = Orientation::Law::tabulated;
    ring.table = TabulatedTilts{{{9, 0}, {10, 1}, {11, 0}}};
    EXPECT_GT(fit_tilts(*ring.table).residual, 0.2);
    EXPECT_THAT(test::message_of<DomainError>([&] { beckmann_mixture(ring); }),
                testing::HasSubstr("must be at most 0.03"));
}

// P(tan^2 > t) = exp(-t / alpha^2) for Gaussian slopes, 1 / (1 + t / alpha^2) for GGX.
TEST(Orientation, HalfOfTheFlakesTiltLessThanTheMedian) {
    // python3 -c "import math; print(math.degrees(math.atan(.1*math.sqrt(math.log(2)))))"
    EXPECT_NEAR(median_tilt_deg({0.1}), 4.759210683456808, 1e-12);
    Orientation ggx{0.1};
    ggx.law = Orientation::Law::ggx;
    EXPECT_NEAR(median_tilt_deg(ggx), 5.710593137499643, 1e-12);  // atan(0.1)
    Orientation table;
    table.law = Orientation::Law::tabulated;
    table.table = table_of([](double s) { return std::exp(-s * s / 0.01); }, 0.5, 25);
    EXPECT_NEAR(median_tilt_deg(table), 4.76, 0.1);
}

}  // namespace
}  // namespace nacre::paint
