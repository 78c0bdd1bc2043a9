#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "nacre/core/vec.h"

namespace nacre::sparkle {

/// How a flat flake spreads what it mirrors: diffraction at a disc, seen by the half vector.
///
/// A disc of diameter d mirrors w_i into directions w_o with the Airy pattern of
/// x = pi d |q| / lambda', where q is the part of w_i + w_o parallel to the disc and lambda' the
/// wavelength in the binder [born-wolf-1999, section 8.5.2]. As w_i + w_o = 2 (w_i.h) h, that is a
/// lobe of the half vector h about the normal m, alike in all directions, of an angle
/// proportional to 1 / (d w_i.h): it depends on h alone and is reciprocal. Here the pattern is
/// replaced by
///
///     K(p) = 3 / (pi w^2) (1 - |p - p_m|^2 / w^2)^2     for |p - p_m| < w,
///
/// over slopes p = (h_x, h_y) / h_z, with the radius that gives the same integral of K^2: the same
/// contrast of the light that many flakes mirror. It takes the place of the Airy pattern at
/// 550 nm at all wavelengths.
///
/// So that the mean over flakes whose slopes are Gaussian is exactly the distribution of slopes P,
/// and not P blurred by K, shares are K / (P convolved with K) instead of K / P.
class DiffractionLobe {
 public:
    /// @param alpha  Beckmann roughness of the flakes
    /// @param ior    of the binder
    DiffractionLobe(double alpha, double ior);

    /// The radius in slopes at perpendicular incidence on a flake of this diameter.
    double radius(double diameter_um) const;

    /// The radius for a half vector of this slope and w_i . h = cosine, of a flake whose
    /// radius() is `radius`: solid angle is what diffraction keeps, and sec^3 slopes make one.
    float radius_at(float radius, float sec2, float cosine) const {
        const float sec = std::sqrt(sec2);
        return std::min(radius * sec * std::sqrt(sec) / std::max(cosine, kLeastCosine), most_);
    }

    /// K(p) per unit square of slopes, distance2 = |p - p_m|^2 < width^2.
    static float density(float distance2, float width) {
        const float inverse = 1 / (width * width), t = 1 - distance2 * inverse;
        return 3 * std::numbers::inv_pi_v<float> * inverse * t * t;
    }
    /// The Gaussian distribution of slopes convolved with K, over its own density, at the slope
    /// whose square is slope2.
    float blur(float slope2, float width) const;
    /// P, per unit square of slopes.
    float slope_density(float slope2) const { return norm_ * std::exp(-slope2 * inverse_alpha2_); }

    /// Beyond this square of the slope over alpha flakes are not told apart: one in a million lies
    /// there.
    static constexpr float kMostExponent = 14;
    bool reaches(float slope2) const { return slope2 * inverse_alpha2_ < kMostExponent; }

 private:
    /// At grazing incidence, which a clearcoat rules out, the lobe stops growing.
    static constexpr float kLeastCosine = 0.1f;

    float inverse_alpha2_, norm_, most_, radius_um_;
    std::shared_ptr<const std::vector<float>> blur_table_;
};

}  // namespace nacre::sparkle
