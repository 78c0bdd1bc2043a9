#pragma once

#include <algorithm>
#include <cmath>

#include "nacre/core/lanes.h"

namespace nacre::sparkle {

/// How a rough clearcoat, of facets much smaller than a flake, spreads the half vector inside.
///
/// Light from the direction w outside is refracted by a facet of normal m into
///
///     w' = w / n + (cos t' - cos t / n) m
///
/// inside, t and t' the angles to m: Snell's law for vectors. To first order in the facet's slope s
/// the part of w' along the surface changes by k s, k = cos t' - cos t / n at the mean surface, on
/// the way in as on the way out, which meet facets of their own. The slope of the half vector,
/// (w_i' + w_o')_xy / (w_i' + w_o')_z, so gets a Gaussian distribution about that of a smooth coat,
/// exp(-p^2 / a^2) / (pi a^2) with
///
///     a^2 = (k_i^2 + k_o^2) alpha_c^2 / (mu_i + mu_o)^2,
///
/// ((n-1)/n)^2 alpha_c^2 / 2 near the normal. That facets which face the light are met more often,
/// and slopes of the second order, are left out.
class CoatTilt {
 public:
    CoatTilt() = default;  ///< of a smooth coat: none
    /// @param roughness  Beckmann alpha_c of the interface, 0 to 1
    /// @param ior        of the binder
    CoatTilt(double roughness, double ior)
        : roughness2_(static_cast<float>(roughness * roughness)),
          beyond_(static_cast<float>(1 - 1 / (ior * ior))) {}

    bool rough() const { return roughness2_ > 0; }
    /// a^2; the cosines are those inside a smooth coat.
    float spread2(float mu_i, float mu_o) const {
        if (!rough()) return 0;
        const float k_i = mu_i - std::sqrt(std::max(0.0f, mu_i * mu_i - beyond_));
        const float k_o = mu_o - std::sqrt(std::max(0.0f, mu_o * mu_o - beyond_));
        const float sum = std::max(mu_i + mu_o, kMinSum);
        return roughness2_ * (k_i * k_i + k_o * k_o) / (sum * sum);
    }
    /// Mean distance between the tangents (x/z, y/z) of the way in and the way out inside, which
    /// facets turn apart. To first order in the facets' slopes a tangent changes by k s / mu across
    /// the plane of incidence and by k s / mu^3 in it; the mean of both is taken for the variance of
    /// a component, and for the mean distance that of a Rice distribution to 0.5 %. Within 10 % of
    /// what facets do, as models/rough_hot_spot_test.cpp has it, where alpha_c is 0.3 at most.
    /// @param square  of the distance under a smooth coat
    float separation(float square, float mu_i, float mu_o) const {
        if (!rough()) return std::sqrt(square);
        const auto of = [this](float mu) {
            const float cosine = std::max(mu, kMinSum);
            const float k = cosine - std::sqrt(std::max(0.0f, cosine * cosine - beyond_));
            const float secant2 = 1 / (cosine * cosine);
            return k * k * secant2 * 0.25f * (1 + secant2 * secant2);
        };
        const float variance = roughness2_ * (of(mu_i) + of(mu_o));
        // Exact where the two coincide, pi/2 of the variance, and far apart, the variance itself.
        return std::sqrt(square + variance * (1 + 0.5707963f / (1 + 0.5f * square / variance)));
    }
    /// At one incident direction and eight others, which may lie beyond the critical angle.
    FloatLanes spread2(float mu_i, const FloatLanes& mu_o) const {
        if (!rough()) return FloatLanes{};
        const float k_i = mu_i - std::sqrt(std::max(0.0f, mu_i * mu_i - beyond_));
        const FloatLanes k_o = mu_o - sqrt_lanes(max_lanes(mu_o * mu_o - beyond_, FloatLanes{}));
        const FloatLanes sum = max_lanes(mu_i + mu_o, splat(kMinSum));
        return roughness2_ * (k_i * k_i + k_o * k_o) / (sum * sum);
    }

 private:
    /// Of directions that turn back at once; without a coat, where nothing is tilted.
    static constexpr float kMinSum = 0.1f;
    float roughness2_ = 0;
    float beyond_ = 0;  // the squared cosine of the critical angle
};

}  // namespace nacre::sparkle
