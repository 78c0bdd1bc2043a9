#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/bsdf/models/nacre_arrays.h"
#include "nacre/render/render.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/render.h"
#include "nacre/testing/statistics.h"

// Pictures of tinted coats whose thickness varies.

namespace nacre::models {
namespace {

using ::testing::HasSubstr;

std::shared_ptr<const solver::SolvedPaint> solved_coat(const paint::Recipe& recipe) {
    return std::make_shared<const solver::SolvedPaint>(
        solver::solve(recipe, spectra::default_wavelengths_nm()));
}

paint::Recipe under(paint::Recipe recipe, const paint::Clearcoat& coat) {
    recipe.clearcoat = coat;
    return recipe;
}

/// Spread by a fifth, of an optical depth of 0.6 along the normal at every wavelength.
paint::Clearcoat grey(double spread_um = 8) {
    paint::Clearcoat coat{.thickness_um = 40, .absorption_per_mm = 15.0};
    coat.thickness_spread_um = spread_um;
    return coat;
}

std::vector<float> green_of(const render::RenderResult& picture) {
    std::vector<float> green;
    for (std::size_t i = 1; i < picture.rgb.size(); i += 3) green.push_back(picture.rgb[i]);
    return green;
}

/// A panel of 20 m, far from eye and lamp: all of it is seen and lit in the same directions, and each
/// pixel is one place, wavelengths away from the next.
std::vector<float> far_panel(const std::shared_ptr<const bsdf::Bsdf>& coat) {
    constexpr double kFar_mm = 1e6, kSide_mm = 2e4;
    render::SceneDescription scene;
    scene.materials["paint"] = render::PaintMaterial{};
    scene.shapes.push_back(
        {render::FlatPanel{.width_mm = kSide_mm, .height_mm = kSide_mm}, "paint", {}});
    scene.camera = {.position_mm = {0, 0, kFar_mm},
                    .up = {0, 1, 0},
                    .vertical_fov_deg = 0.8 * kSide_mm / kFar_mm / kDegree};
    scene.lights.push_back(render::RectangleLight{.center_mm = {0, -kFar_mm, kFar_mm},
                                                  .width_mm = 3e4,
                                                  .height_mm = 3e4,
                                                  .radiance = {.scale = 1e3}});
    return green_of(render::render_with(
        render::Scene(scene, {{"paint", coat}}),
        {.width = 96, .height = 96, .samples_per_pixel = 1, .seed = 1, .max_depth = 1},
        render::DirectLight::light_sampling));
}

// Light that flakes reflect once passes exp(-z D), D = s a (1/mu_i + 1/mu_o) and z normal: the values of
// places have a lognormal law, of mean exp(D^2/2) and variance exp(D^2) (exp(D^2) - 1). What cutting z off
// at +-3 changes is less than the statistical error.
TEST(CoatThickness, ThePixelsOfAPanelHaveALognormalLaw) {
    // So few flakes over black that little is scattered twice.
    paint::Recipe recipe = test::paint_of(1.5, {{15, {test::flakes(0.002, 0.3, 0.5)}, {}}});
    const auto model = [&](const paint::Clearcoat& coat) {
        return std::make_shared<const bsdf::Microflake>(solved_coat(under(recipe, coat)), 3);
    };
    const std::vector<float> even = far_panel(model(grey(0))), spread = far_panel(model(grey()));
    const double mu_o = std::sqrt(1 - 0.5 / (1.5 * 1.5));  // 45 deg outside
    const double d2 = std::pow(0.2 * 0.6 * (1 + 1 / mu_o), 2);
    std::vector<double> values;
    for (std::size_t i = 0; i < even.size(); ++i) values.push_back(spread[i] / even[i]);
    const test::Moments found(values);
    EXPECT_NEAR(found.mean, std::exp(d2 / 2), test::kWorstZ * found.mean_error + 2e-3);
    const double variance = std::exp(d2) * std::expm1(d2);
    EXPECT_NEAR(found.variance, variance, test::kWorstZ * found.variance_error);
    EXPECT_LT(found.variance_error, 0.03 * variance);
}

/// A ball of paint under a lamp and a sky.
render::SceneDescription ball_under_lamp() {
    render::SceneDescription scene;
    scene.camera = {.position_mm = {0, -600, 100}, .vertical_fov_deg = 8};
    scene.materials["paint"] = render::PaintMaterial{};
    scene.shapes.push_back({render::Sphere{.radius_mm = 50}, "paint", {}});
    scene.lights.push_back(render::RectangleLight{.center_mm = {500, -800, 1200},
                                                  .width_mm = 2400,
                                                  .height_mm = 2400,
                                                  .radiance = {.scale = 3}});
    scene.environment = render::ConstantEnvironment{.radiance = {.scale = 0.5}};
    return scene;
}

std::shared_ptr<const bsdf::Nacre> flakes_under(const paint::Clearcoat& coat) {
    return std::make_shared<const bsdf::Nacre>(
        solved_coat(under(bsdf::paint_of({bsdf::metal_flake(40, 0.7)}), coat)),
        bsdf::NacreModel{.specimen = 2});
}

std::vector<float> picture_of(const std::shared_ptr<const bsdf::Bsdf>& coat, int samples) {
    return render::render(render::Scene(ball_under_lamp(), {{"paint", coat}}),
                          {.width = 24, .height = 24, .samples_per_pixel = samples})
        .rgb;
}

// Lights sampled, the surface sampled, or both, also where waves tilt the coat besides. Of flakes lights
// alone find too little.
TEST(CoatThickness, EstimatorsOfDirectLightAgree) {
    paint::Clearcoat wavy = grey();
    wavy.orange_peel = paint::OrangePeel{.wb = 0.03, .wc = 0.03};
    const auto agree = [](const std::shared_ptr<const bsdf::Bsdf>& coat, bool light_alone) {
        const render::Scene scene(ball_under_lamp(), {{"paint", coat}});
        const render::RenderOptions options{
            .width = 24, .height = 24, .samples_per_pixel = 16, .max_depth = 1};
        const auto mean = [&](render::DirectLight how) {
            return render::testing::estimate_luminance(scene, options, how, 8);
        };
        const Estimate both = mean(render::DirectLight::combined);
        EXPECT_LT(both.standard_error, 0.01 * both.value);
        for (const auto how :
             {render::DirectLight::surface_sampling, render::DirectLight::light_sampling}) {
            if (how == render::DirectLight::light_sampling && !light_alone) continue;
            const Estimate one = mean(how);
            EXPECT_NEAR(one.value, both.value,
                        test::kWorstZ * std::hypot(one.standard_error, both.standard_error));
            EXPECT_LT(one.standard_error, 0.02 * one.value);
        }
    };
    agree(std::make_shared<const bsdf::Microflake>(
              solved_coat(under(test::metallic(0.2, 0.6), grey())), 2),
          true);
    agree(flakes_under(wavy), false);
}

// Neither a spread of 0 nor one of a coat that absorbs nothing changes a bit; a spread does.
TEST(CoatThickness, AnEvenCoatMakesThePictureThatItMade) {
    paint::Clearcoat clear{.thickness_um = 40};
    const auto plain = flakes_under(clear);
    clear.thickness_spread_um = 10;
    const auto clear_spread = flakes_under(clear), even = flakes_under(grey(0)),
               spread = flakes_under(grey());
    EXPECT_EQ(plain->coat_thickness(), nullptr);
    EXPECT_EQ(clear_spread->coat_thickness(), nullptr);
    EXPECT_EQ(even->coat_thickness(), nullptr);
    EXPECT_NE(spread->coat_thickness(), nullptr);
    EXPECT_EQ(picture_of(plain, 2), picture_of(clear_spread, 2));
    // As the spread goes to 0 the picture does to that of an even coat.
    const std::vector<float> limit = picture_of(even, 2);
    const auto furthest = [&](const std::vector<float>& picture) {
        double most = 0, largest = 0;
        for (std::size_t i = 0; i < limit.size(); ++i) {
            most = std::max<double>(most, std::abs(picture[i] - limit[i]));
            largest = std::max<double>(largest, limit[i]);
        }
        return most / largest;
    };
    EXPECT_GT(furthest(picture_of(spread, 2)), 0.02);
    EXPECT_LT(furthest(picture_of(flakes_under(grey(1e-4)), 2)), 1e-4);
}

TEST(CoatThickness, WhatHoldsNoSpreadIsRefused) {
    const auto paint = solved_coat(under(test::metallic(0.2, 0.5), grey()));
    const char* const key = "clearcoat.thickness_spread_um";
    EXPECT_THAT(test::message_of<DomainError>([&] { bsdf::microflake_arrays(paint); }),
                HasSubstr(key));
    EXPECT_THAT(test::message_of<DomainError>([&] { bsdf::nacre_arrays(paint, {}); }),
                HasSubstr(key));
    const bsdf::MicroflakeModel table{.table = bsdf::MicroflakeModel::Table::raw};
    EXPECT_THAT(test::message_of<DomainError>([&] { table.make_table(*paint, {}); }),
                HasSubstr(key));
}

}  // namespace
}  // namespace nacre::models
