#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/bsdf/models/nacre_arrays.h"
#include "nacre/core/math.h"
#include "nacre/measure/image_clarity.h"
#include "nacre/render/render.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/render.h"
#include "nacre/testing/statistics.h"

// Pictures of coats that are not flat.

namespace nacre::models {
namespace {

std::shared_ptr<const solver::SolvedPaint> solved(const paint::Recipe& recipe) {
    return std::make_shared<const solver::SolvedPaint>(
        solver::solve(recipe, spectra::default_wavelengths_nm()));
}

paint::Recipe with_peel(paint::Recipe recipe, const paint::OrangePeel& peel, double roughness = 0) {
    recipe.clearcoat = paint::Clearcoat{0, 0.0, roughness, peel};
    return recipe;
}

/// Black below a coat.
std::shared_ptr<const bsdf::Bsdf> black(const paint::OrangePeel& peel, double roughness = 0) {
    const paint::Recipe recipe =
        with_peel(test::paint_of(1.5, {test::pigment_layer(0, 50, 0)}), peel, roughness);
    return std::make_shared<const bsdf::Microflake>(solved(recipe), 3);
}

/// Mean light of a panel that mirrors the middle of a bright bar (phase 0) or of a dark one (1/2).
/// Eye and grille are so far away, and the panel so small, that all of it mirrors the same place.
double mirrored(const std::shared_ptr<const bsdf::Bsdf>& coat, double period_deg, double phase) {
    constexpr double kFar_mm = 1e5, kIncidence_deg = 50, kWidth_mm = 400, kHeight_mm = 40;
    render::SceneDescription scene;
    scene.materials["paint"] = render::PaintMaterial{};
    scene.shapes.push_back(
        {render::FlatPanel{.width_mm = kWidth_mm, .height_mm = kHeight_mm}, "paint", {}});
    const auto at = [](double deg) {
        return Vec3f{0, static_cast<float>(kFar_mm * std::sin(deg * kDegree)),
                     static_cast<float>(kFar_mm * std::cos(deg * kDegree))};
    };
    // Well within the panel.
    scene.camera = {.position_mm = at(-kIncidence_deg),
                    .vertical_fov_deg =
                        0.8 * kHeight_mm * std::cos(kIncidence_deg * kDegree) / kFar_mm / kDegree};
    for (int bar = -6; bar <= 6; ++bar) {
        const double angle = kIncidence_deg + (bar + phase) * period_deg;
        if (angle >= 89) continue;
        scene.lights.push_back(
            render::RectangleLight{.center_mm = at(angle),
                                   .up = {1, 0, 0},
                                   .width_mm = 2 * kFar_mm * std::tan(period_deg / 4 * kDegree),
                                   .height_mm = kFar_mm});
    }
    const render::RenderResult picture = render::render(
        render::Scene(scene, {{"paint", coat}}),
        {.width = 320, .height = 40, .samples_per_pixel = 16, .seed = 1, .max_depth = 1});
    double sum = 0;
    for (std::size_t i = 1; i < picture.rgb.size(); i += 3) sum += picture.rgb[i];
    return sum / (320.0 * 40);
}

// The renderer knows nothing of the law of slopes, the closed form nothing of waves: within 1 % of the
// flat coat's contrast, for waves of which many lie on the panel.
TEST(OrangePeel, TheMirrorImageOfAGrilleLosesTheStatedContrast) {
    const auto flat = black({});
    int cases = 0;
    for (const double slope : {0.003, 0.01}) {
        const auto coat = black({.wa = slope * 0.6, .wb = slope * 0.8});
        for (const double periods : {0.7, 1.0, 1.6}) {
            const double period_deg = periods * measure::half_contrast_period_deg(slope);
            const double bright = mirrored(coat, period_deg, 0);
            const double dark = mirrored(coat, period_deg, 0.5);
            EXPECT_NEAR((bright - dark) / (bright + dark),
                        measure::grille_contrast(slope, period_deg), 0.01)
                << slope << " " << period_deg;
            // No light is lost: the bars and the gaps share what is mirrored.
            EXPECT_NEAR(bright + dark, mirrored(flat, period_deg, 0), 0.03 * bright);
            ++cases;
        }
    }
    EXPECT_EQ(cases, 6);
}

// Facets and waves blur the image one after the other: their contrasts multiply, bar for bar of the
// grille's series, which makes the squares of their slopes add up.
TEST(OrangePeel, RoughnessAndWavesBlurTheMirrorImageTogether) {
    constexpr double kRoughness = 0.014, kSlope = 0.01;
    const auto coat = black({.wa = kSlope * 0.6, .wb = kSlope * 0.8}, kRoughness);
    const auto even = black({}, kRoughness);
    const double facets = kRoughness / std::sqrt(2.0), both = std::hypot(kSlope, facets);
    int cases = 0;
    for (const double periods : {0.7, 1.0, 1.6}) {
        const double period_deg = periods * measure::half_contrast_period_deg(both);
        const auto contrast = [&](const std::shared_ptr<const bsdf::Bsdf>& of) {
            const double bright = mirrored(of, period_deg, 0);
            const double dark = mirrored(of, period_deg, 0.5);
            return (bright - dark) / (bright + dark);
        };
        EXPECT_NEAR(contrast(coat), measure::grille_contrast(both, period_deg), 0.005);
        EXPECT_NEAR(contrast(even), measure::grille_contrast(facets, period_deg), 0.005);
        ++cases;
    }
    EXPECT_EQ(cases, 3);
}

/// A ball of paint under a lamp and a sky.
render::SceneDescription painted_ball() {
    render::SceneDescription scene;
    scene.camera = {.position_mm = {0, -60, 10}, .vertical_fov_deg = 8};
    scene.materials["paint"] = render::PaintMaterial{};
    scene.shapes.push_back({render::Sphere{.radius_mm = 5}, "paint", {}});
    scene.lights.push_back(render::RectangleLight{
        .center_mm = {50, -80, 120}, .width_mm = 240, .height_mm = 240, .radiance = {.scale = 3}});
    scene.environment = render::ConstantEnvironment{.radiance = {.scale = 0.5}};
    return scene;
}

const bsdf::Nacre& sparkling(bool peel) {
    static const auto make = [](const paint::OrangePeel& waves) {
        return bsdf::Nacre(solved(with_peel(bsdf::paint_of({bsdf::metal_flake(40, 0.7)}), waves)),
                           {.specimen = 2});
    };
    static const bsdf::Nacre flat = make({}), wavy = make({.wb = 0.05, .wc = 0.05});
    return peel ? wavy : flat;
}

std::shared_ptr<const bsdf::Bsdf> shared(const bsdf::Bsdf& surface) {
    return {std::shared_ptr<const void>(), &surface};
}

// Lights sampled, the surface sampled, or both: values, densities and samples belong together, those
// of flakes that are sampled one by one among them. Of flakes lights alone find too little.
void expect_estimators_agree(const bsdf::Bsdf& surface, bool light_alone) {
    const render::Scene scene(painted_ball(), {{"paint", shared(surface)}});
    const render::RenderOptions options{
        .width = 24, .height = 24, .samples_per_pixel = 64, .max_depth = 1};
    const auto mean = [&](render::DirectLight how) {
        return render::testing::estimate_luminance(scene, options, how, 16);
    };
    const Estimate both = mean(render::DirectLight::combined);
    EXPECT_LT(both.standard_error, 0.002 * both.value);
    for (const auto how :
         {render::DirectLight::surface_sampling, render::DirectLight::light_sampling}) {
        if (how == render::DirectLight::light_sampling && !light_alone) continue;
        const Estimate one = mean(how);
        EXPECT_NEAR(one.value, both.value,
                    test::kWorstZ * std::hypot(one.standard_error, both.standard_error));
        EXPECT_LT(one.standard_error, 0.005 * one.value);
    }
}

constexpr paint::OrangePeel kSteep{.wb = 0.05, .wc = 0.05};

TEST(OrangePeel, EstimatorsOfDirectLightAgree) {
    expect_estimators_agree(
        bsdf::Microflake(solved(with_peel(test::metallic(0.2, 0.6), kSteep)), 2), true);
    expect_estimators_agree(sparkling(true), false);
}

TEST(OrangePeel, EstimatorsOfDirectLightAgreeUnderARoughInterface) {
    expect_estimators_agree(
        bsdf::Microflake(solved(with_peel(test::metallic(0.2, 0.6), kSteep, 0.15)), 2), true);
    expect_estimators_agree(
        bsdf::Nacre(solved(with_peel(bsdf::paint_of({bsdf::metal_flake(40, 0.7)}), kSteep, 0.1)),
                    {.specimen = 2}),
        false);
}

// The waves turn light, and neither make nor take it.
TEST(OrangePeel, ABallIsAsBrightAsAFlatOneAndLooksDifferent) {
    const render::RenderOptions options{
        .width = 48, .height = 48, .samples_per_pixel = 64, .max_depth = 1};
    std::array<std::vector<float>, 2> picture;
    std::array<double, 2> mean{};
    for (const bool peel : {false, true}) {
        const render::Scene scene(painted_ball(), {{"paint", shared(sparkling(peel))}});
        picture[peel] = render::render(scene, options).rgb;
        for (std::size_t i = 1; i < picture[peel].size(); i += 3) mean[peel] += picture[peel][i];
    }
    EXPECT_NEAR(mean[1], mean[0], 0.03 * mean[0]);
    double difference = 0;
    for (std::size_t i = 1; i < picture[0].size(); i += 3) {
        difference += std::abs(picture[0][i] - picture[1][i]);
    }
    EXPECT_GT(difference, 0.02 * mean[0]);
}

TEST(OrangePeel, WithoutSlopesThePictureIsThatOfAFlatCoat) {
    paint::Recipe plain = bsdf::paint_of({bsdf::metal_flake(40, 0.7)});
    plain.clearcoat = paint::Clearcoat{0, 0.0, 0};
    const bsdf::Nacre surface(solved(plain), {.specimen = 2});
    EXPECT_EQ(surface.coat_waves(), nullptr);
    EXPECT_EQ(sparkling(false).coat_waves(), nullptr);
    EXPECT_NE(sparkling(true).coat_waves(), nullptr);
    const render::RenderOptions options{.width = 24, .height = 24, .samples_per_pixel = 4};
    const auto picture = [&](const bsdf::Bsdf& of) {
        return render::render(render::Scene(painted_ball(), {{"paint", shared(of)}}), options).rgb;
    };
    EXPECT_EQ(picture(surface), picture(sparkling(false)));
}

TEST(OrangePeel, WhatHoldsNoWavesIsRefused) {
    const auto paint = solved(with_peel(test::metallic(0.2, 0.5), {.wd = 0.01}));
    EXPECT_THROW(bsdf::microflake_arrays(paint), DomainError);
    EXPECT_THROW(bsdf::nacre_arrays(paint, {}), DomainError);
    const bsdf::MicroflakeModel table{.table = bsdf::MicroflakeModel::Table::raw};
    EXPECT_THROW(table.make_table(*paint, {}), DomainError);
}

}  // namespace
}  // namespace nacre::models
