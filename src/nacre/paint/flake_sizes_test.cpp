#include "nacre/paint/flake_sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "nacre/core/error.h"

namespace nacre::paint {
namespace {

TEST(FlakeSizes, AreThoseOfACutNormalDistribution) {
    const FlakeSizes alike(20, 0), spread(20, 4);
    EXPECT_FLOAT_EQ(alike.diameter_um(123), 20);
    EXPECT_NEAR(alike.mean_area_um2(), std::numbers::pi * 100, 1e-3);
    double sum = 0, squares = 0;
    for (int i = 0; i < FlakeSizes::kSizes; ++i) {
        const double d = spread.diameter_um(i);
        sum += d / FlakeSizes::kSizes;
        squares += d * d / FlakeSizes::kSizes;
    }
    // A normal distribution cut off at 3 deviations has 0.98658 times the deviation (variance
    // 1 - 6 phi(3)/(1 - 2 Phi(-3)) = 0.97333); of each fraction only the middle counts.
    EXPECT_NEAR(sum, 20, 1e-6);
    EXPECT_NEAR(std::sqrt(squares - sum * sum), 4 * 0.98658, 0.02);
    EXPECT_NEAR(spread.mean_area_um2(), std::numbers::pi / 4 * squares, 1e-3);
    EXPECT_NEAR(spread.largest_um(), 20 + 4 * 2.716, 0.01);  // Phi(2.716) = 1 - (0.5/256 + Phi(-3))
    EXPECT_GT(FlakeSizes(20, 10).smallest_um(), 5);
    EXPECT_LT(FlakeSizes(20, 10).smallest_um(), 5.5);
    EXPECT_THROW(FlakeSizes(0, 0), DomainError);
    EXPECT_THROW(FlakeSizes(20, 21), DomainError);
}

/// Diameters with the volume of all flakes of that size, d^3.
std::vector<std::pair<double, double>> by_volume(const std::vector<SizePart>& parts) {
    std::vector<std::pair<double, double>> all;
    for (const SizePart& part : parts) {
        const double flakes = part.area_fraction / part.sizes.mean_area_um2();
        for (int i = 0; i < FlakeSizes::kSizes; ++i) {
            const double d = part.sizes.diameter_um(i);
            all.emplace_back(d, flakes * d * d * d);
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

double quantile(const std::vector<std::pair<double, double>>& volumes, double fraction) {
    double sum = 0;
    for (const auto& v : volumes) sum += v.second;
    double below = 0;
    for (const auto& [d, volume] : volumes) {
        if ((below += volume) >= fraction * sum) return d;
    }
    return volumes.back().first;
}

TEST(FlakeSizes, OfDataSheetsHaveTheirQuantiles) {
    const DiameterQuantiles sheets[] = {{9, 20, 40}, {5, 10, 22}, {18, 20, 22.5}, {6, 24, 50}};
    for (const DiameterQuantiles& sheet : sheets) {
        SCOPED_TRACE(testing::Message() << sheet.d10_um << ' ' << sheet.d90_um);
        const auto volumes = by_volume(size_parts(sheet));
        EXPECT_NEAR(quantile(volumes, 0.1) / sheet.d10_um, 1, kSizePartError);
        EXPECT_NEAR(quantile(volumes, 0.5) / sheet.d50_um, 1, kSizePartError);
        EXPECT_NEAR(quantile(volumes, 0.9) / sheet.d90_um, 1, kSizePartError);
    }
    EXPECT_THROW(size_parts({20, 20, 40}), DomainError);
    EXPECT_THROW(size_parts({0, 20, 40}), DomainError);
}

// A log-normal law by d^3 with median m and deviation s is one of median m exp(-k s^2) by d^(3-k);
// its mean of d by area is m exp(-s^2 + s^2/2). Cut at three deviations, as the law by d^3 is, the
// moment of e^(-j x) has the factor (Phi(3 + j s) - Phi(-3 + j s)).
TEST(FlakeSizes, OfDataSheetsHaveTheMomentsOfALogNormalLaw) {
    const double s = 0.5, m = 20, decile = std::exp(1.2815515655446004 * s);
    const std::vector<SizePart> parts = size_parts({m / decile, m, m * decile});
    ASSERT_GT(parts.size(), 1u);
    double area = 0, number = 0, cubes = 0;
    for (const SizePart& part : parts) {
        area += part.area_fraction;
        number += part.area_fraction / part.sizes.mean_area_um2();
        cubes += part.area_fraction * part.sizes.area_weighted_mean_um();
        EXPECT_LE(part.sizes.largest_um() / part.sizes.smallest_um(), 2.5);
    }
    EXPECT_NEAR(area, 1, 1e-12);
    const auto cut = [&](int j) {
        const auto phi = [](double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); };
        return std::exp(0.5 * j * j * s * s) * (phi(3 + j * s) - phi(-3 + j * s));
    };
    // Exact by construction: the mean area. The mean diameter has the error of the classes.
    EXPECT_NEAR(area / number / (std::numbers::pi / 4 * m * m * cut(1) / cut(3)), 1, 1e-5);
    EXPECT_NEAR(cubes / area / (m * cut(0) / cut(1)), 1, 5e-5);  // found: 6e-6
}

// The median alone is the log-normal law of ratio r: a deviation of ln r / 1.28155 about it.
TEST(FlakeSizes, OfAMedianAloneAreThoseOfATypicalPigment) {
    const double m = 18, r = kTypicalDecileRatio, s = std::log(r) / 1.2815515655446004;
    const DiameterQuantiles law = quantiles_of(MedianDiameter{m});
    EXPECT_EQ(law, (DiameterQuantiles{9, 18, 36}));
    EXPECT_EQ(quantiles_of(DiameterQuantiles{8, 18, 32}), (DiameterQuantiles{8, 18, 32}));
    const auto phi = [](double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); };
    const std::vector<SizePart> parts = size_parts(law);
    double number = 0, cubes = 0;
    for (const SizePart& part : parts) {
        number += part.area_fraction / part.sizes.mean_area_um2();
        cubes += part.area_fraction * part.sizes.area_weighted_mean_um();
    }
    // Moments of a law cut at three deviations, as above.
    const auto cut = [&](int j) {
        return std::exp(0.5 * j * j * s * s) * (phi(3 + j * s) - phi(-3 + j * s));
    };
    EXPECT_NEAR(1 / number / (std::numbers::pi / 4 * m * m * cut(1) / cut(3)), 1, 1e-5);
    EXPECT_NEAR(cubes / (m * cut(0) / cut(1)), 1, 5e-5);  // found: 9e-6
    // Ranges of a factor of 5 and 6 about the median hold what the header says of the volume.
    const auto volumes = by_volume(parts);
    EXPECT_NEAR(quantile(volumes, 0.1) / (m / r), 1, kSizePartError);
    EXPECT_NEAR(quantile(volumes, 0.9) / (m * r), 1, kSizePartError);
    for (const auto& [factor, percent] : {std::pair(5.0, 86.0), std::pair(6.0, 90.0)}) {
        double all = 0, within = 0;
        for (const auto& [d, volume] : volumes) {
            all += volume;
            if (std::abs(std::log(d / m)) < 0.5 * std::log(factor)) within += volume;
        }
        const double exact = 1 - 2 * phi(-0.5 * std::log(factor) / s);
        EXPECT_NEAR(100 * exact, percent, 0.5);
        EXPECT_NEAR(within / all, exact, 0.01);  // 0.3 % are cut off, and classes have a width
    }
}

// The limit of one size.
TEST(FlakeSizes, OfDataSheetsWithoutSpreadAreOneSize) {
    const std::vector<SizePart> parts = size_parts({20 - 1e-3, 20, 20 + 1e-3});
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_NEAR(parts[0].sizes.smallest_um(), 20, 5e-3);
    EXPECT_NEAR(parts[0].sizes.largest_um(), 20, 5e-3);
}

TEST(FlakeSizes, LoseTheAreaOfTheirRim) {
    const SizePart alike = without_rim(FlakeSizes(20, 0), 1);
    EXPECT_NEAR(alike.area_fraction, 0.81, 1e-12);  // (18/20)^2, hence a rim of 4 w/d - 4 w^2/d^2
    EXPECT_NEAR(alike.sizes.largest_um(), 18, 1e-5);
    const FlakeSizes spread(20, 8);
    const SizePart some = without_rim(spread, 3);  // the smallest are all rim
    ASSERT_LT(spread.smallest_um(), 6);
    EXPECT_NEAR(some.sizes.largest_um(), spread.largest_um() - 6, 1e-4);
    EXPECT_GT(some.sizes.smallest_um(), 0);
    EXPECT_EQ(without_rim(spread, 0).sizes, spread);
    EXPECT_THROW(without_rim(FlakeSizes(20, 0), 10), DomainError);
}

}  // namespace
}  // namespace nacre::paint
