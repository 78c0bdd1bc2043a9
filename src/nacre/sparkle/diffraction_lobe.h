#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"

namespace nacre::sparkle {

/// How a flat flake spreads the light that it reflects: diffraction at a disc, as a lobe of half
/// vectors.
///
/// A disc of diameter d reflects w_i into directions w_o with the Airy pattern of
/// x = pi d |q| / lambda', where q is the part of w_i + w_o parallel to the disc and lambda' the
/// wavelength in the binder [born-wolf-1999, section 8.5.2]. As w_i + w_o = 2 (w_i.h) h, that is a
/// lobe of the half vector h about the normal m, isotropic, of an angle
/// proportional to 1 / (d w_i.h): it depends on h alone and is reciprocal. Here the pattern A is
/// replaced by a lobe that holds e = kLobePower of the light,
///
///     K(p) = 3 / (pi w^2) (1 - |p - p_m|^2 / w^2)^2     for |p - p_m| < w,
///
/// over slopes p = (h_x, h_y) / h_z, and rings so wide that those of many flakes add up to an even
/// background. With the radius for which the integral of (e K)^2 is that of A^2, the contrast of
/// the light that many flakes reflect of a small lamp is the same; e makes that of wide lamps right
/// within kContrastError. The radius is that of 550 nm at all wavelengths; the true one goes with
/// the wavelength, 0.73 times it at 400 nm and 1.27 times at 700 nm.
///
/// So that the mean over flakes whose slopes are Gaussian is exactly the distribution of slopes P,
/// and not P blurred by the pattern, the flakes of slope p_m count as lobe_fraction() times K / (P convolved
/// with K), and the background as the rest to 1.
class DiffractionLobe {
 public:
    /// @param alpha  Beckmann roughness of the flakes
    /// @param ior    of the binder
    /// @throws DomainError naming the argument, its value and its range
    DiffractionLobe(double alpha, double ior);

    /// The radius in slopes at perpendicular incidence on a flake of this diameter.
    template <class V>
    V radius(V diameter_um) const {
        return radius_um_ / diameter_um;
    }

    /// Factor from radius() to the radius for a half vector with sec2 = 1 + slope^2 and
    /// w_i . h = cosine: diffraction fixes the lobe's solid angle, and sec^3 is the area of slopes
    /// per solid angle.
    float widening(float sec2, float cosine) const {
        const float sec = std::sqrt(sec2);
        return sec * std::sqrt(sec) / std::max(cosine, kMinCosine);
    }
    /// The radius then, at most max_radius().
    FloatLanes radius_at(FloatLanes radius, FloatLanes sec2, FloatLanes cosine) const {
        const FloatLanes sec = sqrt_lanes(sec2);
        return min_lanes(radius * sec * sqrt_lanes(sec) / max_lanes(cosine, splat(kMinCosine)),
                         splat(max_radius_));
    }
    /// 4 alpha: beyond it P is negligible, and a wider lobe would change nothing.
    float max_radius() const { return max_radius_; }

    /// K(p) per unit area of slopes, distance2 = |p - p_m|^2 < width^2.
    static float density(float distance2, float width) {
        const float inverse = 1 / (width * width), t = 1 - distance2 * inverse;
        return 3 * std::numbers::inv_pi_v<float> * inverse * t * t;
    }
    /// The Gaussian distribution of slopes convolved with K, over its own density, at the slope
    /// whose square is slope2.
    /// @param slope2  at most kMaxExponent alpha^2
    /// @param width   at most max_radius()
    float blur(float slope2, float width) const;
    static constexpr double kBlurError = 1e-3;  ///< relative

    /// e, the fraction of a flake's light that its lobe holds.
    static constexpr float kLobePower = 0.92f;
    /// The radius of the lobe in |q|, in lambda' / d. With 1.25984 the integral of K^2 is that of the
    /// Airy pattern: the latter's is pi/8 (d/lambda')^2 Int x (2 J_1(x)/x)^4 dx, and the integral is
    /// 0.91924 (by quadrature).
    static constexpr double kLobeRadius = kLobePower * 1.25984;
    /// Of the contrast under lamps of 0 to 8 deg, for flakes of 5 to 100 um and half vectors within
    /// 1.6 alpha; 6 % where a lobe is as wide as the distribution of slopes.
    static constexpr double kContrastError = 0.05;

    /// Fraction of the mean light with a half vector that comes from flakes in whose lobes it lies;
    /// the rest comes from the rings of all others: min(1, e P * K / (P * A)). On the flank of P
    /// there are few such flakes, and at its peak many.
    /// @param exponent  as of blur(): (slope / alpha)^2, at most kMaxExponent
    /// @param width     of K, over alpha
    static float lobe_fraction(float exponent, float width);
    static constexpr double kLobeFractionError = 5e-3;  ///< absolute
    /// P, per unit area of slopes.
    float slope_density(float slope2) const { return norm_ * std::exp(-exponent(slope2)); }

    float exponent(float slope2) const { return slope2 * inverse_alpha2_; }

    /// Flakes of a larger (slope / alpha)^2, one in a million, are not resolved.
    static constexpr float kMaxExponent = 14;
    bool reaches(float slope2) const { return exponent(slope2) < kMaxExponent; }

 private:
    static constexpr double kWavelength_um = 0.55;
    /// At grazing incidence, which a clearcoat rules out, the lobe stops growing.
    static constexpr float kMinCosine = 0.1f;

    float inverse_alpha_, inverse_alpha2_, norm_, max_radius_, radius_um_;
};

}  // namespace nacre::sparkle
