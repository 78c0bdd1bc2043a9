#include "nacre/measure/graininess.h"

#include <gtest/gtest.h>

#include <numbers>

#include "nacre/core/error.h"
#include "nacre/measure/panel_picture_test_support.h"

namespace nacre::measure {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPixel_mm = 0.025, kMean = 0.5;

PanelPicture noise(int side, double contrast, std::uint64_t seed) {
    PanelPicture picture = even_picture(side, kPixel_mm, kMean);
    Rng rng(seed);
    for (std::size_t p = 0; p < picture.pixel_count(); ++p) {
        picture.xyz[3 * p + 1] = static_cast<float>(kMean * (1 + contrast * normal(rng)));
    }
    return picture;
}

TEST(Graininess, AnEvenPanelHasNone) {
    for (double y : {0.0, 0.04, 0.7312345, 12.0}) {
        const PanelPicture even = even_picture(60, kPixel_mm, y);
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
            PanelPicture picture = even_picture(kSide, kPixel_mm, kMean);
            for (int y = 0; y < kSide; ++y) {
                for (int x = 0; x < kSide; ++x) {
                    const double phase = 2 * kPi * cycles * (across ? x : y) / kSide;
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
// the integral by scipy.integrate.quad over colour-science 0.4.7's Barten function (as in
// eye_test.cpp) for pixels of 0.025 mm at 500 mm, 1000 lx on Y = 0.5.
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
    // With its own noise the picture has the root of 1 + 4 times as much.
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

// A prime side would take the transform minutes; 360 is the largest handy length below 367.
TEST(Graininess, LeavesOutRowsAndColumnsBeyondAHandyLength) {
    const PanelPicture whole = noise(367, 0.05, 5);
    PanelPicture part = even_picture(360, kPixel_mm, kMean);
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
    EXPECT_THROW(graininess(even_picture(20, 0.1, 1), even_picture(21, 0.1, 1)), DomainError);
    EXPECT_THROW(graininess(even_picture(8, 0.1, 1), even_picture(8, 0.1, 1)), DomainError);
}

}  // namespace
}  // namespace nacre::measure
