#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/lanes.h"

namespace nacre::sparkle {

/// How a rough clearcoat, of facets much smaller than a flake, spreads the half vector inside.
///
/// Light from the direction w outside is refracted by a facet of normal m into
///
///     w' = w / n + (cos theta' - cos theta / n) m
///
/// inside, theta and theta' the angles to m: Snell's law for vectors. To first order in the facet's slope
/// t the part of w' along the surface changes by b t, b = cos theta' - cos theta / n at the mean surface,
/// on the way in as on the way out, which meet facets of their own. The slope of the half vector,
/// (w_i' + w_o')_xy / (w_i' + w_o')_z, so gets a Gaussian distribution about that of a smooth coat,
/// P_s(t) = exp(-t^2 / alpha_s^2) / (pi alpha_s^2) with
///
///     alpha_s^2 = (b_i^2 + b_o^2) alpha_c^2 / (mu_i + mu_o)^2,
///
/// ((n-1)/n)^2 alpha_c^2 / 2 near the normal. That facets which face the light are met more often,
/// and slopes of the second order, are left out.
///
/// Derived here: the vector form of Snell's law is [born-wolf-1999, 3.2.2], the law of the facets'
/// slopes Beckmann's [walter-2007, eq. 25]. For the error see separation(), and docs/nacre-model.md.
class CoatTilt {
 public:
    CoatTilt() = default;  ///< of a smooth coat: none
    /// @param roughness  Beckmann alpha_c of the interface, 0 to 1
    /// @param ior        of the binder
    CoatTilt(double roughness, double ior)
        : roughness2_(static_cast<float>(roughness * roughness)),
          beyond_(static_cast<float>(1 - 1 / (ior * ior))) {}

    bool rough() const { return roughness2_ > 0; }
    /// alpha_s^2; the cosines are those inside a smooth coat.
    float spread2(float mu_i, float mu_o) const {
        if (!rough()) return 0;
        const float k_i = k(mu_i), k_o = k(mu_o);
        const float sum = std::max(mu_i + mu_o, kMinSum);
        return roughness2_ * (k_i * k_i + k_o * k_o) / (sum * sum);
    }
    /// At one incident direction and eight others, which may lie beyond the critical angle.
    FloatLanes spread2(float mu_i, const FloatLanes& mu_o) const {
        if (!rough()) return FloatLanes{};
        const float k_i = k(mu_i);
        const FloatLanes k_o = mu_o - sqrt_lanes(max_lanes(mu_o * mu_o - beyond_, FloatLanes{}));
        const FloatLanes sum = max_lanes(mu_i + mu_o, splat(kMinSum));
        return roughness2_ * (k_i * k_i + k_o * k_o) / (sum * sum);
    }
    /// Mean distance delta_c between the tangents (x/z, y/z) of the way in and the way out inside, which
    /// facets turn apart. To first order in the facets' slopes a tangent changes by b t / mu across
    /// the plane of incidence and by b t / mu^3 in it. The mean of both is taken for the variance of
    /// a component, and the distance has a Rice distribution then, whose mean is here within 0.5 %;
    /// it is within 10 % of what facets do for alpha_c up to 0.3.          [rice-1945, sec. 3.10]
    /// @param square  of the distance under a smooth coat, delta^2
    float separation(float square, float mu_i, float mu_o) const {
        if (!rough()) return std::sqrt(square);
        const auto of = [this](float mu) {
            const float cosine = std::max(mu, kMinSum), secant2 = 1 / (cosine * cosine);
            return k(cosine) * k(cosine) * secant2 * 0.25f * (1 + secant2 * secant2);
        };
        // Above 0, as it divides below: an index of nearly 1 turns nothing.
        const float variance = std::max(roughness2_ * (of(mu_i) + of(mu_o)), 1e-12f);
        // Exact where the two coincide, pi/2 of the variance, and far apart, the variance itself.
        constexpr float kMore = std::numbers::pi_v<float> / 2 - 1;
        return std::sqrt(square + variance * (1 + kMore / (1 + 0.5f * square / variance)));
    }

 private:
    /// b = cos theta' - cos theta / n, from the cosine inside.
    float k(float mu) const { return mu - std::sqrt(std::max(0.0f, mu * mu - beyond_)); }

    /// Of directions that turn back at once; without a coat, where nothing is tilted.
    static constexpr float kMinSum = 0.1f;
    float roughness2_ = 0;
    float beyond_ = 0;  // the squared cosine of the critical angle
};

}  // namespace nacre::sparkle
