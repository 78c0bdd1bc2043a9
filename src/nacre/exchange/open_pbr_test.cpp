#include "nacre/exchange/open_pbr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/exchange/shading.h"

namespace nacre::exchange {
namespace {

/// Of the green channel, by a rule over the hemisphere of lamps.
double albedo_from(const OpenPbr& s, double theta_o) {
    constexpr int kPolar = 300, kAround = 300;
    double sum = 0;
    for (int i = 0; i < kPolar; ++i) {
        const double theta = (i + 0.5) / kPolar * 0.5 * std::numbers::pi;
        for (int k = 0; k < kAround; ++k) {
            sum += open_pbr_brdf(s, theta, theta_o, (k + 0.5) / kAround * 2 * std::numbers::pi)[1] *
                   std::cos(theta) * std::sin(theta);
        }
    }
    return sum * 0.5 * std::numbers::pi / kPolar * 2 * std::numbers::pi / kAround;
}

TEST(OpenPbr, AWhiteMetalReflectsAllLight) {
    OpenPbr s;
    s.base_color = {1, 1, 1};
    s.base_metalness = 1;
    s.flake_tilt = 0;
    int compared = 0;
    for (const double roughness : {0.45, 0.7, 1.0}) {
        for (const double theta : {0.1, 0.7, 1.1}) {
            s.specular_roughness = roughness;
            EXPECT_NEAR(albedo_from(s, theta), 1, 0.01) << roughness << " " << theta;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 9);
}

TEST(OpenPbr, ADiffuserUnderASmoothCoatLosesWhatTheCoatReflects) {
    OpenPbr s;
    s.base_color = {0.5, 0.5, 0.5};
    s.specular_ior = s.coat_ior;  // no interface below the coat
    s.coat_weight = 1;
    s.flake_tilt = 0;
    const double theta = 0.8, f0 = 0.04;
    const double fresnel = f0 + (1 - f0) * schlick_weight(std::cos(theta));
    // Without an interface its directional albedo is Schlick's edge alone, which it keeps.
    EXPECT_NEAR(albedo_from(s, theta), 0.5 * (1 - fresnel), 0.02);
}

// The pixel shader that MaterialX 1.39.5 generates of open_pbr_surface with these inputs, for one
// directional light, run by moderngl 5.13.0 on Mesa 22.3.6's llvmpipe; its colour over cos(theta_i).
// MaterialX takes directional albedos from a rational fit, which is off by up to 2 %.
TEST(OpenPbr, AgreesWithTheShaderOfMaterialX) {
    OpenPbr s;
    s.base_color = {0.3, 0.5, 0.7};
    s.base_metalness = 0.6;
    s.specular_color = {0.9, 0.8, 0.7};
    s.specular_roughness = 0.5;
    s.specular_ior = 1.9;
    s.coat_weight = 1;
    s.coat_roughness = 0.3;
    s.flake_tilt = 0;
    constexpr double kDegree = std::numbers::pi / 180;
    const struct {
        double theta_i, theta_o, phi;
        Vec3d f;
    } cases[] = {
        {0, 20, 0, {0.16307, 0.26117, 0.36267}},    {45, 30, 180, {0.31822, 0.48454, 0.65786}},
        {45, 60, 180, {0.56571, 0.81810, 1.08432}}, {45, 10, 90, {0.07019, 0.11659, 0.16397}},
        {60, 70, 150, {0.10189, 0.15890, 0.21745}}, {30, 75, 20, {0.03675, 0.06140, 0.08647}},
    };
    for (const auto& at : cases) {
        const Vec3d f =
            open_pbr_brdf(s, at.theta_i * kDegree, at.theta_o * kDegree, at.phi * kDegree);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(f[c], at.f[c], 0.02 * at.f[c]) << at.theta_i << " " << at.theta_o;
        }
    }
}

TEST(OpenPbr, AlbedosOfSmoothFacetsAreSchlicksLaw) {
    for (const double cosine : {0.2, 0.5, 1.0}) {
        const SplitAlbedo albedo = ggx_albedo(cosine, 1e-3);
        EXPECT_NEAR(albedo.bias, schlick_weight(cosine), 0.01) << cosine;
        EXPECT_NEAR(albedo.scale + albedo.bias, 1, 5e-3) << cosine;
    }
}

TEST(OpenPbr, TheTintIsThatAt82Degrees) {
    const Vec3d f0 = {0.1, 0.5, 0.9}, tint = {0.6, 0.8, 1};
    const double cosine = 1.0 / 7;
    const Vec3d found = tinted_schlick(cosine, f0, tint);
    for (int c = 0; c < 3; ++c) {
        const double untinted = f0[c] + (1 - f0[c]) * schlick_weight(cosine);
        EXPECT_NEAR(found[c], tint[c] * untinted, 1e-12);
        EXPECT_NEAR(tinted_schlick(1, f0, tint)[c], f0[c], 1e-12);
        EXPECT_NEAR(tinted_schlick(0, f0, tint)[c], 1, 1e-12);
    }
}

TEST(OpenPbr, NoParameterOfTheFitMakesNegativeLight) {
    const FormatModel model = open_pbr_model(true, false);
    for (const FormatParameter& p : model.parameters) {
        if (p.name.starts_with("specular_color")) {
            for (double cosine = 0; cosine <= 1; cosine += 1.0 / 512) {
                EXPECT_GE(tinted_schlick(cosine, {0, 0, 0}, {p.lo, p.lo, p.lo})[0], 0) << cosine;
            }
        }
    }
}

}  // namespace
}  // namespace nacre::exchange
