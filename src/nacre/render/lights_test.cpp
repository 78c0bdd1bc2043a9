#include "nacre/render/lights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/render/film.h"
#include "nacre/render/sampler.h"

namespace nacre::render {
namespace {

const std::vector<Light> kLamps = {
    RectangleLight{.center_mm = {300, 0, 900}, .radiance = {.scale = 3}},
    RectangleLight{.center_mm = {-900, 200, 400}, .radiance = {.scale = 40}, .visible = false},
    // Its dark side faces the scene.
    RectangleLight{.center_mm = {0, 0, 800}, .target_mm = {0, 0, 2000}, .radiance = {.scale = 9}},
    DirectionalLight{.to_light = {1, 1, 2}, .irradiance = {.scale = 2}}};

/// Lamps in front of a sky, in a studio, and before an even grey.
struct Lit {
    explicit Lit(const Environment& environment) : lights(kLamps, environment, {}, 100, basis) {}

    EmissionBasis basis;
    LightSet lights;
};
const std::vector<Environment> kSurroundings = {SkyEnvironment{.sun_elevation_deg = 35},
                                                StudioEnvironment{}, ConstantEnvironment{}};
constexpr Vec3f kPoint_mm{20, -30, 40};

TEST(LightSet, EightDrawsAreThoseOfEach) {
    int sky = 0, rectangle = 0, unseen = 0, directional = 0;
    for (const Environment& environment : kSurroundings) {
        const Lit lit(environment);
        const auto spectra = lit.basis.at(film_wavelengths(0, 1));
        for (const bool alone : {false, true}) {
            for (std::uint32_t i = 0; i < 500; ++i) {
                const PathSampler::Threes u = PathSampler(1, 5, i).draw_refined(0);
                const LightDirections eight =
                    lit.lights.directions(kPoint_mm, u.choice, {u.x, u.y}, spectra.data(), alone);
                for (int k = 0; k < kLanes; ++k) {
                    const auto one = lit.lights.sample(kPoint_mm, u.choice[k], {u.x[k], u.y[k]},
                                                       spectra.data(), alone);
                    ASSERT_EQ(eight.pdf[k] > 0, one.has_value());
                    if (!one) continue;
                    const LightSample found = lit.lights.look_at(eight, k, spectra.data(), alone);
                    EXPECT_LT(length(found.direction - one->direction), 1e-6f);
                    EXPECT_NEAR(found.pdf, one->pdf, 1e-4f * one->pdf);
                    EXPECT_EQ(found.delta, one->delta);
                    EXPECT_FLOAT_EQ(found.brightness, eight.brightness[k]);
                    if (std::isfinite(one->distance)) {
                        EXPECT_NEAR(found.distance, one->distance, 1e-4f * one->distance);
                    } else {
                        EXPECT_EQ(found.distance, one->distance);
                    }
                    for (int lane = 0; lane < kLanes; ++lane) {
                        EXPECT_NEAR(found.radiance[lane], one->radiance[lane],
                                    1e-3f * one->radiance[lane]);
                    }
                    const bool far = std::isinf(found.distance);
                    ++(found.delta ? (far ? directional : unseen) : (far ? sky : rectangle));
                }
            }
        }
    }
    EXPECT_GT(sky, 100);
    EXPECT_GT(rectangle, 100);
    EXPECT_GT(unseen, 100);
    EXPECT_GT(directional, 100);
}

// By the guess candidates are chosen: it must tell bright directions from dim ones, no more.
TEST(LightSet, TheGuessIsNearWhatShinesThere) {
    for (const Environment& environment : kSurroundings) {
        const Lit lit(environment);
        int near = 0, all = 0;
        for (std::uint32_t pass = 0; pass < 64; ++pass) {
            const bsdf::Wavelengths nm = film_wavelengths(pass, 64);
            const auto spectra = lit.basis.at(nm);
            const PathSampler::Threes u = PathSampler(1, 6, pass).draw_refined(0);
            for (const bool alone : {false, true}) {
                const LightDirections eight =
                    lit.lights.directions(kPoint_mm, u.choice, {u.x, u.y}, spectra.data(), alone);
                for (int k = 0; k < kLanes; ++k) {
                    if (!(eight.pdf[k] > 0)) continue;
                    const LightSample found = lit.lights.look_at(eight, k, spectra.data(), alone);
                    const float sum = lane_sum(found.radiance);
                    ++all;
                    near += sum < 1.4f * found.brightness && sum > found.brightness / 1.4f;
                }
            }
        }
        EXPECT_GT(all, 500);
        EXPECT_GT(near, 0.9 * all) << environment.index();
    }
}

// Flakes are followed along no direction whose guess is 0. A box so small that it lies between the points
// by which cells are guessed, and the rims of a large one, shine out of cells that look black.
TEST(LightSet, WhatShinesIsNotTakenForBlack) {
    for (const double side_deg : {0.1, 20.0}) {
        const StudioEnvironment studio{
            .horizon = 0,
            .zenith = 0,
            .boxes = {{.azimuth_deg = 33, .width_deg = side_deg, .height_deg = side_deg}}};
        const Lit lit(studio);
        const auto spectra = lit.basis.at(film_wavelengths(0, 1));
        const auto in_full = [](const auto&) { return 1.0f; };
        const Frame frame = Frame::around(direction_from_angles(33, 45));
        int shine = 0;
        for (std::uint32_t i = 0; i < 4000; ++i) {
            const auto u = PathSampler(1, 8, i).draw(0);
            const auto half_side = static_cast<float>(std::tan(side_deg * M_PI / 360));
            const Vec3f direction = normalize(
                frame.to_world(Vec3f{half_side * (2 * u[0] - 1), half_side * (2 * u[1] - 1), 1}));
            if (!(lane_sum(lit.lights.escaped(direction, spectra.data(), in_full)) > 0)) continue;
            ++shine;
            const FloatLanes guess = lit.lights.brightness(kPoint_mm, splat(direction),
                                                           [](const auto&) { return splat(1.0f); });
            EXPECT_GT(guess[0], 0);
        }
        EXPECT_GT(shine, 1000) << side_deg;
    }
}

// All light from one small lamp, so small that no point by which colours are guessed meets it.
TEST(LightSet, SamplesALampInABlackRoom) {
    for (const double side_deg : {0.4, 1.0}) {
        for (const double elevation_deg : {10.0, 75.0}) {
            const StudioEnvironment studio{.horizon = 0,
                                           .zenith = 0,
                                           .boxes = {{.azimuth_deg = -60,
                                                      .elevation_deg = elevation_deg,
                                                      .width_deg = side_deg,
                                                      .height_deg = side_deg,
                                                      .softness = 0}}};
            EmissionBasis basis;
            const LightSet lights({}, studio, {}, 100, basis);
            const auto spectra = basis.at(film_wavelengths(0, 1));
            int met = 0;
            for (std::uint32_t i = 0; i < 200; ++i) {
                const auto u = PathSampler(1, 8, i).draw(0);
                const auto sample =
                    lights.sample(kPoint_mm, u[2], {u[0], u[1]}, spectra.data(), true);
                ASSERT_TRUE(sample);
                if (!(lane_sum(sample->radiance) > 0)) continue;
                ++met;
                const LightDirections eight = lights.directions(
                    kPoint_mm, splat(u[2]), {splat(u[0]), splat(u[1])}, spectra.data(), true);
                EXPECT_GT(lane_sum(eight.brightness), 0);
            }
            EXPECT_GT(met, 20) << side_deg << " at " << elevation_deg;
        }
    }
}

// Of whatever pixel it comes, also next to a pole.
TEST(LightSet, APictureSpreadOutGivesAsMuchLight) {
    constexpr int kWidth = 256, kHeight = 128, kFiner = 4;
    constexpr float kLobe_sr = 0.02f;
    for (const int row : {2, 5, 20, 64, 121}) {
        ImageEnvironment picture{.width = kWidth, .height = kHeight, .rgb = {}};
        picture.rgb.assign(3 * kWidth * kHeight, 0.125f);
        const float brightest = 4096;
        for (int c = 0; c < 3; ++c) picture.rgb[3 * (row * kWidth + 100) + c] = brightest;
        const Lit lit(picture);
        const auto spectra = lit.basis.at(film_wavelengths(0, 1));
        double spread = 0, as_it_is = 0;
        for (int r = 0; r < kFiner * kHeight; ++r) {
            const double zenith = std::numbers::pi * (r + 0.5) / (kFiner * kHeight);
            for (int c = 0; c < kFiner * kWidth; ++c) {
                const double azimuth = 2 * std::numbers::pi * (c + 0.5) / (kFiner * kWidth);
                const Vec3f d = {static_cast<float>(std::sin(zenith) * std::cos(azimuth)),
                                 static_cast<float>(std::sin(zenith) * std::sin(azimuth)),
                                 static_cast<float>(std::cos(zenith))};
                spread +=
                    std::sin(zenith) * lit.lights.escaped_spread(d, kLobe_sr, spectra.data())[3];
                as_it_is +=
                    std::sin(zenith) *
                    lit.lights.escaped(d, spectra.data(), [](const auto&) { return 1.0f; })[3];
            }
        }
        EXPECT_NEAR(spread / as_it_is, 1, 0.02) << row;
    }
}

// What is added of it, to whatever one light sends, must not be more than that light has.
TEST(LightSet, NoLightHasLessThanTheCommonColour) {
    const auto common = [](const std::vector<Light>& lamps, const Environment& environment) {
        EmissionBasis basis;
        const LightSet lights(lamps, environment, {}, 100, basis);
        return lights.common_colour(basis.at(film_wavelengths(0, 1)).data());
    };
    const auto colour = [](spectra::Illuminant illuminant) {
        const spectra::Spectrum spectrum = unit_illuminant(illuminant);
        const bsdf::Wavelengths nm = film_wavelengths(0, 1);
        return make_lanes([&](int k) { return static_cast<float>(spectrum(nm[k])); });
    };
    const FloatLanes d65 = colour(spectra::Illuminant::D65), a = colour(spectra::Illuminant::A);
    const Environment white = ConstantEnvironment{};
    const RectangleLight lamp{.center_mm = {300, 0, 900}, .radiance = {spectra::Illuminant::A, 3}};
    const FloatLanes alone = common({}, white), both = common({lamp}, white);
    const FloatLanes in_sky = common({}, SkyEnvironment{.sun_elevation_deg = 35});
    for (int k = 0; k < kLanes; ++k) {
        EXPECT_NEAR(alone[k], d65[k], 1e-3f * d65[k]);
        EXPECT_NEAR(both[k], std::min(d65[k], a[k]), 1e-3f * d65[k]);
        EXPECT_GT(in_sky[k], 0);
        EXPECT_LT(in_sky[k], 1.5f * d65[k]);
    }
}

// An even sky is left to samples of surfaces, which find it wherever they look.
TEST(LightSet, BesideSurfacesAnEvenSkyIsNotSampled) {
    EmissionBasis basis;
    const LightSet lights({}, ConstantEnvironment{}, {}, 100, basis);
    const auto spectra = basis.at(film_wavelengths(0, 1));
    for (std::uint32_t i = 0; i < 100; ++i) {
        const auto u = PathSampler(1, 7, i).draw(0);
        EXPECT_FALSE(lights.sample(kPoint_mm, u[4], {u[0], u[1]}, spectra.data(), false));
        EXPECT_TRUE(lights.sample(kPoint_mm, u[4], {u[0], u[1]}, spectra.data(), true));
        EXPECT_FALSE(any(lights
                             .directions(kPoint_mm, splat(u[4]), {splat(u[0]), splat(u[1])},
                                         spectra.data(), false)
                             .pdf > 0));
    }
}

}  // namespace
}  // namespace nacre::render
