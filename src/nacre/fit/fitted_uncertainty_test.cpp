#include "nacre/fit/fitted_uncertainty.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/fit/uncertainty.h"
#include "nacre/spectra/lab.h"
#include "nacre/testing/fit.h"

namespace nacre::fit {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The sum over all readings of the variances of the three components of Delta E 2000.
double variance_of_delta_e(const Uncertainty& u) {
    double sum = 0;
    for (const ReadingUncertainty& r : u.readings) {
        constexpr double kStep = 1e-4;
        Vec3d by[3];  // of Delta E with L*, a*, b*
        for (int c = 0; c < 3; ++c) {
            Vec3d beside = r.reading.lab;
            beside[c] += kStep;
            by[c] = spectra::delta_e_2000_vector(r.reading.lab, beside) / kStep;
        }
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                sum += r.first_order.covariance[i][j] * dot(by[i], by[j]);
            }
        }
    }
    return sum;
}

// The covariance of the readings that a least-squares fit of p numbers implies for its own residuals is
// s^2 J (J^T J)^-1 J^T, the noise s^2 times a projection of rank p, whose trace is p s^2: whatever the
// errors of the single numbers, if their correlations are carried along.
TEST(FittedUncertainty, MovesTheFittedReadingsByTheNoise) {
    constexpr double kNoise = 0.05;
    const paint::Recipe hidden = testing::pearl(95);
    FitOptions options;
    options.starts = 1;
    options.noise_delta_e = kNoise;
    const std::vector<std::string> keys = {"layer[0].flakes[0].coats[0].thickness_nm",
                                           "layer[0].flakes[0].volume_fraction",
                                           "layer[0].flakes[0].orientation.alpha"};
    const Fit found =
        fit(testing::read(hidden), FreeNumbers(testing::pearl(90), keys, {}), options);
    ASSERT_LT(found.difference.mean_delta_e_2000, 0.01);
    const FittedUncertainty known = fitted_uncertainty(found);
    ASSERT_THAT(known.deviations, SizeIs(3));
    ASSERT_THAT(known.correlations, SizeIs(3));
    EXPECT_THAT(known.not_determined, IsEmpty());
    double greatest = 0;
    for (const paint::ParameterCorrelation& c : known.correlations) {
        greatest = std::max(greatest, std::abs(c.coefficient));
    }
    ASSERT_GT(greatest, 0.3);

    const auto reader =
        solution_reader(spectra::default_wavelengths_nm(), testing::six_angles(), {}, false);
    const double expected = 3 * kNoise * kNoise;
    const Uncertainty u =
        uncertainty(found.recipe, known.deviations, reader, {0, 0, known.correlations});
    // Derivatives over other steps than the fit's, and deviations of four digits.
    EXPECT_NEAR(variance_of_delta_e(u) / expected, 1, 0.03);
    const Uncertainty apart = uncertainty(found.recipe, known.deviations, reader);
    EXPECT_GT(std::abs(variance_of_delta_e(apart) / expected - 1), 0.15);
}

TEST(FittedUncertainty, LeavesOutWhatTheColoursDoNotDetermine) {
    Fit found;
    found.recipe = testing::pearl();
    const auto add = [&](const std::string& key, std::optional<double> error) {
        FittedParameter fitted;
        fitted.number.bounds = {key, 0, 1};
        fitted.standard_error = error;
        found.parameters.push_back(fitted);
    };
    add("layer[0].thickness_um", 0.123456);
    add("ior", std::nullopt);
    add("layer[0].flakes[0].volume_fraction", 0.001);
    found.certainty.correlation = {1, 0.9, 0.12345678, 0.9, 1, -0.5, 0.12345678, -0.5, 1};
    const FittedUncertainty known = fitted_uncertainty(found);
    EXPECT_THAT(
        known.deviations,
        ElementsAre(paint::ParameterDeviation{"layer[0].thickness_um", 0.1235},
                    paint::ParameterDeviation{"layer[0].flakes[0].volume_fraction", 0.001}));
    EXPECT_THAT(known.correlations,
                ElementsAre(paint::ParameterCorrelation{
                    {"layer[0].thickness_um", "layer[0].flakes[0].volume_fraction"}, 0.123457}));
    EXPECT_THAT(known.not_determined, ElementsAre("ior"));
}

}  // namespace
}  // namespace nacre::fit
