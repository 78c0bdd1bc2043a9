#include "nacre/bsdf/reflection_warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/core/random.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/statistics.h"

namespace nacre::bsdf {
namespace {

using test::direction;

float lambertian(Vec3f, Vec3f wo) { return wo.z * std::numbers::inv_pi_v<float>; }

/// Flakes of roughness alpha that are seen from outside of a coat, without loss: no BRDF of a paint,
/// but a flux with a peak.
ReflectionWarp::Flux peak(float ior, float alpha) {
    return [=](Vec3f wi, Vec3f wo) {
        const Vec3f h = refract_in(wi, 1 / ior) + refract_in(wo, 1 / ior);
        const float slope2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
        return wo.z * std::exp(-slope2 / (alpha * alpha));
    };
}

/// Mean and variance, over samples, of what white light gives.
struct Weights {
    double mean, mean_error, relative_variance, lost;
};

Weights weights_of(const ReflectionWarp& warp, const ReflectionWarp::Flux& flux, float ior,
                   double theta_deg, double phi_deg) {
    constexpr int kSamples = 40000;
    const Vec3f wi = direction(theta_deg, phi_deg), inside = refract_in(wi, 1 / ior);
    const ReflectionWarp::Incident incident{wi, inside,
                                            std::sqrt(wi.x * wi.x + wi.y * wi.y) / (1 + wi.z)};
    Rng rng(3, 1);
    double sum = 0, squares = 0;
    int lost = 0;
    for (int n = 0; n < kSamples; ++n) {
        const auto wo = warp.sample(incident, {rng.uniform_float(), rng.uniform_float()});
        if (!wo || wo->z <= 0) {
            ++lost;
            continue;
        }
        const Vec3f out = refract_in(*wo, 1 / ior), half = inside + out;
        const double angles = ior * ior * out.z / wo->z * 2 * half.z * half.z * half.z /
                              dot(half, half);  // solid angles outside per area of slopes
        const double weight = flux(wi, *wo) * angles / warp.slope_pdf(incident, half);
        sum += weight;
        squares += weight * weight;
    }
    const double mean = sum / kSamples, relative = squares / kSamples / (mean * mean) - 1;
    return {mean, mean * std::sqrt(relative / kSamples), relative,
            static_cast<double>(lost) / kSamples};
}

// A white diffuser has the albedo 1 from everywhere. As its light reaches up to the edge of total
// reflection, where a paint's is nearly nil, it is the hardest: cells at the edge are drawn from with
// their mean.
TEST(ReflectionWarp, FollowsADiffuserUnderAnyCoat) {
    for (const float ior : {1.0f, 1.33f, 1.5f, 2.4f}) {
        for (const float alpha : {0.02f, 0.1f, 0.5f}) {
            const ReflectionWarp warp(ior, alpha, lambertian);
            for (const double theta : {0.0, 20.0, 55.0, 75.0}) {
                SCOPED_TRACE(testing::Message()
                             << "n " << ior << ", alpha " << alpha << ", theta " << theta);
                const Weights w = weights_of(warp, lambertian, ior, theta, 130);
                EXPECT_NEAR(w.mean, 1, test::kWorstZ * w.mean_error);
                // Found: 0.22 and 0.10.
                EXPECT_LT(w.relative_variance, 0.3);
                EXPECT_LT(w.lost, 0.15);
                EXPECT_NEAR(warp.albedo(std::tan(static_cast<float>(theta) *
                                                 std::numbers::pi_v<float> / 360)),
                            1, ReflectionWarp::kWorstAlbedoError);
            }
        }
    }
}

TEST(ReflectionWarp, FollowsAPeakNarrowerAndWiderThanItsScale) {
    constexpr float kIor = 1.5f;
    for (const float scale : {0.5f, 1.0f, 3.0f}) {
        const ReflectionWarp::Flux flux = peak(kIor, 0.1f);
        const ReflectionWarp warp(kIor, 0.1f * scale, flux);
        for (const double theta : {10.0, 40.0, 65.0, 80.0}) {
            const Weights w = weights_of(warp, flux, kIor, theta, 20);
            // Found: 0.021 and 0.014.
            EXPECT_LT(w.relative_variance, 0.05) << scale << ' ' << theta;
            EXPECT_LT(w.lost, 0.03) << scale << ' ' << theta;
        }
    }
}

}  // namespace
}  // namespace nacre::bsdf
