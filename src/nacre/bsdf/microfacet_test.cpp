#include "nacre/bsdf/microfacet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/quadrature.h"
#include "nacre/core/random.h"
#include "nacre/testing/bsdf.h"

namespace nacre::bsdf {
namespace {

using paint::FacetDistribution;
// Int f(m) dm over the upper hemisphere, in the radius of stretched slopes tan = alpha r, r =
// t/(1-t).
template <class F>
double over_normals(double alpha, F&& f) {
    const Quadrature& radial = unit_gauss_legendre(200);
    constexpr int kAzimuths = 400;
    double sum = 0;
    for (std::size_t k = 0; k < radial.nodes.size(); ++k) {
        const double t = radial.nodes[k], tangent = alpha * t / (1 - t);
        const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
        // d omega = tan cos^3 d tan d phi
        const double weight = radial.weights[k] * alpha / ((1 - t) * (1 - t)) * tangent *
                              std::pow(cosine, 3) * 2 * std::numbers::pi / kAzimuths;
        for (int a = 0; a < kAzimuths; ++a) {
            const double phi = 2 * std::numbers::pi * (a + 0.5) / kAzimuths;
            sum += weight *
                   f(Vec3f{static_cast<float>(sine * std::cos(phi)),
                           static_cast<float>(sine * std::sin(phi)), static_cast<float>(cosine)});
        }
    }
    return sum;
}

TEST(MicrofacetDistribution, CoversTheMeanSurfaceOnce) {
    for (const auto law : kFacetLaws) {
        for (const double alpha : {0.01, 0.1, 0.5, 1.0}) {
            const MicrofacetDistribution facets(law, alpha);
            const double area =
                over_normals(alpha, [&](Vec3f m) { return facets.density(m) * m.z; });
            EXPECT_NEAR(area, 1, 1e-5);
        }
    }
}

// What Smith's masking is made for: the visible facets fill the view.       [heitz-2014]
TEST(MicrofacetDistribution, VisibleFacetsFillTheView) {
    for (const auto law : kFacetLaws) {
        for (const double alpha : {0.05, 0.3, 1.0}) {
            const MicrofacetDistribution facets(law, alpha);
            for (const double theta : {0.0, 40.0, 70.0, 85.0, 89.0}) {
                const Vec3f w = direction(theta, 30);
                const float lambda = facets.lambda(w);
                const double all = over_normals(
                    alpha, [&](Vec3f m) { return facets.visible_density(w, lambda, m); });
                // The kink where facets turn away costs the azimuthal sums some digits: found 4e-7.
                EXPECT_NEAR(all, 1, 1e-5) << "alpha " << alpha << ", theta " << theta;
            }
        }
    }
}

TEST(MicrofacetDistribution, DrawsTheMeanVisibleNormal) {
    for (const auto law : kFacetLaws) {
        for (const double alpha : {0.01, 0.3, 1.0}) {
            const MicrofacetDistribution facets(law, alpha);
            for (const double theta : {0.0, 30.0, 80.0, 89.5}) {
                const Vec3f w = direction(theta, 70);
                const float lambda = facets.lambda(w);
                // A bounded function of the normal that sees tilt and side.
                const auto f = [&](Vec3f m) {
                    const double tan2 = (m.x * m.x + m.y * m.y) / (alpha * alpha * m.z * m.z);
                    return (1 + dot(m, w)) / (1 + tan2);
                };
                const double expected = over_normals(
                    alpha, [&](Vec3f m) { return facets.visible_density(w, lambda, m) * f(m); });
                Rng rng(3, 1);
                constexpr int kSamples = 40000;
                double sum = 0, square = 0;
                for (int i = 0; i < kSamples; ++i) {
                    const Vec3f m =
                        facets.sample_visible(w, {rng.uniform_float(), rng.uniform_float()});
                    ASSERT_NEAR(length(m), 1, 1e-5);
                    ASSERT_GT(m.z, 0);
                    sum += f(m);
                    square += f(m) * f(m);
                }
                const double mean = sum / kSamples;
                const double error = std::sqrt((square / kSamples - mean * mean) / kSamples);
                EXPECT_NEAR(mean, expected, 4 * error + 1e-3)
                    << "alpha " << alpha << ", theta " << theta;
            }
        }
    }
}

TEST(VisibleBeckmannSlope, InvertsItsDistribution) {
    const auto below = [](double cot, double x) {
        return 0.5 * cot * (1 + std::erf(x)) + 0.5 * std::numbers::inv_sqrtpi * std::exp(-x * x);
    };
    int tried = 0;
    for (const float cot : {0.0f, 0.01f, 0.2f, 0.7f, 1.0f, 2.0f, 4.0f, 30.0f, 1e6f}) {
        const double c = cot;
        for (float u = 0.0005f; u < 1; u += 0.0097f, ++tried) {
            const double x = sample_visible_beckmann_slope(cot, u);
            ASSERT_LE(x, c + 1e-5);
            EXPECT_NEAR(below(c, x) / below(c, c), u, kVisibleSlopeError) << cot << " " << u;
        }
    }
    EXPECT_GT(tried, 500);
}

}  // namespace
}  // namespace nacre::bsdf
