#include "nacre/fit/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/spectra/lab.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/fit.h"

namespace nacre::fit {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::pearl;
using testing::read;
using ::testing::SizeIs;
using testing::solid;

const std::string kFilm = "layer[0].flakes[0].coats[0].thickness_nm";
const std::string kAlpha = "layer[0].flakes[0].orientation.alpha";
const std::string kAmount = "layer[0].flakes[0].volume_fraction";
const std::string kScattering = "layer[0].pigment[0].scattering_per_mm";
const std::string kAbsorption = "layer[0].pigment[0].absorption_per_mm.max";

FitOptions with_starts(int starts) {
    FitOptions options;
    options.starts = starts;
    return options;
}

// docs/fit.md states a mean Delta E 2000 below 0.3 for exact standards; a descent that has
// converged ends at a hundredth of that.
constexpr double kExact_delta_e = 0.003;

// All colours of the first order lie between gold and violet: a single descent need not get past
// them.
TEST(Fit, FindsAFilmAcrossInterferenceColours) {
    const Fit found = fit(read(pearl(131)), FreeNumbers(pearl(70), {kFilm}, {}), with_starts(3));
    EXPECT_GT(found.at_start.mean_delta_e_2000, 10);
    EXPECT_LT(found.difference.mean_delta_e_2000, kExact_delta_e);
    EXPECT_NEAR(found.parameters[0].value, 131, 0.05);
    EXPECT_TRUE(found.converged) << found.ended;
    EXPECT_FALSE(found.parameters[0].at_lower_bound || found.parameters[0].at_upper_bound);
    EXPECT_EQ(found.recipe.layers[0].thickness_um, 15);  // not free: unchanged
    // Equal spectra match under any light.
    ASSERT_THAT(found.other_lights, SizeIs(2));
    EXPECT_LT(found.other_lights[1].second.max_delta_e_2000, 0.01);
}

TEST(Fit, FindsFilmOrientationAndAmountTogether) {
    paint::Recipe hidden = pearl(105);
    paint::set_parameter(hidden, kAlpha, 0.32);
    paint::set_parameter(hidden, kAmount, 0.03);
    const FreeNumbers numbers(pearl(80), {kFilm, kAlpha, kAmount}, {});
    const Fit found = fit(read(hidden), numbers, with_starts(2));
    EXPECT_LT(found.difference.mean_delta_e_2000, kExact_delta_e);
    EXPECT_NEAR(found.parameters[0].value, 105, 0.05);
    EXPECT_NEAR(found.parameters[1].value, 0.32, 1e-3);
    EXPECT_NEAR(found.parameters[2].value, 0.03, 1e-4);
}

// Numbers that paint::expanded() turns into species and pigments.
TEST(Fit, FindsTheAlphaOfGgxAndTheEdges) {
    paint::Recipe start = pearl();
    start.layers[0].flakes[0].orientation.law = paint::Orientation::Law::ggx;
    start.layers[0].flakes[0].edge_um = 0.2;
    const std::string edge = "layer[0].flakes[0].edge_um";
    paint::Recipe hidden = start;
    paint::set_parameter(hidden, kAlpha, 0.32);
    paint::set_parameter(hidden, edge, 0.45);
    const Fit found = fit(read(hidden), FreeNumbers(start, {kAlpha, edge}, {}), with_starts(1));
    // A little of each component's grid shows.
    EXPECT_LT(found.difference.mean_delta_e_2000, 10 * kExact_delta_e);
    EXPECT_NEAR(found.parameters[0].value, 0.32, 0.01);
    EXPECT_NEAR(found.parameters[1].value, 0.45, 0.02);
}

// Instruments that report L*a*b* alone are matched as well, through the same aperture.
TEST(Fit, TakesColoursWithoutSpectraThroughAnAperture) {
    measure::Conditions conditions;
    conditions.aperture = {1, 2};
    const std::vector<measure::Geometry> angles = {measure::in_plane(45, 15),
                                                   measure::in_plane(45, 110)};
    const measure::Measurement standard =
        testing::without_spectra(read(pearl(90), angles, conditions));
    const Fit found = fit(standard, FreeNumbers(pearl(80), {kFilm}, {}), with_starts(1));
    EXPECT_NEAR(found.parameters[0].value, 90, 0.05);
    EXPECT_EQ(found.colours.conditions.aperture, conditions.aperture);
    EXPECT_THAT(found.other_lights, IsEmpty());
}

// Files may hold spectra at some angles and L*a*b* at others.
TEST(Fit, TakesSpectraAtSomeAnglesOnly) {
    const std::vector<measure::Geometry> angles = {measure::in_plane(45, 15),
                                                   measure::in_plane(45, 110)};
    measure::Measurement standard = read(pearl(90), angles);
    standard.readings[1].reflectance_factor.clear();
    const Fit found = fit(standard, FreeNumbers(pearl(80), {kFilm}, {}), with_starts(1));
    EXPECT_NEAR(found.parameters[0].value, 90, 0.05);
    EXPECT_THAT(found.other_lights, IsEmpty());
}

TEST(Fit, FindsAmountsOfPigmentUnderSeveralLights) {
    paint::Recipe hidden = solid();
    paint::set_parameter(hidden, kScattering, 180);
    paint::set_parameter(hidden, kAbsorption, 35);
    FitOptions options = with_starts(2);
    options.target.illuminants = {spectra::Illuminant::D65, spectra::Illuminant::FL11};
    measure::Conditions by_day;
    by_day.observer = spectra::Observer::cie1931_2deg;
    const Fit found = fit(read(hidden, testing::six_angles(), by_day),
                          FreeNumbers(solid(), {kScattering, kAbsorption}, {}), options);
    EXPECT_NEAR(found.parameters[0].value, 180, 0.5);
    EXPECT_NEAR(found.parameters[1].value, 35, 0.1);
    EXPECT_EQ(found.standard.conditions.observer, spectra::Observer::cie1931_2deg);
}

TEST(Fit, FindsTheSizeAndTheAmountOfParticles) {
    const std::string diameter = "layer[0].pigment[0].diameter_nm",
                      amount = "layer[0].pigment[0].volume_fraction";
    paint::Recipe guess = solid();
    guess.layers[0].pigments = {{paint::PigmentParticles{
        paint::PigmentVolume{0.03}, {optics::find_material("Fe2O3"), 250, 0.2}}}};
    paint::Recipe hidden = guess;
    paint::set_parameter(hidden, diameter, 180);
    paint::set_parameter(hidden, amount, 0.04);
    const Fit found = fit(read(hidden), FreeNumbers(guess, {diameter, amount}, {}), with_starts(1));
    EXPECT_NEAR(found.parameters[0].value, 180, 1);
    EXPECT_NEAR(found.parameters[1].value, 0.04, 4e-4);
}

// The colour of a layer of pigment depends on optical depths alone: twice as thick and half as
// dense is the same.
TEST(Fit, SaysWhatColoursCannotTell) {
    const std::string thickness = "layer[0].thickness_um";
    const FreeNumbers numbers(solid(), {thickness, kScattering, kAbsorption}, {});
    const Fit found = fit(read(solid()), numbers, with_starts(1));
    EXPECT_LT(found.difference.mean_delta_e_2000, kExact_delta_e);
    for (const FittedParameter& parameter : found.parameters) {
        EXPECT_FALSE(parameter.standard_error) << parameter.number.bounds.key;
    }
    ASSERT_FALSE(found.tradeoffs.empty());
    const Tradeoff& tradeoff = found.tradeoffs[0];
    ASSERT_THAT(tradeoff.changes, SizeIs(3));
    double thickness_ratio = 0, scattering_ratio = 0;
    for (const Tradeoff::Change& change : tradeoff.changes) {
        if (change.key == thickness) thickness_ratio = change.to / change.from;
        if (change.key == kScattering) scattering_ratio = change.to / change.from;
    }
    EXPECT_NEAR(thickness_ratio * scattering_ratio, 1, 0.01);
    EXPECT_GT(std::abs(std::log(thickness_ratio)), std::log(1.2));
}

// Scattering at the lower end of its bounds: the derivative by its logarithm vanishes there, and
// would say that 300 per mm look the same.
TEST(Fit, TradeoffsEndWhereTheColoursDoNotFollow) {
    paint::Recipe clear = solid();
    paint::set_parameter(clear, kScattering, 0.01);
    const FreeNumbers numbers(clear, {kScattering}, {{kScattering, 0.01, 300}});
    const Fit found = fit(read(clear), numbers, with_starts(1));
    ASSERT_THAT(found.certainty.weak, SizeIs(1));
    ASSERT_THAT(found.tradeoffs, SizeIs(1));
    const Tradeoff& tradeoff = found.tradeoffs[0];
    EXPECT_GT(tradeoff.changes[0].to, 2 * tradeoff.changes[0].from);
    const auto seen_at = [&](double scattering) {
        paint::Recipe there = found.recipe;
        paint::set_parameter(there, kScattering, scattering);
        return measure::difference(found.colours, read(there));
    };
    double squares = 0;
    for (const auto& angle : seen_at(tradeoff.changes[0].to).angles) {
        squares += angle.delta_e_2000 * angle.delta_e_2000 / 6;
    }
    EXPECT_NEAR(std::sqrt(squares), tradeoff.rms_delta_e, 0.01);
    EXPECT_LE(tradeoff.rms_delta_e, found.equal_delta_e);
    EXPECT_GT(seen_at(1.3 * tradeoff.changes[0].to).mean_delta_e_2000, 0.8 * found.equal_delta_e);
    EXPECT_GT(seen_at(300).mean_delta_e_2000, 5);
}

TEST(Fit, FindsANumberThatIsZeroAtTheStartAndMayBeZero) {
    paint::Recipe start = solid(), hidden = solid();
    paint::set_parameter(start, kScattering, 0);
    paint::set_parameter(hidden, kScattering, 5);
    const FreeNumbers numbers(start, {kScattering}, {{kScattering, 0, 1000}});
    EXPECT_NEAR(fit(read(hidden), numbers, with_starts(2)).parameters[0].value, 5, 0.05);
    const Fit none = fit(read(start), numbers, with_starts(2));
    EXPECT_LT(none.parameters[0].value, 0.01);
    EXPECT_LT(none.difference.mean_delta_e_2000, kExact_delta_e);
}

TEST(Fit, SaysWhichNumberWouldHelp) {
    const Fit found = fit(read(pearl(131)), FreeNumbers(pearl(80), {kAmount}, {}), with_starts(1));
    EXPECT_FALSE(found.matched());
    ASSERT_FALSE(found.remedies.empty());
    const Remedy& best = found.remedies[0];
    EXPECT_EQ(best.key, kFilm);
    EXPECT_FALSE(best.widens);
    EXPECT_NEAR(best.value, 131, 5);
    EXPECT_LT(best.mean_delta_e_2000, 0.2 * found.difference.mean_delta_e_2000);
    for (const Remedy& other : found.remedies) {
        EXPECT_LE(other.mean_delta_e_2000, 0.9 * found.difference.mean_delta_e_2000);
        EXPECT_GE(other.mean_delta_e_2000, best.mean_delta_e_2000);
    }
}

// Alone, alpha goes to its bound, where no film looks like the standard.
TEST(Fit, SaysWhichNumberWouldHelpWhereTheFreeOneWentAstray) {
    const FreeNumbers numbers(pearl(80), {kAlpha}, {{kAlpha, 0.2, 0.9}});
    const Fit found = fit(read(pearl(131)), numbers, with_starts(1));
    ASSERT_FALSE(found.remedies.empty());
    EXPECT_EQ(found.remedies[0].key, kFilm);
    EXPECT_NEAR(found.remedies[0].value, 131, 5);
    EXPECT_LT(found.remedies[0].mean_delta_e_2000, 1);
}

TEST(Fit, SaysWhichBoundIsInTheWay) {
    const FreeNumbers numbers(pearl(80), {kFilm}, {{kFilm, 60, 105}});
    const Fit found = fit(read(pearl(120)), numbers, with_starts(2));
    ASSERT_FALSE(found.matched());
    ASSERT_TRUE(found.parameters[0].at_upper_bound);
    ASSERT_FALSE(found.remedies.empty());
    EXPECT_EQ(found.remedies[0].key, kFilm);
    EXPECT_TRUE(found.remedies[0].widens);
    EXPECT_EQ(found.remedies[0].bounds.lo, 60);
    EXPECT_EQ(found.remedies[0].bounds.hi, 315);
    EXPECT_NEAR(found.remedies[0].value, 120, 5);
}

TEST(Fit, AStandardOutOfReachLeavesItsResidual) {
    paint::Recipe green = solid();
    std::get<paint::PigmentCoefficients>(green.layers[0].pigments[0].body).absorption_per_mm =
        spectra::Spectrum({400, 480, 500, 570, 590, 700}, {60, 60, 2, 2, 60, 60});
    const FreeNumbers numbers(solid(), {kAbsorption}, {{kAbsorption, 30, 90}});
    FitOptions options = with_starts(2);
    const Fit found = fit(read(green), numbers, options);
    EXPECT_GT(found.difference.mean_delta_e_2000, 10);
    EXPECT_TRUE(found.parameters[0].at_lower_bound);  // the least red
    EXPECT_FALSE(found.ended.empty());
    EXPECT_GT(*found.certainty.noise_delta_e, 5);
    EXPECT_FALSE(found.matched());
    options.matched_delta_e = 100;
    const Fit contented = fit(read(green), numbers, options);
    EXPECT_TRUE(contented.matched());
    EXPECT_THAT(contented.remedies, IsEmpty());
}

// The film of the other three angles differs: with equal weights it would shift the fit.
TEST(Fit, FollowsTheWeights) {
    measure::Measurement standard = read(pearl(80));
    const measure::Measurement other = read(pearl(100));
    for (std::size_t i = 3; i < 6; ++i) standard.readings[i] = other.readings[i];
    FitOptions options = with_starts(1);
    for (std::size_t i = 3; i < 6; ++i) {
        options.target.weights[standard.readings[i].geometry.name] = 0;
    }
    const Fit found = fit(standard, FreeNumbers(pearl(85), {kFilm}, {}), options);
    EXPECT_NEAR(found.parameters[0].value, 80, 0.05);
    EXPECT_EQ(found.certainty.degrees_of_freedom, 3 * 3 - 1);  // three geometries of weight 0
}

TEST(Fit, DoesNotDependOnThreads) {
    const measure::Measurement standard = read(solid());
    paint::Recipe start = solid();
    paint::set_parameter(start, kScattering, 70);
    const FreeNumbers numbers(start, {kScattering, kAbsorption}, {});
    const auto values = [&](int threads) {
        const ThreadLimit limit(threads);
        const Fit found = fit(standard, numbers, with_starts(2));
        return std::pair{found.parameters[0].value, found.parameters[1].value};
    };
    EXPECT_EQ(values(1), values(2));
}

TEST(Fit, RefusesNumbersThatColoursDoNotShow) {
    const std::string diameter = "layer[0].flakes[0].diameter_um";
    EXPECT_THAT(message_of<DomainError>([&] {
                    fit(read(pearl()), FreeNumbers(pearl(), {kFilm, diameter}, {}));
                }),
                HasSubstr(diameter + ": does not change the colours"));
}

TEST(Fit, RefusesWhatTheStandardCannotTell) {
    const measure::Measurement bare = testing::without_spectra(read(pearl()));
    const FreeNumbers numbers(pearl(), {kFilm}, {});
    FitOptions options;
    options.target.illuminants = {spectra::Illuminant::A};
    EXPECT_THROW(fit(bare, numbers, options), DomainError);
    EXPECT_THROW(fit(measure::Measurement{}, numbers), DomainError);
    options = {};
    options.target.weights["45as999"] = 1;
    EXPECT_THROW(fit(bare, numbers, options), DomainError);
    EXPECT_THROW(fit(bare, numbers, with_starts(0)), DomainError);
}

TEST(Fit, StopsWhenAsked) {
    int asked = 0;
    double last = 0;
    const auto progress = [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return ++asked < 5;
    };
    EXPECT_THROW(fit(read(pearl(90)), FreeNumbers(pearl(), {kFilm}, {}), {}, progress), Stopped);
    EXPECT_EQ(asked, 5);
}

// In a descent Ceres would complain that its function cannot be evaluated any more.
TEST(Fit, PrintsNothingWhenItIsStopped) {
    const FreeNumbers numbers(solid(), {kScattering, kAbsorption}, {});
    paint::Recipe hidden = solid();
    paint::set_parameter(hidden, kScattering, 200);
    const measure::Measurement standard = read(hidden);
    ::testing::internal::CaptureStderr();
    for (const double moment : {0.17, 0.2, 0.25, 0.3, 0.35, 0.45, 0.55, 0.65}) {
        const auto progress = [&](double fraction) { return fraction < moment; };
        EXPECT_THROW(fit(standard, numbers, {}, progress), Stopped) << moment;
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

// Reported standard errors against the scatter of fits to many standards with known noise.

/// L*a*b* moved so that each component of the CIEDE2000 difference is normal with this deviation.
Vec3d disturbed(const Vec3d& lab, double sigma, Rng& rng) {
    Eigen::Matrix3d metric;
    constexpr double kStep = 1e-4;
    for (int c = 0; c < 3; ++c) {
        Vec3d moved = lab;
        moved[c] += kStep;
        const Vec3d v = spectra::delta_e_2000_vector(lab, moved);
        for (int r = 0; r < 3; ++r) metric(r, c) = v[r] / kStep;
    }
    std::normal_distribution<double> normal(0, sigma);
    const Eigen::Vector3d noise(normal(rng), normal(rng), normal(rng));
    const Eigen::Vector3d step = metric.inverse() * noise;
    return {lab[0] + step[0], lab[1] + step[1], lab[2] + step[2]};
}

// With the noise given, the errors over the standard errors are standard normal: the sum of their
// squares over n fits follows the chi-square law of n degrees of freedom, within whose two tails of
// 0.05 % it must not lie (scipy 1.11: chi2.ppf([0.0005, 0.9995], 24) = 7.45, 53.5). The noise
// estimated from the residuals is the true one, to 5 standard errors.
TEST(FitNoise, NumbersScatterAsTheirStandardErrorsSay) {
    const std::string scattering = "layer[0].pigment[0].scattering_per_mm",
                      absorption = "layer[0].pigment[0].absorption_per_mm.max";
    const paint::Recipe truth = testing::solid();
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
            const FittedParameter& fitted = found.parameters[p];
            // The reported error is by the estimated noise; scale it to the true one.
            const double error = fitted.standard_error.value() * kSigma / seen;
            squares[p] += std::pow((fitted.value - fitted.number.start) / error, 2);
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
