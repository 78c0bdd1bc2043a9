#include "nacre/measure/sparkle_scale.h"

#include <gmock/gmock.h>

#include <numbers>

#include "nacre/core/error.h"
#include "nacre/measure/panel_picture_test_support.h"

namespace nacre::measure {
namespace {

using ::testing::HasSubstr;

constexpr Viewing kViewing{500, 1000};
constexpr double kPixel_mm = 0.025, kGround = 0.2;

// The excess of Y of one pixel that is as many thresholds on a ground of kGround: illuminance at
// the eye over that needed.
double excess_of(double visibility, double pixel_mm = kPixel_mm, const Viewing& v = kViewing) {
    const double lux_per_y =
        v.illuminance_lx / std::numbers::pi * pixel_mm * pixel_mm / (v.distance_mm * v.distance_mm);
    return visibility * point_threshold_lx(luminance_cd_m2(v, kGround)) / lux_per_y;
}

TEST(Sparkle, AnEvenPanelHasNone) {
    for (double y : {0.0, 0.04, 0.7312345, 12.0}) {
        const Sparkle s = sparkle(even_picture(160, kPixel_mm, y));
        EXPECT_EQ(s.density_per_cm2.value, 0);
        EXPECT_EQ(s.area_share.value, 0);
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
    PanelPicture picture = even_picture(480, kPixel_mm, kGround);
    double seen = 0, decades = 0;
    int n = 0;
    for (int y = 60; y < 420; y += 40) {
        for (int x = 60; x < 420; x += 40, ++n) {
            const double v = painted[n % 6];
            set_y(picture, x, y, kGround + excess_of(v));
            if (v < 1) continue;
            seen += 1;
            decades += std::log10(v);
        }
    }
    const Sparkle s = sparkle(picture, kViewing);
    EXPECT_DOUBLE_EQ(s.density_per_cm2.value * s.area_mm2 / 100, seen);
    // Pixels are kept in single precision; what a spot leaves at its neighbour's place is exp(-80).
    const double mean = std::pow(10, decades / seen);
    EXPECT_NEAR(s.intensity->value, mean, 1e-5 * mean);
    EXPECT_NEAR(s.sparkle_per_cm2.value, decades / s.area_mm2 * 100,
                1e-5 * s.sparkle_per_cm2.value);
    EXPECT_NEAR(s.contrast->value, s.background.threshold * s.intensity->value / kGround, 1e-4);
}

TEST(Sparkle, ASpotIsAsVisibleInSmallPixelsAsInLargeOnes) {
    for (double pixel_mm : {0.01, 0.025, 0.05}) {
        const int side = static_cast<int>(std::lround(2.5 / pixel_mm));
        PanelPicture picture = even_picture(side, pixel_mm, kGround);
        set_y(picture, side / 2, side / 2, kGround + excess_of(5, pixel_mm));
        const Sparkle s = sparkle(picture, kViewing);
        ASSERT_TRUE(s.intensity) << pixel_mm;
        EXPECT_NEAR(s.intensity->value, 5, 1e-3) << pixel_mm;
    }
}

TEST(Sparkle, VisibilityFallsWithTheSquareOfTheDistance) {
    PanelPicture picture = even_picture(240, kPixel_mm, kGround);
    set_y(picture, 120, 120, kGround + excess_of(16));
    const double near = sparkle(picture, {500, 1000}).intensity->value;
    const double far = sparkle(picture, {1000, 1000}).intensity->value;
    EXPECT_NEAR(near / far, 4, 1e-3);
}

TEST(Sparkle, TwoSpotsAreToldApartBeyondTwiceTheBlur) {
    const double blur = retinal_picture(even_picture(120, kPixel_mm, kGround), kViewing).blur_mm;
    const int twice = static_cast<int>(std::lround(2 * blur / kPixel_mm));
    for (int distance : {twice - 2, twice + 2}) {
        PanelPicture picture = even_picture(161, kPixel_mm, kGround);
        set_y(picture, 80, 80, kGround + excess_of(10));
        set_y(picture, 80 + distance, 80, kGround + excess_of(10));
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
        PanelPicture picture = even_picture(kSide, kPixel_mm, kGround);
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
        try {
            sparkle(picture, viewing);
        } catch (const DomainError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(complaint(even_picture(400, 0.2, 1), kViewing), HasSubstr("smaller pixels"));
    EXPECT_THAT(complaint(even_picture(32, kPixel_mm, 1), kViewing), HasSubstr("larger field"));
    EXPECT_THAT(complaint(even_picture(400, kPixel_mm, 1), {1, 1000}), HasSubstr("distance"));
}

TEST(Jackknife, OfAMeanIsItsStandardError) {
    struct Sum {
        double n = 0, x = 0;
        Sum operator+(const Sum& o) const { return {n + o.n, x + o.x}; }
        Sum operator-(const Sum& o) const { return {n - o.n, x - o.x}; }
    };
    std::array<Sum, 5> pieces{{{1, 1}, {1, 4}, {1, 2}, {1, 8}, {1, 5}}};
    const Estimate e = jackknife(pieces, [](const Sum& s) { return s.x / s.n; });
    EXPECT_DOUBLE_EQ(e.value, 4);
    // Variance 30/4 of the five, over five.
    EXPECT_NEAR(e.standard_error, std::sqrt(30.0 / 4 / 5), 1e-12);
}

}  // namespace
}  // namespace nacre::measure
