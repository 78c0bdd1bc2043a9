#include "nacre/measure/sparkle_measurement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/testing/errors.h"

namespace nacre::measure {
namespace {

using nacre::test::message_of;

// Pictures with given pixels.

PanelPicture uniform_picture(int side, double pixel_mm, double y) {
    PanelPicture picture{side, side, pixel_mm, {}};
    picture.xyz.assign(3 * picture.pixel_count(), static_cast<float>(y));
    return picture;
}

void set_y(PanelPicture& picture, int x, int y, double value) {
    picture.xyz[3 * (static_cast<std::size_t>(y) * picture.width + x) + 1] =
        static_cast<float>(value);
}
void add_y(PanelPicture& picture, int x, int y, double value) {
    picture.xyz[3 * (static_cast<std::size_t>(y) * picture.width + x) + 1] +=
        static_cast<float>(value);
}

/// Of mean 0 and variance 1.                                        [box-muller-1958]
double normal(Rng& rng) {
    const double u = rng.uniform_double(), v = rng.uniform_double();
    return std::sqrt(-2 * std::log1p(-u)) * std::cos(2 * std::numbers::pi * v);
}

// colour-science 0.4.7, contrast_sensitivity_function_Barten1999(u, sigma, X_0, E) with sigma and E
// from pupil_diameter_Barten1999(L, X_0), sigma_Barten1999(0.5/60, 0.08/60, d) and
// retinal_illuminance_Barten1999(L, d); all else as it stands there.
TEST(ContrastSensitivity, MatchesAnIndependentImplementation) {
    const struct {
        double luminance, field_deg, frequency, sensitivity;
    } cases[] = {{100, 11.4, 0.5, 243.9532543563694}, {100, 11.4, 4, 674.5861124292278},
                 {100, 11.4, 20, 108.97025452446285}, {100, 11.4, 50, 0.7768302151391533},
                 {0.5, 2, 4, 79.48385929214258},      {0.5, 2, 20, 9.045791983805016},
                 {3e4, 40, 0.5, 329.3604298058985},   {3e4, 40, 20, 173.53129406717028}};
    for (const auto& c : cases) {
        EXPECT_NEAR(contrast_sensitivity(c.frequency, c.luminance, c.field_deg) / c.sensitivity, 1,
                    kContrastSensitivityError)
            << c.luminance << " cd/m^2, " << c.frequency << " per deg";
    }
    EXPECT_NEAR(pupil_diameter_mm(100, 11.4), 3.9541296707276663, 1e-12);
    EXPECT_NEAR(eye_blur_deg(pupil_diameter_mm(0.5, 2)), 0.012980578653167521, 1e-12);
}

TEST(ContrastSensitivity, NothingIsSeenInTheDarkOrWithoutAPattern) {
    EXPECT_EQ(contrast_sensitivity(4, 0, 10), 0);
    EXPECT_EQ(contrast_sensitivity(0, 100, 10), 0);
    EXPECT_NEAR(pupil_diameter_mm(0, 10), 8, 1e-12);
}

// A star of magnitude m gives 2.54e-6 lx 10^(-0.4 m).
double limiting_magnitude(double sky_cd_m2) {
    return -2.5 * std::log10(point_threshold_lx(sky_cd_m2) / 2.54e-6);
}

// Common experience: stars of magnitude 6 to 7, less 0.3 for the atmosphere, from a dark site,
// whose sky has 60 nL; Venus at magnitude -4.5, and no star, in a bright blue sky.
TEST(PointThreshold, ShowsTheStarsThatAreSeen) {
    const double dark_sky = 60e-5 / 3.14159, blue_sky = 3000;
    EXPECT_GT(limiting_magnitude(dark_sky), 6.3);
    EXPECT_LT(limiting_magnitude(dark_sky), 7.3);
    EXPECT_GT(limiting_magnitude(blue_sky), -4.5);
    EXPECT_LT(limiting_magnitude(blue_sky), -1.5);  // Sirius
}

TEST(PointThreshold, FollowsWebersLawInBrightLight) {
    const double ratio = point_threshold_lx(2e6) / point_threshold_lx(1e6);
    EXPECT_NEAR(ratio, 2, 0.005);
    EXPECT_LT(point_threshold_lx(2) / point_threshold_lx(1), 1.6);
}

TEST(PointThreshold, RisesWithTheBackground) {
    double before = point_threshold_lx(0);
    EXPECT_GT(before, 0);
    for (double background = 1e-6; background < 1e5; background *= 1.1) {
        const double now = point_threshold_lx(background);
        EXPECT_GT(now, before) << background;
        EXPECT_LT(now, 1.2 * before) << background;  // jumps up where photopic vision begins
        before = now;
    }
}

TEST(Viewing, OutsideItsRangeIsRefused) {
    EXPECT_THROW(check({.distance_mm = 10}), DomainError);
    EXPECT_THROW(check({.illuminance_lx = 0}), DomainError);
    EXPECT_THROW(check({.distance_mm = std::nan("")}), DomainError);
}

using ::testing::HasSubstr;

constexpr Viewing kViewing{500, 1000};
constexpr double kPixel_mm = 0.025, kBackground = 0.2;

// The excess of Y of one pixel over kBackground at which it has this visibility: the illuminance at
// the eye over the threshold.
double excess_of(double visibility, double pixel_mm = kPixel_mm, const Viewing& v = kViewing) {
    const double lux_per_y =
        v.illuminance_lx / std::numbers::pi * pixel_mm * pixel_mm / (v.distance_mm * v.distance_mm);
    return visibility * point_threshold_lx(luminance_cd_m2(v, kBackground)) / lux_per_y;
}

TEST(Sparkle, AnEvenPanelHasNone) {
    for (double y : {0.0, 0.04, 0.7312345, 12.0}) {
        const Sparkle s = sparkle(uniform_picture(160, kPixel_mm, y));
        EXPECT_EQ(s.density_per_cm2.value, 0);
        EXPECT_EQ(s.area_fraction.value, 0);
        EXPECT_EQ(s.sparkle_per_cm2.value, 0);
        EXPECT_EQ(s.pixel_contrast.value, 0);
        EXPECT_FALSE(s.intensity);
        EXPECT_FALSE(s.contrast);
        EXPECT_EQ(s.background.y, static_cast<float>(y));
    }
}

// Spots are far apart: 1 mm is 13 times the eye's blur.
TEST(Sparkle, SpotsOfKnownContrastAreCountedExactly) {
    const double painted[] = {0.5, 0.97, 1.03, 3, 10, 20};
    PanelPicture picture = uniform_picture(480, kPixel_mm, kBackground);
    double seen = 0, decades = 0;
    int n = 0;
    for (int y = 60; y < 420; y += 40) {
        for (int x = 60; x < 420; x += 40, ++n) {
            const double v = painted[n % 6];
            set_y(picture, x, y, kBackground + excess_of(v));
            if (v < 1) continue;
            seen += 1;
            decades += std::log10(v);
        }
    }
    const Sparkle s = sparkle(picture, kViewing);
    EXPECT_DOUBLE_EQ(s.density_per_cm2.value * s.area_mm2 / 100, seen);
    // Pixels are kept in single precision; the blur of a spot at its neighbour is exp(-80).
    const double mean = std::pow(10, decades / seen);
    EXPECT_NEAR(s.intensity->value, mean, 1e-5 * mean);
    EXPECT_NEAR(s.sparkle_per_cm2.value, decades / s.area_mm2 * 100,
                1e-5 * s.sparkle_per_cm2.value);
    EXPECT_NEAR(s.contrast->value, s.background.threshold * s.intensity->value / kBackground, 1e-4);
}

TEST(Sparkle, ASpotIsAsVisibleInSmallPixelsAsInLargeOnes) {
    for (double pixel_mm : {0.01, 0.025, 0.05}) {
        const int side = static_cast<int>(std::lround(2.5 / pixel_mm));
        PanelPicture picture = uniform_picture(side, pixel_mm, kBackground);
        set_y(picture, side / 2, side / 2, kBackground + excess_of(5, pixel_mm));
        const Sparkle s = sparkle(picture, kViewing);
        ASSERT_TRUE(s.intensity) << pixel_mm;
        EXPECT_NEAR(s.intensity->value, 5, 1e-3) << pixel_mm;
    }
}

TEST(Sparkle, VisibilityFallsWithTheSquareOfTheDistance) {
    PanelPicture picture = uniform_picture(240, kPixel_mm, kBackground);
    set_y(picture, 120, 120, kBackground + excess_of(16));
    const double near = sparkle(picture, {500, 1000}).intensity->value;
    const double far = sparkle(picture, {1000, 1000}).intensity->value;
    EXPECT_NEAR(near / far, 4, 1e-3);
}

TEST(Sparkle, TwoSpotsAreToldApartBeyondTwiceTheBlur) {
    const double blur =
        retinal_picture(uniform_picture(120, kPixel_mm, kBackground), kViewing).blur_mm;
    const int twice = static_cast<int>(std::lround(2 * blur / kPixel_mm));
    for (int distance : {twice - 2, twice + 2}) {
        PanelPicture picture = uniform_picture(161, kPixel_mm, kBackground);
        set_y(picture, 80, 80, kBackground + excess_of(10));
        set_y(picture, 80 + distance, 80, kBackground + excess_of(10));
        const RetinalPicture seen = retinal_picture(picture, kViewing);
        const auto spots = visible_spots(seen, background(seen, kViewing));
        EXPECT_EQ(spots.size(), distance < twice ? 1u : 2u) << distance;
    }
}

// Spots at random places; their number has the scatter of a Poisson process.
TEST(Sparkle, StandardErrorIsTheScatterOfRepeatedPanels) {
    constexpr int kPanels = 60, kSide = 260;
    double sum = 0, squares = 0, claimed = 0;
    for (int panel = 0; panel < kPanels; ++panel) {
        Rng rng(1, panel);
        PanelPicture picture = uniform_picture(kSide, kPixel_mm, kBackground);
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                if (rng.uniform_double() > 60.0 / (kSide * kSide)) continue;
                add_y(picture, x, y, excess_of(5 + 20 * rng.uniform_double()));
            }
        }
        const Estimate e = sparkle(picture, kViewing).sparkle_per_cm2;
        sum += e.value;
        squares += e.value * e.value;
        claimed += e.standard_error * e.standard_error;
    }
    const double scatter = std::sqrt(squares / kPanels - sum / kPanels * sum / kPanels);
    // The scatter of 60 is known to 9 %.
    EXPECT_NEAR(std::sqrt(claimed / kPanels) / scatter, 1, 0.27);
}

TEST(Sparkle, WhatCannotBeReadIsRefused) {
    const auto complaint = [](const PanelPicture& picture, const Viewing& viewing) {
        return message_of<DomainError>([&] { sparkle(picture, viewing); });
    };
    EXPECT_THAT(complaint(uniform_picture(400, 0.2, 1), kViewing), HasSubstr("smaller pixels"));
    EXPECT_THAT(complaint(uniform_picture(32, kPixel_mm, 1), kViewing), HasSubstr("larger field"));
    EXPECT_THAT(complaint(uniform_picture(400, kPixel_mm, 1), {1, 1000}), HasSubstr("distance"));
}

TEST(Jackknife, OfAMeanIsItsStandardError) {
    using Sums = std::array<double, 2>;
    const std::array<Sums, 5> pieces{{{1, 1}, {1, 4}, {1, 2}, {1, 8}, {1, 5}}};
    const Estimate e = jackknife(pieces, [](const Sums& s) { return s[1] / s[0]; });
    EXPECT_DOUBLE_EQ(e.value, 4);
    // Variance 30/4 of the five, over five.
    EXPECT_NEAR(e.standard_error, std::sqrt(30.0 / 4 / 5), 1e-12);
}

constexpr double kMean = 0.5;

PanelPicture noise(int side, double contrast, std::uint64_t seed) {
    PanelPicture picture = uniform_picture(side, kPixel_mm, kMean);
    Rng rng(seed);
    for (std::size_t p = 0; p < picture.pixel_count(); ++p) {
        picture.xyz[3 * p + 1] = static_cast<float>(kMean * (1 + contrast * normal(rng)));
    }
    return picture;
}

TEST(Graininess, AnEvenPanelHasNone) {
    for (double y : {0.0, 0.04, 0.7312345, 12.0}) {
        const PanelPicture even = uniform_picture(60, kPixel_mm, y);
        const Graininess g = graininess(even, even);
        EXPECT_EQ(g.graininess.value, 0);
        EXPECT_EQ(g.pixel_contrast.value, 0);
    }
}

TEST(Graininess, OfAGratingThatIsJustNoticedIsOne) {
    constexpr int kSide = 400;
    const Viewing viewing;
    for (int cycles : {2, 7, 30}) {
        for (bool across : {true, false}) {
            const double per_degree = mm_per_degree(viewing);
            const double frequency = cycles / (kSide * kPixel_mm) * per_degree;
            const double modulation =
                1 / contrast_sensitivity(frequency, luminance_cd_m2(viewing, kMean),
                                         kPanelSide_mm / per_degree);
            PanelPicture picture = uniform_picture(kSide, kPixel_mm, kMean);
            for (int y = 0; y < kSide; ++y) {
                for (int x = 0; x < kSide; ++x) {
                    const double phase = 2 * std::numbers::pi * cycles * (across ? x : y) / kSide;
                    set_y(picture, x, y, kMean * (1 + modulation * std::cos(phase)));
                }
            }
            const Graininess g = graininess(picture, picture, viewing);
            // Pixels are kept in single precision: to 6e-8 of 1, a modulation of 1.5e-3.
            EXPECT_NEAR(g.graininess.value, 1, 1e-5) << cycles;
            EXPECT_NEAR(g.pixel_contrast.value, modulation / std::sqrt(2.0), 1e-4 * modulation);
        }
    }
}

// White noise of contrast c has the same power at all frequencies up to that of the pixels:
//   G = c sqrt(2 pixel^2 Int S^2 d^2u) = 50.7022 c,
// the integral by scipy.integrate.quad over colour-science 0.4.7's Barten function (as
// above) for pixels of 0.025 mm at 500 mm, 1000 lx on Y = 0.5.
TEST(Graininess, OfWhiteNoiseIsItsContrastTimesAKnownNumber) {
    constexpr double kContrast = 0.05, kPerContrast = 50.702217859893487;
    double mean = 0, error = 0;
    constexpr int kPictures = 4;
    for (int i = 0; i < kPictures; ++i) {
        const PanelPicture picture = noise(480, kContrast, 10 + i);
        const Graininess g = graininess(picture, picture);
        mean += g.graininess.value / kPictures;
        error += g.graininess.standard_error * g.graininess.standard_error;
        EXPECT_NEAR(g.pixel_contrast.value, kContrast, 4 * kContrast / std::sqrt(2.0 * 480 * 480));
    }
    error = std::sqrt(error) / kPictures;
    EXPECT_NEAR(mean, kPerContrast * kContrast, 4 * error);
    EXPECT_LT(error, 0.02 * mean);
}

TEST(Graininess, IndependentNoiseDoesNotCount) {
    PanelPicture a = noise(320, 0.05, 1), b = a;
    const double clean = graininess(a, a).graininess.value;
    const PanelPicture n = noise(320, 0.1, 2), m = noise(320, 0.1, 3);
    for (std::size_t p = 0; p < a.pixel_count(); ++p) {
        a.xyz[3 * p + 1] += n.xyz[3 * p + 1] - static_cast<float>(kMean);
        b.xyz[3 * p + 1] += m.xyz[3 * p + 1] - static_cast<float>(kMean);
    }
    const Graininess g = graininess(a, b);
    EXPECT_NEAR(g.graininess.value, clean, 4 * g.graininess.standard_error);
    EXPECT_LT(g.graininess.standard_error, 0.2 * clean);
    // Given twice, the picture has the root of 1 + 4 times as much.
    EXPECT_GT(graininess(a, a).graininess.value, 1.9 * clean);
}

TEST(Graininess, StandardErrorIsTheScatterOfRepeatedPanels) {
    constexpr int kPanels = 60;
    double sum = 0, squares = 0, claimed = 0;
    for (int panel = 0; panel < kPanels; ++panel) {
        const PanelPicture picture = noise(200, 0.05, 100 + panel);
        const Estimate e = graininess(picture, picture).graininess;
        sum += e.value;
        squares += e.value * e.value;
        claimed += e.standard_error * e.standard_error;
    }
    const double scatter = std::sqrt(squares / kPanels - sum / kPanels * sum / kPanels);
    // The scatter of 60 is known to 9 %; pieces of 1.25 mm share some of the eye's filter.
    EXPECT_NEAR(std::sqrt(claimed / kPanels) / scatter, 1, 0.3);
}

// A prime side would take the transform minutes; 360 is the largest length below 367 without prime
// factors above 7.
TEST(Graininess, LeavesOutRowsAndColumnsBeyondAFastLength) {
    const PanelPicture whole = noise(367, 0.05, 5);
    PanelPicture part = uniform_picture(360, kPixel_mm, kMean);
    for (int y = 0; y < 360; ++y) {
        for (int x = 0; x < 360; ++x) {
            set_y(part, x, y, whole.luminance(static_cast<std::size_t>(y) * 367 + x));
        }
    }
    const Graininess of_whole = graininess(whole, whole), of_part = graininess(part, part);
    EXPECT_GT(of_part.graininess.value, 0);
    EXPECT_EQ(of_whole.graininess.value, of_part.graininess.value);
    EXPECT_EQ(of_whole.mean_y, of_part.mean_y);
}

TEST(Graininess, PicturesThatDifferInSizeAreRefused) {
    EXPECT_THROW(graininess(uniform_picture(20, 0.1, 1), uniform_picture(21, 0.1, 1)), DomainError);
    EXPECT_THROW(graininess(uniform_picture(8, 0.1, 1), uniform_picture(8, 0.1, 1)), DomainError);
}

TEST(MeasurePictures, StopsWhenAskedTo) {
    const PanelPicture picture = uniform_picture(96, 0.02, 1);
    const Progress never = [](double) { return false; };
    const SparkleCamera camera;
    PanelPictures lit, diffuse;
    lit.by_lamp = {picture};
    diffuse.diffuse = {picture, picture};
    EXPECT_NO_THROW(measure_pictures(camera, lit));
    EXPECT_NO_THROW(measure_pictures(camera, diffuse));
    EXPECT_THROW(measure_pictures(camera, lit, {}, never), Stopped);
    EXPECT_THROW(measure_pictures(camera, diffuse, {}, never), Stopped);
}

}  // namespace
}  // namespace nacre::measure
