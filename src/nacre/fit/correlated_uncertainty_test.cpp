#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/fit/uncertainty.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/fit.h"
#include "nacre/testing/paints.h"

// Uncertainties of colours where the numbers of the recipe are wrong together.

namespace nacre::fit {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

const std::string kUpper = "layer[0].thickness_um", kLower = "layer[1].thickness_um";
const std::string kSubstrate = "substrate.reflectance";
const std::string kFilmOfPearl = "layer[0].flakes[0].coats[0].thickness_nm";
const std::string kAlphaOfPearl = "layer[0].flakes[0].orientation.alpha";

/// A number of standard errors that a right estimate exceeds once in 3e5 tries.
constexpr double kStandardErrors = 4.7;

/// Thickness of 100 um, substrate of 0.4.
paint::Recipe grey() { return test::paint_of(1.5, {test::pigment_layer(0.5, 0.1, 0)}, 0.4); }

/// A reader whose only reading is a function of x and y: how far thickness and substrate are from
/// grey(), in 1 um and 0.01.
PaintReader function_reader(const std::function<Vec3d(double x, double y)>& lab) {
    return [lab](const paint::Recipe& recipe, const solver::SolverSettings*, SharedProgress&) {
        measure::Reading reading;
        reading.geometry = testing::six_angles()[0];
        reading.lab = lab(recipe.layers[0].thickness_um - 100,
                          (recipe.substrate_reflectance.values()[0] - 0.4) / 0.01);
        return PaintReading{{"made up", {}, {}, {reading}}, {}};
    };
}

Uncertainty of_function(const std::function<Vec3d(double x, double y)>& lab, double coefficient,
                        int samples = 0) {
    return uncertainty(grey(), {{kUpper, 1}, {kSubstrate, 0.01}}, function_reader(lab),
                       {samples, 1, {{{kUpper, kSubstrate}, coefficient}}});
}

TEST(CorrelatedUncertainty, OfALinearReadingIsJacobianTimesCovarianceTimesJacobian) {
    const Vec3d by_x{0.2, 0.4, -0.6}, by_y{0.1, -0.3, 0.4};
    const auto lab = [&](double x, double y) { return Vec3d{50, 30, 40} + x * by_x + y * by_y; };
    for (const double r : {0.7, -0.4, 0.0}) {
        const Uncertainty u = of_function(lab, r, 4000);
        const ReadingUncertainty& reading = u.readings[0];
        EXPECT_EQ(u.correlation, (std::vector<double>{1, r, r, 1}));
        const Spread &first = reading.first_order, &drawn = *reading.sampled;
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(reading.change[0][i], by_x[i], 1e-12);  // of each number by itself
            EXPECT_NEAR(reading.change[1][i], by_y[i], 1e-12);
            for (int j = 0; j < 3; ++j) {
                const double expected = by_x[i] * by_x[j] + by_y[i] * by_y[j] +
                                        r * (by_x[i] * by_y[j] + by_y[i] * by_x[j]);
                EXPECT_NEAR(first.covariance[i][j], expected, 1e-12);
                const double error = std::sqrt(
                    (first.covariance[i][i] * first.covariance[j][j] + expected * expected) /
                    u.samples);
                EXPECT_NEAR(drawn.covariance[i][j], expected, kStandardErrors * error + 1e-12);
            }
        }
        EXPECT_FALSE(u.first_order_fails());
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(reading.linearity[static_cast<std::size_t>(c)].beyond, 0, 1e-4) << c;
        }
        // Chroma and hue at (30, 40) follow from a and b: dC = 0.6 da + 0.8 db.
        const double cx = 0.6 * 0.4 - 0.8 * 0.6, cy = -0.6 * 0.3 + 0.8 * 0.4;
        EXPECT_NEAR(*first.chroma, std::sqrt(cx * cx + cy * cy + 2 * r * cx * cy), 1e-10);
        EXPECT_NEAR(*drawn.chroma / *first.chroma, 1, kStandardErrors / std::sqrt(2.0 * u.samples));
    }
}

// A correlation of 0 is none, to the last bit.
TEST(CorrelatedUncertainty, OfUncorrelatedNumbersIsThatOfIndependentOnes) {
    const auto lab = [](double x, double y) {
        return Vec3d{50 + x + 0.1 * x * y, 20 + 0.3 * y * y, 10 - std::sin(x + y)};
    };
    const Uncertainty zero = of_function(lab, 0, 50);
    const Uncertainty none =
        uncertainty(grey(), {{kUpper, 1}, {kSubstrate, 0.01}}, function_reader(lab), {50, 1, {}});
    EXPECT_TRUE(none.correlation.empty());
    const ReadingUncertainty &a = zero.readings[0], &b = none.readings[0];
    EXPECT_EQ(a.first_order.covariance, b.first_order.covariance);
    EXPECT_EQ(a.first_order.hue_deg, b.first_order.hue_deg);
    EXPECT_EQ(a.sampled->covariance, b.sampled->covariance);
    EXPECT_EQ(a.mean_shift, b.mean_shift);
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
        EXPECT_EQ(a.linearity[q].beyond, b.linearity[q].beyond);
    }
    EXPECT_EQ(variance_fractions(a.change, zero.correlation), variance_fractions(b.change));
}

TEST(CorrelatedUncertainty, SharesAreCovariancesWithTheReadingAndSumToOne) {
    const auto lab = [](double x, double y) { return Vec3d{50 + 2 * x - y, 20 + x, 10}; };
    struct Case {
        double r, x, y;  // shares of L*
    };
    for (const auto& [r, x, y] : {Case{0, 0.8, 0.2}, Case{0.5, 1, 0},
                                  Case{0.9, 2.2 / 1.4, -0.8 / 1.4}, Case{-1, 2.0 / 3, 1.0 / 3}}) {
        const Uncertainty u = of_function(lab, r);
        const std::vector<double> of_l =
            variance_fractions(u.readings[0].change_of(Quantity::lightness), u.correlation);
        EXPECT_NEAR(of_l[0], x, 1e-10) << r;
        EXPECT_NEAR(of_l[1], y, 1e-10) << r;
        // Of L*, a* and b* together: a* has the variance 1, all of it from x.
        const double variance = 5 - 4 * r;
        const std::vector<double> of_all = variance_fractions(u.readings[0].change, u.correlation);
        EXPECT_NEAR(of_all[0], (x * variance + 1) / (variance + 1), 1e-10);
        EXPECT_NEAR(of_all[0] + of_all[1], 1, 1e-12);
    }
}

// For normal x and y of correlation r the variance of x y is 1 + r^2, its mean r, that of x^2 is 2,
// and cov(x^2, x y) = 2 r.                                                  [isserlis-1918]
TEST(CorrelatedUncertainty, NextTermsAreThoseOfAQuadraticForm) {
    constexpr double kA = 0.8, kB = -0.5, kSquare = 0.3, kProduct = 0.4;
    const auto lab = [](double x, double y) {
        return Vec3d{50 + kA * x + kB * y + kSquare * x * x + kProduct * x * y, 20, 10};
    };
    for (const double r : {-0.9, -0.3, 0.0, 0.6, 1.0}) {
        const Uncertainty u = of_function(lab, r, 8000);
        const ReadingUncertainty& reading = u.readings[0];
        const double first = kA * kA + kB * kB + 2 * r * kA * kB;
        const double next =
            2 * kSquare * kSquare + kProduct * kProduct * (1 + r * r) + 4 * r * kSquare * kProduct;
        EXPECT_NEAR(reading.first_order.lab()[0], std::sqrt(first), 1e-9);
        EXPECT_NEAR(reading.linearity[0].beyond, std::sqrt(next / first), 1e-6) << r;
        EXPECT_NEAR(reading.mean_shift[0], kSquare + r * kProduct, 1e-9) << r;
        EXPECT_EQ(reading.linearity[0].fails, next > 0.1 * first) << r;
        EXPECT_FALSE(reading.linearity[1].fails);
        EXPECT_NEAR(reading.sampled->mean[0], 50 + kSquare + r * kProduct,
                    kStandardErrors * std::sqrt((first + next) / u.samples));
        // The kurtosis of a quadratic form is at most 15.
        EXPECT_NEAR(reading.sampled->covariance[0][0] / (first + next), 1,
                    kStandardErrors * std::sqrt(14.0 / u.samples))
            << r;
    }
}

TEST(CorrelatedUncertainty, OfACoefficientOfOneIsThatOfOneNumber) {
    // Quadratic: central differences are exact, whatever their steps.
    const auto lab = [](double x, double y) {
        return Vec3d{50 + x - 0.5 * y + 0.2 * x * y, 20 + 0.2 * x + 0.1 * y + 0.05 * x * x, 10 + y};
    };
    for (const double r : {1.0, -1.0}) {
        const Uncertainty two = of_function(lab, r, 200);
        // y follows from x.
        const Uncertainty one =
            uncertainty(grey(), {{kUpper, 1}},
                        function_reader([&](double x, double) { return lab(x, r * x); }), {200, 1});
        const ReadingUncertainty &a = two.readings[0], &b = one.readings[0];
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(a.mean_shift[i], b.mean_shift[i], 1e-9);
            EXPECT_NEAR(a.sampled->mean[i], b.sampled->mean[i], 1e-9);
            for (int j = 0; j < 3; ++j) {
                EXPECT_NEAR(a.first_order.covariance[i][j], b.first_order.covariance[i][j], 1e-9);
                EXPECT_NEAR(a.sampled->covariance[i][j], b.sampled->covariance[i][j], 1e-9);
            }
        }
        for (std::size_t q = 0; q < kQuantities.size(); ++q) {
            EXPECT_NEAR(a.linearity[q].beyond, b.linearity[q].beyond, 1e-5) << q;
        }
        EXPECT_NEAR(*a.first_order.hue_deg, *b.first_order.hue_deg, 1e-6);
    }
    const Uncertainty cancelled = of_function(
        [](double x, double y) {
            return Vec3d{50 + x + y, 20, 10};
        },
        -1, 100);
    EXPECT_NEAR(cancelled.readings[0].first_order.lab()[0], 0, 1e-9);
    EXPECT_NEAR(cancelled.readings[0].sampled->lab()[0], 0, 1e-7);
    EXPECT_EQ(variance_fractions(cancelled.readings[0].change, cancelled.correlation),
              (std::vector<double>{0, 0}));
    EXPECT_FALSE(cancelled.first_order_fails());
}

// A layer sprayed in two: what one gun gives too much of counts twice, and what the second half lacks
// of what the first has too much does not count at all.
TEST(CorrelatedUncertainty, OfALayerInTwoHalvesIsThatOfTheWhole) {
    const auto reader = solution_reader({450, 550, 650}, {testing::six_angles()[2]}, {}, false);
    const paint::Layer half = test::pigment_layer(0.8, 0.4, 0);
    const paint::Recipe halves = test::paint_of(1.5, {half, half}, 0.6);
    paint::Layer both = half;
    both.thickness_um *= 2;
    const Uncertainty whole = uncertainty(test::paint_of(1.5, {both}, 0.6), {{kUpper, 8}}, reader);
    const auto of_halves = [&](double r) {
        return uncertainty(halves, {{kUpper, 4}, {kLower, 4}}, reader,
                           {0, 0, {{{kUpper, kLower}, r}}});
    };
    const Uncertainty together = of_halves(1), against = of_halves(-1), apart = of_halves(0);
    const Spread& expected = whole.readings[0].first_order;
    ASSERT_GT(expected.lab()[0], 0.1);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(together.readings[0].first_order.lab()[i], expected.lab()[i], 1e-4);
        EXPECT_NEAR(against.readings[0].first_order.lab()[i], 0, 1e-4);
        EXPECT_NEAR(apart.readings[0].first_order.lab()[i], expected.lab()[i] / std::sqrt(2), 1e-4);
        EXPECT_NEAR(together.readings[0].mean_shift[i], whole.readings[0].mean_shift[i], 1e-4);
    }
    EXPECT_NEAR(together.readings[0].first_order.reflectance_factor[1],
                expected.reflectance_factor[1], 1e-6);
    // In which are third derivatives, over steps that differ by a factor of two.
    EXPECT_NEAR(together.readings[0].linearity[0].beyond, whole.readings[0].linearity[0].beyond,
                0.1 * whole.readings[0].linearity[0].beyond);
    EXPECT_NEAR(variance_fractions(together.readings[0].change, together.correlation)[0], 0.5,
                1e-4);
}

// Half of a joint normal law: where one number is cut off at its own value, the mean of the other
// moves by r sqrt(2/pi) of its deviation.
TEST(CorrelatedUncertainty, DrawsAreCutOffTogether) {
    paint::Recipe recipe = grey();
    recipe.substrate_reflectance = 0.0;
    const double r = 0.8;
    const auto lab = [](double x, double) { return Vec3d{50 + x, 20, 10}; };
    const Uncertainty u = uncertainty(recipe, {{kUpper, 1}, {kSubstrate, 0.01}},
                                      function_reader(lab), {4000, 2, {{{kUpper, kSubstrate}, r}}});
    EXPECT_NEAR(u.redrawn, 4000, kStandardErrors * std::sqrt(2 * 4000));  // of a fair coin
    EXPECT_NEAR(u.readings[0].sampled->mean[0], 50 + r * std::sqrt(2 / std::numbers::pi),
                kStandardErrors / std::sqrt(4000.0));
    EXPECT_NEAR(u.readings[0].sampled->covariance[0][0], 1 - r * r * 2 / std::numbers::pi,
                kStandardErrors * std::sqrt(2.0 / 4000));
}

// Recipes drawn here and solved on their own.
TEST(CorrelatedUncertainty, AgreesWithRecipesDrawnAtRandom) {
    constexpr int kDraws = 400;
    constexpr double kFilm_nm = 0.5, kOfAlpha = 0.003, kCoefficient = -0.8;
    const paint::Recipe recipe = testing::pearl(95);
    const auto reader =
        solution_reader({400, 450, 500, 550, 600, 650, 700}, {testing::six_angles()[2]}, {}, false);
    const Uncertainty u =
        uncertainty(recipe, {{kFilmOfPearl, kFilm_nm}, {kAlphaOfPearl, kOfAlpha}}, reader,
                    {0, 0, {{{kFilmOfPearl, kAlphaOfPearl}, kCoefficient}}});
    const Uncertainty independent =
        uncertainty(recipe, {{kFilmOfPearl, kFilm_nm}, {kAlphaOfPearl, kOfAlpha}}, reader);
    std::mt19937_64 rng(20261126);
    std::normal_distribution<double> normal(0, 1);
    std::vector<paint::Recipe> drawn(kDraws, recipe);
    for (paint::Recipe& one : drawn) {
        const double film = normal(rng), other = normal(rng);
        paint::set_parameter(one, kFilmOfPearl, 95 + kFilm_nm * film);
        paint::set_parameter(
            one, kAlphaOfPearl,
            0.25 + kOfAlpha *
                       (kCoefficient * film + std::sqrt(1 - kCoefficient * kCoefficient) * other));
    }
    const Progress nobody_asks;
    SharedProgress work(nobody_asks, kDraws);
    std::vector<Vec3d> lab(kDraws);
    parallel_for(0, kDraws, [&](std::size_t i) {
        lab[i] = reader(drawn[i], nullptr, work).measurement.readings[0].lab;
    });
    const ReadingUncertainty& reading = u.readings[0];
    bool matters = false;
    for (int c = 0; c < 3; ++c) {
        double mean = 0, variance = 0;
        for (const Vec3d& one : lab) mean += one[c] / kDraws;
        for (const Vec3d& one : lab) variance += std::pow(one[c] - mean, 2) / (kDraws - 1);
        const double sd = reading.first_order.lab()[c];
        const double beyond = reading.linearity[static_cast<std::size_t>(c)].beyond;
        // As uncertainty_test.cpp: the next terms, and as much again for those of higher order.
        EXPECT_NEAR(std::sqrt(variance), sd,
                    kStandardErrors * sd / std::sqrt(2.0 * kDraws) + beyond * beyond * sd + 2e-3)
            << c;
        EXPECT_NEAR(mean, reading.reading.lab[c] + reading.mean_shift[c],
                    kStandardErrors * sd / std::sqrt(kDraws) + 2e-3)
            << c;
        matters = matters || std::abs(independent.readings[0].first_order.lab()[c] - sd) >
                                 2 * kStandardErrors * sd / std::sqrt(2.0 * kDraws);
    }
    EXPECT_TRUE(matters);  // the draws would tell one from the other
}

TEST(CorrelatedUncertainty, RefusesCoefficientsThatCannotBe) {
    const auto lab = [](double, double) { return Vec3d{50, 20, 10}; };
    const auto message = [&](const std::vector<paint::ParameterCorrelation>& correlations) {
        return message_of<DomainError>([&] {
            uncertainty(grey(), {{kUpper, 1}}, function_reader(lab), {0, 0, correlations});
        });
    };
    EXPECT_THAT(message({{{kUpper, kSubstrate}, 0.5}}), HasSubstr("has no standard deviation"));
    EXPECT_THAT(message({{{kUpper, kUpper}, 0.5}}), HasSubstr("named twice"));
}

}  // namespace
}  // namespace nacre::fit
