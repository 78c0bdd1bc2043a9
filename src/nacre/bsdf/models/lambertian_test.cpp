#include "nacre/bsdf/models/lambertian.h"

#include <gtest/gtest.h>

#include <numbers>

#include "nacre/core/error.h"

namespace nacre::bsdf {
namespace {

const Wavelengths kLambertianAt{410, 450, 490, 530, 570, 610, 650, 690};
const Vec3f kOblique = normalize(Vec3f{0.6f, -0.2f, 0.5f});

TEST(Lambertian, BrdfIsReflectanceOverPiAndVanishesBelowTheHorizon) {
    const auto bound = Lambertian({{400.0, 700.0}, {0.0, 1.0}}).bind(kLambertianAt);
    const FloatLanes f = bound->eval(kOblique, {0, 0, 1});
    for (int i = 0; i < kLanes; ++i) {
        const double reflectance = (kLambertianAt[i] - 400) / 300;
        EXPECT_NEAR(f[i], reflectance / std::numbers::pi, 1e-7);
    }
    EXPECT_EQ(lane_max(bound->eval(kOblique, {0, 0, -1})), 0);
    EXPECT_EQ(lane_max(bound->eval({0, 0, -1}, kOblique)), 0);
    EXPECT_EQ(bound->pdf(kOblique, {0, 0, -1}), 0);
    EXPECT_FALSE(bound->sample({0, 0, -1}, 0.5f, {0.3f, 0.6f}).has_value());
}

TEST(Lambertian, SampleWeightIsTheAlbedoAndItsPdfAgrees) {
    const auto bound = Lambertian(0.7).bind(kLambertianAt);
    int drawn = 0;
    for (int i = 0; i < 64; ++i) {
        const Vec2f u{(i % 8 + 0.5f) / 8, (i / 8 + 0.5f) / 8};
        const auto s = bound->sample(kOblique, 0.5f, u);
        ASSERT_TRUE(s.has_value());
        EXPECT_EQ(s->kind, SampleKind::density);
        EXPECT_NEAR(length(s->wo), 1, 1e-6);
        EXPECT_FLOAT_EQ(s->pdf, bound->pdf(kOblique, s->wo));
        EXPECT_FLOAT_EQ(s->weight[3], bound->albedo(kOblique)[3]);
        ++drawn;
    }
    EXPECT_EQ(drawn, 64);
}

TEST(Lambertian, MeanCosineOfSamplesIsTwoThirds) {
    // Int cos (cos / pi) dw = 2/3; the cosine ends in a square root at the horizon, so midpoints of
    // a 64 x 64 grid leave an error of order 64^-1.5.
    const auto bound = Lambertian(1.0).bind(kLambertianAt);
    double sum = 0;
    constexpr int kSide = 64;
    for (int i = 0; i < kSide * kSide; ++i) {
        const Vec2f u{(i % kSide + 0.5f) / kSide, (i / kSide + 0.5f) / kSide};
        sum += bound->sample({0, 0, 1}, 0, u)->wo.z;
    }
    EXPECT_NEAR(sum / (kSide * kSide), 2.0 / 3, 2e-3);
}

TEST(Lambertian, RefusesReflectanceOutOfRange) {
    EXPECT_THROW(Lambertian(1.01), DomainError);
    EXPECT_THROW(Lambertian(-0.01), DomainError);
}

}  // namespace
}  // namespace nacre::bsdf
