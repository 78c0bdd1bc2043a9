#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"
#include "nacre/sparkle/coat_tilt.h"

namespace nacre::sparkle {

/// How a flat flake spreads the light that it reflects: diffraction at a disc, as a lobe of half
/// vectors.
///
/// A disc of diameter d reflects w_i into directions w_o with the Airy pattern of
/// x = pi d |q| / lambda', where q is the part of w_i + w_o parallel to the disc and lambda' the
/// wavelength in the binder [born-wolf-1999, section 8.5.2]. As w_i + w_o = 2 (w_i.h) h, that is a
/// lobe of the half vector h about the normal m, isotropic, of an angle
/// proportional to 1 / (d w_i.h): it depends on h alone and is reciprocal. Here the pattern K_A is
/// replaced by a lobe that holds e = kLobePower of the light,
///
///     K(t_h - t_j) = 3 / (pi r^2) (1 - |t_h - t_j|^2 / r^2)^2     for |t_h - t_j| < r,
///
/// over slopes t_h = (h_x, h_y) / h_z, t_j that of the flake, and rings so wide that those of many flakes
/// add up to an even background. With the radius r for which the integral of (e K)^2 is that of K_A^2, the
/// contrast of the light that many flakes reflect of a small lamp is the same; e makes that of wide lamps right
/// within kContrastError. The radius is that of 550 nm at all wavelengths; the true one goes with
/// the wavelength, 0.73 times it at 400 nm and 1.27 times at 700 nm.
///
/// So that the mean over flakes whose slopes are Gaussian is exactly the distribution of slopes P,
/// and not P blurred by the pattern, the flakes of slope t_j count as e_h, lobe_fraction(), times
/// K / (P convolved with K), and the background as the rest to 1.
///
/// A rough clearcoat convolves lobes with the Gaussian P_s of CoatTilt. The square of that Gaussian has
/// the integral of the square of a K of radius sqrt(18/5) alpha_s; radii add in squares.
///
/// So does the waviness alpha_w of the flakes' own surfaces, whose slopes about the flake's plane have the
/// law exp(-t^2 / alpha_w^2) / (pi alpha_w^2): geometrical optics, each piece of a flake a mirror of its
/// own. The mean over all flakes is then the law of the surfaces' slopes, of alpha^2 + alpha_w^2.
class DiffractionLobe {
 public:
    /// @param alpha           Beckmann roughness of the flakes
    /// @param ior             of the binder
    /// @param coat_roughness  that of the clearcoat
    /// @param waviness        alpha_w of the slopes of a flake's surface about its plane
    /// @throws DomainError naming the argument, its value and its range
    DiffractionLobe(double alpha, double ior, double coat_roughness = 0, double waviness = 0);

    /// The radius r in slopes at perpendicular incidence on a flake of this diameter.
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
    /// alpha_s^2, by the coat and by the flakes' own waviness.
    /// @param of_coat  spread2() of coat()
    template <class V>
    V spread2(V of_coat) const {
        return of_coat + waviness2_;
    }
    /// Whether anything but diffraction spreads the light of a flake.
    bool spreads() const { return coat_.rough() || waviness2_ > 0; }
    /// The square of the radius that a rough coat and waviness add.
    /// @param spread2  of both
    static constexpr float spread_radius2(float spread2) { return 18.0f / 5 * spread2; }
    /// How the clearcoat tilts half vectors.
    const CoatTilt& coat() const { return coat_; }
    /// The radius then, at most max_radius().
    /// @param added_radius2  what coat and waviness add to its square
    FloatLanes radius_at(FloatLanes radius, FloatLanes sec2, FloatLanes cosine,
                         FloatLanes added_radius2 = FloatLanes{}) const {
        const FloatLanes sec = sqrt_lanes(sec2);
        const FloatLanes own =
            radius * sec * sqrt_lanes(sec) / max_lanes(cosine, splat(kMinCosine));
        return min_lanes(sqrt_lanes(own * own + added_radius2), splat(max_radius_));
    }
    /// 4 alpha: beyond it P is negligible, and a wider lobe would change nothing.
    float max_radius() const { return max_radius_; }

    /// K per unit area of slopes, distance2 = |t_h - t_j|^2 < width^2.
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
    /// the rest comes from the rings of all others: e_h = min(1, e P * K / (P * K_A)). On the flank of P
    /// there are few such flakes, and at its peak many.
    /// @param exponent  as of blur(): (slope / alpha)^2, at most kMaxExponent
    /// @param width_over_alpha  of K
    /// @param power  e, in general of power_of()
    static float lobe_fraction(float exponent, float width_over_alpha, float power = kLobePower);
    /// e under a rough coat. Where its spread is wide against the pattern, the rings stay within it,
    /// but for 0.2 r / alpha_s of the light: then Int (e K)^2 is that of the pattern so spread.
    /// @param relative_spread2  spread2 over the square of the radius that diffraction gives
    static float power_of(float relative_spread2) {
        return relative_spread2 > 0 ? std::max(kLobePower, 1 - 0.2f / std::sqrt(relative_spread2))
                                    : kLobePower;
    }
    /// Of Int (e K)^2 for e of power_of() and radii that add in squares, in contrast.
    static constexpr double kSpreadError = 0.04;
    static constexpr double kLobeFractionError = 5e-3;  ///< absolute
    /// The tables of blur() and lobe_fraction(), for programs that look them up themselves: log(blur) /
    /// y^2 and 1 / lobe_fraction before it is bounded, [y][x^2], both even in x^2 = (slope / alpha)^2
    /// from 0 to kMaxExponent and in y = width / alpha from 0 to kMaxWidth.
    static constexpr int kSquareNodes = 65, kWidthNodes = 65;
    static constexpr float kMaxWidth = 4;
    static std::span<const float> log_blur_table();
    static std::span<const float> inverse_lobe_fraction_table();
    /// P, per unit area of slopes.
    float slope_density(float slope2) const { return norm_ * std::exp(-exponent(slope2)); }

    /// Half of all flakes' surfaces lean more.
    float median_slope() const { return std::sqrt(std::numbers::ln2_v<float> / inverse_alpha2_); }

    float exponent(float slope2) const { return slope2 * inverse_alpha2_; }

    /// Flakes of a larger (slope / alpha)^2, one in a million, are not resolved.
    static constexpr float kMaxExponent = 14;
    bool reaches(float slope2) const { return exponent(slope2) < kMaxExponent; }

 private:
    static constexpr double kWavelength_um = 0.55;
    /// At grazing incidence, which a clearcoat rules out, the lobe stops growing.
    static constexpr float kMinCosine = 0.1f;

    float inverse_alpha_, inverse_alpha2_, norm_, max_radius_, radius_um_, waviness2_;
    CoatTilt coat_;
};

}  // namespace nacre::sparkle
