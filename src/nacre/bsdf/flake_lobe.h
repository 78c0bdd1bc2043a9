#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "nacre/core/vec.h"

// Refraction into the coat, and sampling of what flakes reflect there.

namespace nacre::bsdf {

/// The direction inside the coat of a direction outside, or of eight: the tangential part shrinks by 1/n.
template <class T>
Vec3<T> refract_in(const Vec3<T>& w, float inverse_ior) {
    const T x = w.x * inverse_ior, y = w.y * inverse_ior;
    // At n = 1 the cosine itself, which 1 - sin^2 would lose near grazing.
    if (inverse_ior == 1.0f) return {x, y, w.z};
    return {x, y, sqrt_lanes(max_lanes(1 - x * x - y * y, T{}))};
}

/// The direction outside; empty beyond the critical angle.
inline std::optional<Vec3f> refract_out(Vec3f w, float ior) {
    if (ior == 1.0f) return w;
    const float x = w.x * ior, y = w.y * ior, z2 = 1 - x * x - y * y;
    if (z2 <= 0) return std::nullopt;
    return Vec3f{x, y, std::sqrt(z2)};
}

/// Reflection off Beckmann flakes that are visible from wi, both directions inside the coat.
///
/// Slopes are Gaussian; a flake is seen with the area |w.m|, which is mu - s x up to a factor, x
/// the slope towards wi. Drawing the magnitude of x from the Gaussian and its sign with the
/// probability that the area gives is exact where |x| < c = mu/s: q(x) = p(x) clamp(1 - x/c, 0, 2).
/// Steeper slopes, which matter at grazing incidence alone, only make the weights vary, within
/// bounds. Compare visible-normal sampling of microfacets [heitz-deon-2014], which needs erf^-1.
class FlakeLobe {
 public:
    explicit FlakeLobe(float alpha)
        : alpha_(alpha),
          inverse_alpha2_(1 / (alpha * alpha)),
          norm_(std::numbers::inv_pi_v<float> / (alpha * alpha)) {}

    /// Draws a direction; u_sign decides on the sign of the slope. The result may point downwards.
    Vec3f sample(Vec3f wi, float u_sign, Vec2f u) const {
        const float s = std::sqrt(wi.x * wi.x + wi.y * wi.y);
        const float r = alpha_ * std::sqrt(-std::log(1 - u.x));
        const float angle = 2 * std::numbers::pi_v<float> * u.y;
        float x = r * std::cos(angle);
        const float y = r * std::sin(angle);
        if (x > 0 && u_sign * wi.z < x * s) x = -x;
        const float ex = s > 0 ? wi.x / s : 1.0f, ey = s > 0 ? wi.y / s : 0.0f;
        const Vec3f m = normalize(Vec3f{-(x * ex - y * ey), -(x * ey + y * ex), 1.0f});
        return 2 * dot(wi, m) * m - wi;
    }

    /// Density of sample() per solid angle inside the coat; wi and wo upwards.
    float pdf(Vec3f wi, Vec3f wo) const { return mixed_pdf(wi, wo, 1, 0); }
    FloatLanes pdf(Vec3f wi, const Vec3Lanes& wo) const {
        return make_lanes([&](int k) { return pdf(wi, lane(wo, k)); });
    }

    /// Mixture, with these weights, of pdf() and of that of a lobe with twice the roughness, whose
    /// exponential is the fourth root of this one's.
    float mixed_pdf(Vec3f wi, Vec3f wo, float weight, float wide_weight) const {
        const float hx = wi.x + wo.x, hy = wi.y + wo.y, hz = wi.z + wo.z;
        const float inverse_hz = 1 / hz;
        const float tan2 = (hx * hx + hy * hy) * inverse_hz * inverse_hz;
        const float exponent = tan2 * inverse_alpha2_;
        if (exponent > 160) return 0;
        // 1 - x/c with x/c = -(h . e_i)/h_z s/mu: no division by s.
        const float tilt = (hx * wi.x + hy * wi.y) * inverse_hz / wi.z;
        const float root = std::exp(-0.25f * exponent), square = root * root;
        const float slopes = norm_ * (weight * square * square + 0.25f * wide_weight * root);
        return slopes * std::clamp(1 + tilt, 0.0f, 2.0f) * (1 + tan2) * 0.5f * inverse_hz;
    }

 private:
    float alpha_, inverse_alpha2_, norm_;
};

/// A direction of a quadrature: how much light goes there, and the density there of each lobe of a
/// mixture.
template <std::size_t K>
struct FluxPoint {
    double flux;
    std::array<float, K> density;
};

/// Lobe probabilities of the mixture that is nearest to the flux at points in relative entropy, by
/// expectation maximisation: each round divides the flux at every point among the lobes by their
/// densities there, and takes the sums for the new probabilities.
/// [dempster-laird-rubin-1977]
/// @param fraction  initial probabilities, positive where a lobe may be used; returned unchanged
///                  where there is no flux
template <std::size_t K>
std::array<double, K> fit_mixture(const std::vector<FluxPoint<K>>& points,
                                  std::array<double, K> fraction, int rounds = 30) {
    for (int round = 0; round < rounds; ++round) {
        std::array<double, K> next{};
        for (const FluxPoint<K>& point : points) {
            double mixture = 0;
            for (std::size_t k = 0; k < K; ++k) mixture += fraction[k] * point.density[k];
            if (!(mixture > 0)) continue;
            for (std::size_t k = 0; k < K; ++k) {
                next[k] += point.flux * fraction[k] * point.density[k] / mixture;
            }
        }
        double all = 0;
        for (double x : next) all += x;
        if (!(all > 0)) break;
        for (std::size_t k = 0; k < K; ++k) fraction[k] = next[k] / all;
    }
    return fraction;
}

}  // namespace nacre::bsdf
