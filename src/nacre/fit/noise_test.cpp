// Whether errors are as large as reported: many standards with noise of a known size.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "nacre/core/rng.h"
#include "nacre/fit/test_support.h"
#include "nacre/spectra/delta_e.h"

namespace nacre::fit {
namespace {

/// L*a*b* moved so that each component of the CIEDE2000 difference is normal with this deviation.
spectra::Vec3 disturbed(const spectra::Vec3& lab, double sigma, Rng& rng) {
    Eigen::Matrix3d metric;
    constexpr double kStep = 1e-4;
    for (int c = 0; c < 3; ++c) {
        spectra::Vec3 moved = lab;
        moved[c] += kStep;
        const spectra::Vec3 v = spectra::delta_e_2000_vector(lab, moved);
        for (int r = 0; r < 3; ++r) metric(r, c) = v[r] / kStep;
    }
    std::normal_distribution<double> normal(0, sigma);
    const Eigen::Vector3d noise(normal(rng), normal(rng), normal(rng));
    const Eigen::Vector3d step = metric.inverse() * noise;
    return {lab[0] + step[0], lab[1] + step[1], lab[2] + step[2]};
}

// With the noise given, the errors over the standard errors are standard normal: the sum of their
// squares over n fits follows the chi-square law of n degrees of freedom, within whose two tails of
// 0.05 % it must not lie (scipy 1.11: chi2.ppf([0.0005, 0.9995], 24) = 7.45, 53.5). The noise that
// the fits see in their residuals is the one that was put in, to 5 standard errors.
TEST(FitNoise, NumbersScatterAsTheirStandardErrorsSay) {
    const std::string scattering = "layer[0].pigment[0].scattering_per_mm",
                      absorption = "layer[0].pigment[0].absorption_per_mm.max";
    const layers::Recipe truth = testing::solid();
    const FreeNumbers numbers(truth, {scattering, absorption}, {});
    const measure::Measurement exact = testing::without_spectra(testing::read(truth));
    constexpr int kFits = 24;
    constexpr double kSigma = 0.1;
    Rng rng(42);
    FitOptions options;
    options.starts = 1;
    double squares[2] = {}, variance = 0;
    for (int i = 0; i < kFits; ++i) {
        measure::Measurement standard = exact;
        for (measure::Reading& reading : standard.readings) {
            reading.lab = disturbed(reading.lab, kSigma, rng);
        }
        const Fit found = fit(standard, numbers, options);
        const double seen = found.certainty.noise_delta_e.value();
        variance += seen * seen / kFits;
        for (int p = 0; p < 2; ++p) {
            const Estimate& e = found.estimates[p];
            // The reported error rests on the noise seen; restate it for that put in.
            const double error = e.standard_error.value() * kSigma / seen;
            squares[p] += std::pow((e.value - e.number.start) / error, 2);
        }
    }
    for (double sum : squares) {
        EXPECT_GT(sum, 7.45);
        EXPECT_LT(sum, 53.5);
    }
    const int freedom = 3 * 6 - 2;
    EXPECT_NEAR(variance / (kSigma * kSigma), 1, 5 * std::sqrt(2.0 / (freedom * kFits)));
}

}  // namespace
}  // namespace nacre::fit
