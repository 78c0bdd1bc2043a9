#include "nacre/sparkle/reflection_cone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/paint/beckmann.h"
#include "nacre/testing/directions.h"

namespace nacre::sparkle {
namespace {

using test::direction;

TEST(ReflectionCone, HoldsTheFacetsThatMirrorIntoIt) {
    const double gamma = 3 * kDegree;
    const Vec3f wi = direction(40, 0), wo = direction(50, 170);
    const ReflectionCone cone(wi, wo, ConeRule(gamma, 0.1).chord2());
    Rng rng(1);
    int in = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f m = direction(12 * rng.uniform_double(), 360 * rng.uniform_double());
        const Vec3f r = 2 * dot(wi, m) * m - wi;
        const double angle = std::atan2(length(cross(r, wo)), dot(r, wo));
        if (std::abs(angle - gamma) < 1e-5) continue;  // the edge, to the accuracy of a float
        EXPECT_EQ(cone.contains(m), angle < gamma);
        in += angle < gamma;
    }
    EXPECT_GT(in, 100);
}

TEST(ConeRule, SolidAngleIsThatOfTheCap) {
    EXPECT_NEAR(ConeRule(3 * kDegree, 0.1).solid_angle(),
                2 * std::numbers::pi * (1 - std::cos(3 * kDegree)), 1e-15);
}

// Against a rule of a million directions.
TEST(ConeRule, MeansAreIntegralsOverTheCone) {
    for (const double gamma_deg : {1.0, 3.0, 10.0}) {
        for (const double alpha : {0.03, 0.07, 0.3}) {
            const ConeRule rule(gamma_deg * kDegree, alpha);
            for (const auto& [wi, wo] : {std::pair{direction(30, 0), direction(30, 180)},
                                         std::pair{direction(20, 0), direction(24, 170)},
                                         std::pair{direction(70, 0), direction(66, 178)},
                                         std::pair{direction(85, 0), direction(84, 181)}}) {
                const auto means = rule.means(wi, wo);
                const double bound = wi.z < 0.26f ? kConeRuleGrazingError : kConeRuleError;
                double density = 0, projected = 0;
                constexpr int kSide = 400;
                for (int i = 0; i < kSide; ++i) {
                    for (int j = 0; j < kSide; ++j) {
                        const Vec3f h =
                            wi + rule.sample(wo, {(i + 0.5f) / kSide, (j + 0.5f) / kSide});
                        if (h.z <= 0) continue;
                        const double tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
                        const double cosine = h.z / length(h);
                        const double d = 2 * paint::flake_density(tan2, alpha) / cosine;
                        density += d;
                        projected += d * cosine / (4 * dot(wi, normalize(h)));
                    }
                }
                const double n = kSide * kSide;
                const double scale = 1 / (std::numbers::pi * alpha * alpha);
                EXPECT_NEAR(means.density, density / n, bound * scale)
                    << gamma_deg << " deg, alpha " << alpha;
                EXPECT_NEAR(means.projected, projected / n, bound * scale / (2 * length(wi + wo)))
                    << gamma_deg << " deg, alpha " << alpha;
            }
        }
    }
}

TEST(ConeRule, RefusesConesThatItCannotResolve) {
    EXPECT_THROW(ConeRule(0, 0.1), DomainError);
    EXPECT_THROW(ConeRule(3, 0.1), DomainError);
    EXPECT_THROW(ConeRule(10 * kDegree, 0.005), DomainError);
    EXPECT_NO_THROW(ConeRule(10 * kDegree, 0.0075));
}

TEST(ConeRule, IsReciprocal) {
    const ConeRule rule(3 * kDegree, 0.07);
    const Vec3f a = direction(35, 10), b = direction(31, 185);
    EXPECT_NEAR(rule.means(a, b).projected, rule.means(b, a).projected,
                1e-4 * rule.means(a, b).projected);
}

}  // namespace
}  // namespace nacre::sparkle
