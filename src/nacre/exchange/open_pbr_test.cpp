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
