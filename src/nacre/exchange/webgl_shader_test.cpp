#include "nacre/exchange/webgl_shader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/half.h"
#include "nacre/core/math.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/rgb.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

namespace nacre::exchange {
namespace {

using testing::HasSubstr;
using testing::Not;

std::shared_ptr<const solver::SolvedPaint> solved(
    const paint::Recipe& recipe,
    const std::vector<double>& wavelengths_nm = spectra::default_wavelengths_nm()) {
    return std::make_shared<const solver::SolvedPaint>(solver::solve(recipe, wavelengths_nm));
}

const WebglUniform& uniform(const WebglShader& shader, const std::string& name) {
    const auto found = std::find_if(shader.uniforms.begin(), shader.uniforms.end(),
                                    [&](const WebglUniform& u) { return u.name == name; });
    if (found == shader.uniforms.end()) throw Error("there is no uniform " + name);
    return *found;
}

Vec3d direction_of(double theta_deg, double phi_deg) {
    const double theta = theta_deg * kDegree, phi = phi_deg * kDegree;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Colours of steep spectra, two layers, pigments of both laws and a bright substrate.
paint::Recipe rich_paint(double reflectance) {
    const spectra::Spectrum red({400, 560, 620, 700}, {0.05, 0.1, reflectance, reflectance});
    paint::Recipe recipe =
        test::paint_of(1.5,
                       {{12, {test::flakes(0.05, 0.1, red), test::flakes(0.02, 0.2, 0.7, 0.2)}, {}},
                        test::pigment_layer(0.9, 1, 0.3)},
                       0.6);
    recipe.clearcoat = paint::Clearcoat{40, 2.0, 0};
    return recipe;
}

TEST(WebglShader, TextDependsOnTheStructureAlone) {
    const WebglShader one = make_live_webgl_shader(solved(rich_paint(0.6)));
    paint::Recipe changed = rich_paint(0.8);
    changed.binder = optics::Material(1.45);
    changed.clearcoat->thickness_um = 80;
    changed.layers[0].thickness_um = 20;
    changed.layers[0].flakes[1].orientation.beckmann_alpha = 0.1;
    changed.layers[0].flakes[0].diameter_um = 30;
    changed.substrate_reflectance = 0.0;
    const WebglShader other = make_live_webgl_shader(solved(changed));
    EXPECT_EQ(one.glsl, other.glsl);
    EXPECT_EQ(one.program, other.program);
    EXPECT_NE(uniform(one, "nacreLayer").values, uniform(other, "nacreLayer").values);
    ASSERT_EQ(one.uniforms.size(), other.uniforms.size());
    for (std::size_t i = 0; i < one.uniforms.size(); ++i) {
        EXPECT_EQ(one.uniforms[i].values.size(), other.uniforms[i].values.size());
    }

    changed.layers[0].flakes.pop_back();
    EXPECT_NE(make_live_webgl_shader(solved(changed)).program, one.program);
    changed = rich_paint(0.6);
    changed.clearcoat->roughness = 0.2;
    EXPECT_NE(make_live_webgl_shader(solved(changed)).program, one.program);
}

TEST(WebglShader, NumbersAreThoseOfThePaint) {
    const WebglShader shader = make_live_webgl_shader(solved(rich_paint(0.6)));
    EXPECT_TRUE(shader.smooth_coat);
    EXPECT_FLOAT_EQ(uniform(shader, "nacreIor").values.at(0), 1.5f);
    EXPECT_EQ(uniform(shader, "nacreLayer").values, (std::vector<float>{12, 0, 100, 12}));
    EXPECT_EQ(uniform(shader, "nacreLobeCount").values.at(0), 2);
    EXPECT_EQ(uniform(shader, "nacreScattering").values.size(), std::size_t{kWebglBands});
    EXPECT_NEAR(uniform(shader, "nacreScattering").values.at(5), 0.009, 1e-6);
    for (const WebglTexture& texture : shader.textures) {
        std::size_t texels = 1;
        for (const int size : texture.size) texels *= static_cast<std::size_t>(size);
        EXPECT_EQ(texture.rgba.size(), 4 * texels) << texture.name;
    }
    EXPECT_THAT(shader.glsl, HasSubstr("uniform vec2 nacreLayer[2];"));
    EXPECT_THAT(shader.glsl, Not(HasSubstr("@")));
    const std::string constants = shader.glsl_with_constants();
    EXPECT_THAT(constants, Not(HasSubstr("uniform vec")));
    EXPECT_THAT(constants, HasSubstr("const float nacreIor = 1.50000000e+00;"));
}

// By sixteen wavelengths in place of 31, and half floats.
constexpr double kShaderError = 0.01;

TEST(WebglShader, ColoursAreThoseOfTheSolvedPaint) {
    for (const double roughness : {0.0, 0.2}) {
        paint::Recipe recipe = rich_paint(0.6);
        recipe.clearcoat->roughness = roughness;
        const auto paint = solved(recipe);
        // Without the hot spot, which the solved paint does not have.
        const WebglShader shader =
            make_webgl_shader(bsdf::microflake_arrays(paint, bsdf::ArrayParts::mean));
        const std::vector<Vec3d> weights = spectra::rec709_weights(paint->wavelengths_nm());
        double largest = 0, worst = 0;
        int count = 0;
        for (const double theta_i : {10.0, 45.0, 65.0}) {
            for (const double theta_o : {0.0, 30.0, 50.0, 75.0}) {
                for (const double phi : {0.0, 100.0, 180.0}) {
                    const std::vector<double> spectrum =
                        paint->brdf(theta_i * kDegree, theta_o * kDegree, phi * kDegree);
                    Vec3d want;
                    for (std::size_t w = 0; w < weights.size(); ++w)
                        want += spectrum[w] * weights[w];
                    const Vec3d got =
                        shader.brdf(direction_of(theta_i, 0), direction_of(theta_o, phi));
                    for (int c = 0; c < 3; ++c) {
                        largest = std::max(largest, want[c]);
                        worst = test::worse(worst, std::abs(got[c] - want[c]));
                    }
                    ++count;
                }
            }
        }
        EXPECT_EQ(count, 36);
        EXPECT_GT(largest, 0.1);
        EXPECT_LT(worst, kShaderError * largest) << "roughness " << roughness;
    }
}

// What an eye sees that has adapted to the lamp: by the CIE's tables every nanometre and Bradford's
// transform, where the shader has weights of sixteen bands.
TEST(WebglShader, ColoursUnderALampAreThoseOfItsSpectrum) {
    using spectra::Illuminant, spectra::Observer;
    const auto paint = solved(rich_paint(0.6));
    const auto arrays = bsdf::microflake_arrays(paint, bsdf::ArrayParts::mean);
    const WebglShader daylight = make_webgl_shader(arrays);
    const std::vector<double>& nm = paint->wavelengths_nm();
    std::vector<double> fine_nm;
    for (double w = nm.front(); w <= nm.back(); w += 1) fine_nm.push_back(w);
    const Vec3d d65 = spectra::linear_rec709_to_xyz({1, 1, 1});
    for (const Illuminant lamp : {Illuminant::A, Illuminant::FL11}) {
        const WebglShader shader = make_webgl_shader(arrays, lamp);
        const Vec3d white = spectra::white_point(fine_nm, lamp, Observer::cie1931_2deg);
        double largest = 0, worst = 0, worst_in_daylight = 0;
        for (const double theta_o : {0.0, 30.0, 50.0, 75.0}) {
            const spectra::Spectrum spectrum(
                nm, paint->brdf(45 * kDegree, theta_o * kDegree, 100 * kDegree));
            std::vector<double> fine;
            for (const double w : fine_nm) fine.push_back(spectrum(w));
            const Vec3d xyz =
                spectra::reflectance_to_xyz(fine_nm, fine, lamp, Observer::cie1931_2deg);
            const Vec3d want = spectra::xyz_to_linear_rec709(spectra::adapted(xyz, white, d65));
            const Vec3d wi = direction_of(45, 0), wo = direction_of(theta_o, 100);
            const Vec3d got = shader.brdf(wi, wo), by_day = daylight.brdf(wi, wo);
            for (int c = 0; c < 3; ++c) {
                largest = std::max(largest, want[c]);
                worst = test::worse(worst, std::abs(got[c] - want[c]));
                worst_in_daylight = test::worse(worst_in_daylight, std::abs(by_day[c] - want[c]));
            }
        }
        EXPECT_GT(largest, 0.01);
        EXPECT_LT(worst, kShaderError * largest) << spectra::name(lamp);
        EXPECT_GT(worst_in_daylight, 5 * worst) << spectra::name(lamp);
    }
}

TEST(WebglShader, WhiteUnderSmoothBinderOfIndexOneIsWhite) {
    // A layer that does nothing over a white ground: 1 / pi in all three.
    paint::Recipe recipe = test::paint_of(1, {{10, {}, {}}}, 1.0);
    const WebglShader shader = make_live_webgl_shader(solved(recipe));
    const Vec3d value = shader.brdf(direction_of(20, 0), direction_of(40, 90));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], std::numbers::inv_pi, 2e-3);
}

TEST(WebglShader, WhatTexturesCannotHoldIsRefused) {
    EXPECT_THAT(test::message_of<DomainError>(
                    [] { make_live_webgl_shader(solved(rich_paint(0.6), {550})); }),
                HasSubstr("wavelengths_nm: 1; a material in RGB needs two or more"));
    paint::Recipe dense = test::paint_of(1.5, {{1, {test::flakes(70000, 0.1, 0.5)}, {}}});
    EXPECT_THAT(test::message_of<DomainError>([&] { make_live_webgl_shader(solved(dense)); }),
                HasSubstr("beyond the half floats of textures"));
}

}  // namespace
}  // namespace nacre::exchange
