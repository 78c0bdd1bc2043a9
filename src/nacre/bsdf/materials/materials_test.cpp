#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/bsdf/materials/conductor.h"
#include "nacre/bsdf/materials/diffuse_picture.h"
#include "nacre/bsdf/materials/glass.h"
#include "nacre/bsdf/materials/plastic.h"
#include "nacre/core/error.h"
#include "nacre/optics/fresnel.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/errors.h"

namespace nacre::bsdf {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

const Wavelengths kMaterialsAt{410, 450, 490, 530, 570, 610, 650, 690};
constexpr double kMaterialAngles_deg[] = {0, 20, 45, 60, 75, 85};

// ------------------------------------------------------------------------------- conductor

TEST(Conductor, ReflectsWhatFresnelsAmplitudesSay) {
    for (const char* name : {"Cr", "Au", "Al"}) {
        const optics::Material metal = optics::find_material(name);
        const auto bound = Conductor(metal, 0).bind(kMaterialsAt);
        for (const double theta : kMaterialAngles_deg) {
            const Vec3f wi = direction(theta, 30);
            const auto s = bound->sample(wi, 0.3f, {0.1f, 0.7f});
            ASSERT_TRUE(s.has_value());
            EXPECT_EQ(s->kind, SampleKind::specular);
            for (int lane = 0; lane < kLanes; ++lane) {
                const auto r = optics::fresnel(1.0, metal.index(kMaterialsAt[lane]), double{wi.z});
                const double expected = 0.5 * (std::norm(r.r_s) + std::norm(r.r_p));
                EXPECT_NEAR(s->weight[lane], expected, 3e-6) << name << ' ' << theta;
            }
        }
    }
}

TEST(Conductor, ItsRoughFaceIsReciprocalAndSampledByItsDensity) {
    const auto bound = Conductor(optics::find_material("Au"), 0.4).bind(kMaterialsAt);
    expect_reciprocal(*bound, 500, 1e-4f, 2e-4f);
    for (const double theta : {10.0, 50.0, 75.0}) {
        EXPECT_LT(std::abs(chi_square_z_score(*bound, direction(theta, 20), 11, 200'000)), 4);
    }
}

TEST(Conductor, ARoughPerfectMirrorLosesNothing) {
    const optics::Material mirror(optics::ComplexIndex(0.001, 1000));
    for (const double roughness : {0.05, 0.5, 1.0}) {
        const auto bound = Conductor(mirror, roughness).bind(kMaterialsAt);
        for (const double theta : {5.0, 45.0, 75.0}) {
            const auto white = mean_weight(*bound, direction(theta, 0), 3, 100'000, 5);
            EXPECT_NEAR(white.mean, 1, 4 * white.error + 2e-3) << roughness << ' ' << theta;
            EXPECT_NEAR(bound->albedo(direction(theta, 0))[3], 1, 1e-2);
        }
    }
}

// --------------------------------------------------------------------------------- plastic

TEST(Plastic, AWhiteBodyLosesNothingUnderAnyFace) {
    for (const double roughness : {0.0, 0.1, 0.5, 1.0}) {
        const auto bound = Plastic(1.0, optics::Material(1.5), roughness).bind(kMaterialsAt);
        for (const double theta : kMaterialAngles_deg) {
            const auto white = mean_weight(*bound, direction(theta, 0), 2, 40'000, 3);
            EXPECT_NEAR(white.mean, 1, 4 * white.error + 2e-3) << roughness << ' ' << theta;
            EXPECT_NEAR(bound->albedo(direction(theta, 0))[2], 1, 1e-4);
        }
    }
}

TEST(Plastic, UnderASmoothFaceItIsSaundersonsFormula) {
    // Diffuse light on n = 1.5 is reflected by .0918 from outside and, so, by 1 - (1 - .0918) / n^2
    // = .5963 from inside (an integral of Fresnel's equations).
    const auto bound = Plastic(0.4, optics::Material(1.5), 0).bind(kMaterialsAt);
    const double face = optics::fresnel_dielectric(1.5, 1.0), inside = 1 - (1 - 0.09178) / 2.25;
    const double expected =
        (1 - face) * (1 - face) * 0.4 / (2.25 * std::numbers::pi * (1 - 0.4 * inside));
    EXPECT_NEAR(bound->eval({0, 0, 1}, {0, 0, 1})[4], expected, 1e-4 * expected);
}

TEST(Plastic, IsReciprocalAndSampledByItsDensity) {
    const auto bound = Plastic(0.5, optics::Material(1.5), 0.35).bind(kMaterialsAt);
    expect_reciprocal(*bound, 500);
    for (const double theta : {10.0, 60.0}) {
        EXPECT_LT(std::abs(chi_square_z_score(*bound, direction(theta, 20), 12, 200'000)), 4);
    }
}

TEST(Plastic, RefusesWhatItIsNot) {
    EXPECT_THAT(message_of<DomainError>([] { Plastic(1.2, optics::Material(1.5), 0); }),
                HasSubstr("1.2"));
    EXPECT_THAT(message_of<DomainError>([] { Plastic(0.2, optics::find_material("Cr"), 0); }),
                HasSubstr("absorbs"));
    EXPECT_THAT(message_of<DomainError>([] { Plastic(0.2, optics::Material(1.5), 1e-4); }),
                HasSubstr("roughness = 0.0001 is neither 0 nor in [0.001, 1]"));
}

// ----------------------------------------------------------------------------------- glass

TEST(Glass, SmoothFacesReflectByFresnelAndRefractBySnell) {
    const Glass glass(optics::Material(1.5), 0.0, 0);
    const auto outside = glass.bind(kMaterialsAt);
    for (const BoundBsdf* side : {outside.get(), &outside->from_behind()}) {
        const float index = side == outside.get() ? 1.5f : 1 / 1.5f;
        for (const double theta : kMaterialAngles_deg) {
            const Vec3f wi = direction(theta, 200);
            const float reflected = optics::fresnel_dielectric(index, wi.z);
            const auto mirrored = side->sample(wi, 0.999f * reflected, {});
            ASSERT_TRUE(mirrored.has_value());
            EXPECT_GT(mirrored->wo.z, 0);
            EXPECT_FLOAT_EQ(mirrored->pdf, reflected);
            const auto refracted = side->sample(wi, std::min(0.9999999f, reflected + 1e-6f), {});
            if (reflected == 1) {  // total reflection
                EXPECT_GT(refracted->wo.z, 0);
                continue;
            }
            ASSERT_TRUE(refracted.has_value());
            EXPECT_LT(refracted->wo.z, 0);
            EXPECT_NEAR(index * refracted->wo.x, -wi.x, 1e-6);
            EXPECT_NEAR(index * refracted->wo.y, -wi.y, 1e-6);
            EXPECT_NEAR(length(refracted->wo), 1, 1e-6);
            EXPECT_EQ(refracted->weight[0], 1);
        }
    }
}

// Of radiance as L / n^2, by solid angles in air: f n_o^2 is the same both ways.
TEST(Glass, RoughFacesAreReciprocal) {
    const auto outside = Glass(optics::Material(1.5), 0.0, 0.3).bind(kMaterialsAt);
    const BoundBsdf& inside = outside->from_behind();
    Rng rng(3, 1);
    int lit = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3f above = direction(89 * rng.uniform_double(), 360 * rng.uniform_double());
        const Vec3f turned = direction(89 * rng.uniform_double(), 360 * rng.uniform_double());
        const Vec3f below{turned.x, turned.y, -turned.z};
        const float down = outside->eval(above, below)[0];
        const float up = inside.eval(turned, {above.x, above.y, -above.z})[0];
        EXPECT_NEAR(down, 2.25f * up, 1e-4f + 1e-3f * down);
        lit += down > 1e-3f;
    }
    EXPECT_GT(lit, 100);
    expect_reciprocal(*outside, 300);
    expect_reciprocal(inside, 300);
}

TEST(Glass, RoughFacesAreSampledByTheirDensityOnBothSides) {
    const auto outside = Glass(optics::Material(1.5), 0.0, 0.5).bind(kMaterialsAt);
    for (const BoundBsdf* side : {outside.get(), &outside->from_behind()}) {
        for (const double theta : {10.0, 35.0, 70.0}) {
            const Vec3f wi = direction(theta, 20);
            // The density of the whole sphere by samples and by midpoints, in 8 zones.
            constexpr int kZones = 8, kSamples = 200'000, kFine = 400;
            double drawn[kZones] = {}, expected[kZones] = {};
            Rng rng(21, 1);
            double weight = 0;
            for (int i = 0; i < kSamples; ++i) {
                const auto s = side->sample(wi, rng.uniform_float(),
                                            {rng.uniform_float(), rng.uniform_float()});
                if (!s) continue;
                ASSERT_NEAR(side->pdf(wi, s->wo), s->pdf, 1e-3f * s->pdf);
                ++drawn[std::min(kZones - 1, static_cast<int>((s->wo.z + 1) * kZones / 2))];
                weight += s->weight[1];
            }
            for (int c = 0; c < kFine; ++c) {
                const double z = 2 * (c + 0.5) / kFine - 1, sine = std::sqrt(1 - z * z);
                for (int a = 0; a < kFine; ++a) {
                    const double phi = 2 * std::numbers::pi * (a + 0.5) / kFine;
                    const Vec3f wo{static_cast<float>(sine * std::cos(phi)),
                                   static_cast<float>(sine * std::sin(phi)), static_cast<float>(z)};
                    expected[c * kZones / kFine] +=
                        side->pdf(wi, wo) * 4 * std::numbers::pi / (kFine * kFine) * kSamples;
                }
            }
            for (int zone = 0; zone < kZones; ++zone) {
                EXPECT_NEAR(drawn[zone], expected[zone],
                            5 * std::sqrt(expected[zone] + 1) + 2e-3 * kSamples)
                    << theta << ' ' << zone;
            }
            EXPECT_LT(weight / kSamples, 1.001);
            EXPECT_GT(weight / kSamples, 0.6);  // facets that meet are not followed
        }
    }
}

TEST(Glass, OfTheIndexOfItsSurroundingIsNotSeen) {
    const auto bound = Glass(optics::Material(1.0), 0.0, 0.1).bind(kMaterialsAt);
    const Vec3f wi = direction(40, 10);
    const auto s = bound->sample(wi, 0.3f, {0.2f, 0.7f});
    ASSERT_TRUE(s.has_value());
    EXPECT_EQ(s->kind, SampleKind::specular);
    EXPECT_NEAR(length(s->wo + wi), 0, 1e-6);
    EXPECT_EQ(s->weight[0], 1);
}

TEST(Glass, RefusesAnIndexBelowOne) {
    EXPECT_THAT(message_of<DomainError>([] { Glass(optics::Material(0.8), 0.0, 0); }),
                HasSubstr("is 0.8 at 550 nm; glass and plastic take one of at least 1"));
}

TEST(Glass, AbsorbsAlongTheWayInside) {
    const auto outside = Glass(optics::Material(1.5), 0.02, 0).bind(kMaterialsAt);
    EXPECT_EQ(outside->transmittance(30)[2], 1);
    EXPECT_NEAR(outside->from_behind().transmittance(30)[2], std::exp(-0.6), 1e-6);
}

TEST(Pane, HasBothFacesReflectionsAndLosesOnlyWhatItAbsorbs) {
    const auto clear = Pane(optics::Material(1.5), 0.0, 4).bind(kMaterialsAt);
    const auto tinted = Pane(optics::Material(1.5), 0.1, 4).bind(kMaterialsAt);
    for (const double theta : kMaterialAngles_deg) {
        const Vec3f wi = direction(theta, 0);
        const auto amplitudes = optics::fresnel(1.0, 1.5, double{wi.z});
        const double t = std::exp(-0.4 / optics::refracted_cos(1.0, 1.5, double{wi.z}));
        double clear_through = 0, through = 0, back = 0;
        for (const auto r : {amplitudes.r_s, amplitudes.r_p}) {
            const double f = std::norm(r);
            // Without absorption the series of reflections is (1 - f) / (1 + f).
            clear_through += 0.5 * (1 - f) / (1 + f);
            // The series, term by term.
            back += 0.5 * f;
            double inside = 0.5 * (1 - f) * t;
            for (int i = 0; i < 60; ++i) {
                through += inside * (1 - f);
                inside *= f * t;
                back += inside * (1 - f);
                inside *= f * t;
            }
        }
        EXPECT_NEAR(clear->null_transmission(wi)[5], clear_through, 1e-5);
        EXPECT_NEAR(clear->albedo(wi)[5], 1, 1e-5);
        EXPECT_NEAR(tinted->null_transmission(wi)[5], through, 1e-5);
        EXPECT_NEAR(tinted->albedo(wi)[5], through + back, 1e-5);
        const auto white = mean_weight(*tinted, wi, 5, 20'000, 9);
        EXPECT_NEAR(white.mean, through + back, 4 * white.error + 1e-5);
    }
}

// -------------------------------------------------------------------------------- picture

TEST(DiffusePicture, ReadsItsPixelsFromTheTopAndBlendsBetweenTheirMiddles) {
    // Left column: black over white; right column: gray .25 over .75.
    const DiffusePicture picture(
        {2, 2, {0, 0, 0, 0.25f, 0.25f, 0.25f, 1, 1, 1, 0.75f, 0.75f, 0.75f}});
    const auto bound = picture.bind(kMaterialsAt);
    const Vec3f up{0, 0, 1};
    const auto patch_at = [](double u, double v) {
        Patch patch;
        patch.u = u;
        patch.v = v;
        return patch;
    };
    const auto reflectance = [&](double u, double v) {
        return bound->evaluate_on(patch_at(u, v), up, up).f[4] * std::numbers::pi_v<float>;
    };
    EXPECT_NEAR(reflectance(0.25, 0.75), 0, 1e-6);
    EXPECT_NEAR(reflectance(0.75, 0.75), 0.25, 1e-6);
    EXPECT_NEAR(reflectance(0.25, 0.25), 1, 1e-6);
    EXPECT_NEAR(reflectance(0.75, 0.25), 0.75, 1e-6);
    EXPECT_NEAR(reflectance(0.5, 0.5), 0.5, 1e-6);
    EXPECT_NEAR(reflectance(0, 0.25), 0.875, 1e-6);  // half way round the edge
    EXPECT_NEAR(bound->albedo(up)[4], 0.5, 1e-6);
}

TEST(DiffusePicture, ItsMeanIsThatOfMillionsOfPixels) {
    constexpr int kWidth = 1920, kHeight = 1080;
    const DiffusePicture picture(
        {kWidth, kHeight, std::vector<float>(std::size_t{3} * kWidth * kHeight, 0.1f)});
    EXPECT_NEAR(picture.bind(kMaterialsAt)->albedo({0, 0, 1})[4], 0.1, 1e-4);
}

TEST(DiffusePicture, RefusesWhatNoSurfaceReflects) {
    EXPECT_THAT(message_of<DomainError>([] {
                    DiffusePicture({1, 1, {0.5f, 1.5f, 0}});
                }),
                HasSubstr("1.5; allowed: 0 to 1"));
    EXPECT_THAT(message_of<DomainError>([] {
                    DiffusePicture({2, 1, {0.5f, 0.5f, 0}});
                }),
                HasSubstr("2 x 1"));
}

}  // namespace
}  // namespace nacre::bsdf
