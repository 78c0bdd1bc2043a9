#pragma once

#include <array>
#include <cstdint>

#include "nacre/core/lanes.h"
#include "nacre/core/random.h"
#include "nacre/core/vec.h"
#include "nacre/sparkle/diffraction_lobe.h"
#include "nacre/sparkle/lane_bits.h"

namespace nacre::sparkle {

/// The flakes of one population that a patch shows: found once, evaluated for every pair of
/// directions.
///
/// Relative to the mean over all patches, a patch shows `background` and flake by flake `weight`:
/// all of them add up to 1 in expectation. Where only some of the patch's flakes are resolved,
/// their lobes are wider by `widening`, so that as many reflect as of all flakes, each as bright as
/// one of them: the light has the variance and nearly the distribution of that of all flakes.
///                                                     [docs/nacre-model.md, any number of flakes]
struct FlakeView {
    /// The patch touches 190 flakes at most on average (FlakeField::Constants::kFinestCells); a Poisson number
    /// of that mean is never larger.
    static constexpr int kMax = 288;

    int count = 0;
    /// What is not resolved; background_at() adds what does not lie in the lobes of the flakes.
    float background = 1;
    float weight_sum = 0;
    float widening = 1;
    float typical_radius = 0;  ///< lobe_radius of a flake of the mean diameter, over alpha
    // By flake, padded to a whole vector with flakes whose slopes no lobe reaches.
    template <class T>
    using List = std::array<T, kMax + kLanes>;
    alignas(64) List<float> weight;
    alignas(64) List<float> slope_x, slope_y;     ///< of its normal, in the local frame
    alignas(64) List<float> lobe_radius;          ///< DiffractionLobe::radius() times widening
    alignas(64) List<std::uint32_t> place, kind;  ///< all else of it is a hash of these

    /// Where it lies in its layer, 0 at the top and 1 at the bottom, evenly; and 32 bits for which
    /// of the population's films it has.
    struct Body {
        float depth;
        std::uint32_t film;
    };
    Body body(int flake) const {
        const std::uint64_t b = hash_of(place[flake], kind[flake]);
        return {to_unit_float(static_cast<std::uint32_t>(b)), static_cast<std::uint32_t>(b >> 32)};
    }

    /// Calls visit(flake, fraction) for the flakes that reflect one direction into another, with
    /// half vector h (inside the coat), and returns the background for this h: over all patches
    /// it and the fractions add up to 1 on average, for every h.
    ///
    /// @param lobe      of the population
    /// @param slope     (h_x / h_z, h_y / h_z)
    /// @param cosine    w_i . h
    /// @param coat_spread2  CoatTilt::spread2() of the two directions
    template <class Visit>
    float for_each_reflecting_flake(const DiffractionLobe& lobe, Vec2f slope, float cosine,
                                    Visit&& visit, float coat_spread2 = 0) const;

    /// What for_each_reflecting_flake() passes for one flake; 0 if it does not reflect.
    float fraction(const DiffractionLobe& lobe, Vec2f slope, float cosine, int flake,
                   float coat_spread2 = 0) const;

    /// Factor on the flakes that reflect: the lobes' fraction e_h of the light, and so that the variance is
    /// that of all flakes. The integral of K^2 P / (P * K)^2 goes with
    /// r^-2 (1 - (t_h^2/alpha^2 - 1) r^2/alpha^2 / 3 + ...); widening keeps its leading term, and this
    /// the next.
    /// @param scale    DiffractionLobe::widening() of the half vector
    /// @param spread2  DiffractionLobe::spread2()
    float resolved_factor(const DiffractionLobe& lobe, float slope2, float scale,
                          float spread2) const {
        const float exponent = lobe.exponent(slope2), radius = typical_radius * scale;
        // The coat, and waviness, spread slopes and rings alike.
        const float relative = lobe.exponent(spread2), narrower = 1 / (1 + relative);
        const float lobes =
            DiffractionLobe::lobe_fraction(exponent * narrower, radius * std::sqrt(narrower),
                                           DiffractionLobe::power_of(relative / (radius * radius)));
        if (widening == 1) return lobes;
        const float radius2 = radius * radius + DiffractionLobe::spread_radius2(relative);
        const float bend = (exponent - 1) * radius2 * (1.0f / 3);
        const float upper_bound = background < 1 ? 1 / (1 - background) : 1;
        return std::min(upper_bound,
                        lobes * std::sqrt(std::max(1 - bend, 0.25f) /
                                          std::max(1 - widening * widening * bend, 0.25f)));
    }
    /// What for_each_reflecting_flake() returns.
    float background_at(const DiffractionLobe& lobe, float slope2, float cosine,
                        float coat_spread2) const {
        return 1 - (1 - background) * resolved_factor(lobe, slope2,
                                                      lobe.widening(1 + slope2, cosine),
                                                      lobe.spread2(coat_spread2));
    }

    /// The lobes of eight flakes, by slopes of half vectors: those that are evaluated, but for the radius,
    /// which is that at the flake's own slope.
    struct Lobes {
        FloatLanes x, y, radius;
        /// Slopes near those of the flakes, one each, with their densities.
        struct Samples {
            FloatLanes x, y, pdf;
        };
        /// @param u  independent from lane to lane: in [0, 1) how far from the flake's own, and turns about it
        Samples sample(const Vec2<FloatLanes>& u) const;
    };
    Lobes lobes(const DiffractionLobe& lobe, Vec3f wi, const IntLanes& flakes) const;

    /// The density of one of them, per unit square of slopes.
    float lobe_pdf(const DiffractionLobe& lobe, Vec3f wi, int flake, Vec2f slope) const;

    /// Picks a flake by weight and a slope of the half vector near its own; u in [0, 1).
    /// Requires weight_sum > 0.
    Vec2f sample_slope(const DiffractionLobe& lobe, Vec3f wi, float u_flake, Vec2f u) const;
    /// The density, per unit square of slopes, with which sample_slope() draws the slope.
    float slope_pdf(const DiffractionLobe& lobe, Vec3f wi, Vec2f slope) const;

 private:
    /// Radii of the lobes of flakes of these slopes about the direction into which they mirror wi.
    /// @param radius  lobe_radius
    FloatLanes own_radius(const DiffractionLobe& lobe, Vec3f wi, FloatLanes x, FloatLanes y,
                          FloatLanes radius, float factor = 1) const {
        const FloatLanes sec2 = 1.0f + x * x + y * y;
        const FloatLanes facing = wi.x * x + wi.y * y + wi.z;
        const FloatLanes cosine = (facing < 0.0f ? -facing : facing) / sqrt_lanes(sec2);
        if (!lobe.spreads()) return lobe.radius_at(factor * radius, sec2, cosine);
        const FloatLanes spread2 =
            lobe.spread2(lobe.coat().spread2(wi.z, 2.0f * facing / sec2 - wi.z));
        const float wider = factor * widening;
        return lobe.radius_at(factor * radius, sec2, cosine,
                              spread2 * (wider * wider * DiffractionLobe::spread_radius2(1)));
    }
};

namespace detail {

// Sampled lobes are a little wider than those that are evaluated, whose radius is that at the half
// vector instead of the normal: they should cover them.
inline constexpr float kSampledWidening = 1.1f;

}  // namespace detail

template <class Visit>
float FlakeView::for_each_reflecting_flake(const DiffractionLobe& lobe, Vec2f slope, float cosine,
                                           Visit&& visit, float coat_spread2) const {
    const float spread2 = lobe.spread2(coat_spread2);
    const float slope2 = slope.x * slope.x + slope.y * slope.y;
    const float scale = lobe.widening(1 + slope2, cosine);
    const float factor = resolved_factor(lobe, slope2, scale, spread2);
    const float coat2 = widening * widening * DiffractionLobe::spread_radius2(spread2);
    const FloatLanes max2 = splat(lobe.max_radius() * lobe.max_radius());
    float inverse_density = 0;  // worked out with the first that reflects
    for (int first = 0; first < count; first += kLanes) {
        const FloatLanes dx = load_lanes(&slope_x[first]) - slope.x;
        const FloatLanes dy = load_lanes(&slope_y[first]) - slope.y;
        const FloatLanes distance2 = dx * dx + dy * dy;
        const FloatLanes own = load_lanes(&lobe_radius[first]) * scale;
        const FloatLanes width2 = min_lanes(own * own + coat2, max2);
        for_each_set_lane(distance2 < width2, [&](int lane) {
            if (inverse_density == 0) inverse_density = factor / lobe.slope_density(slope2);
            const float w = std::sqrt(width2[lane]);
            visit(first + lane, weight[first + lane] * lobe.density(distance2[lane], w) *
                                    inverse_density / lobe.blur(slope2, w));
        });
    }
    return 1 - (1 - background) * factor;
}

inline float FlakeView::fraction(const DiffractionLobe& lobe, Vec2f slope, float cosine, int flake,
                                 float coat_spread2) const {
    const float spread2 = lobe.spread2(coat_spread2);
    const float slope2 = slope.x * slope.x + slope.y * slope.y;
    if (!lobe.reaches(slope2)) return 0;
    const float scale = lobe.widening(1 + slope2, cosine);
    const float coat2 = widening * widening * DiffractionLobe::spread_radius2(spread2);
    const float width =
        std::min(std::hypot(lobe_radius[flake] * scale, std::sqrt(coat2)), lobe.max_radius());
    const float dx = slope_x[flake] - slope.x, dy = slope_y[flake] - slope.y;
    const float distance2 = dx * dx + dy * dy;
    if (distance2 >= width * width) return 0;
    return weight[flake] * lobe.density(distance2, width) *
           resolved_factor(lobe, slope2, scale, spread2) /
           (lobe.slope_density(slope2) * lobe.blur(slope2, width));
}

inline Vec2f FlakeView::sample_slope(const DiffractionLobe& lobe, Vec3f wi, float u_flake,
                                     Vec2f u) const {
    float rest = u_flake * weight_sum;
    int k = 0;
    while (k + 1 < count && rest >= weight[k]) rest -= weight[k++];
    const float x = slope_x[k], y = slope_y[k];
    const float width = own_radius(lobe, wi, splat(x), splat(y), splat(lobe_radius[k]),
                                   detail::kSampledWidening)[0];
    // The inverse of 1 - (1 - distance^2/width^2)^3.
    const float r = width * std::sqrt(std::max(0.0f, 1 - std::cbrt(1 - u.x)));
    const float angle = 2 * std::numbers::pi_v<float> * u.y;
    return {x + r * std::cos(angle), y + r * std::sin(angle)};
}

inline FlakeView::Lobes FlakeView::lobes(const DiffractionLobe& lobe, Vec3f wi,
                                         const IntLanes& flakes) const {
    const FloatLanes x = gather(slope_x.data(), flakes), y = gather(slope_y.data(), flakes);
    return {x, y, own_radius(lobe, wi, x, y, gather(lobe_radius.data(), flakes))};
}

inline FlakeView::Lobes::Samples FlakeView::Lobes::sample(const Vec2<FloatLanes>& u) const {
    // The inverse of 1 - (1 - x)^3, the distribution of x = distance^2/radius^2.
    const FloatLanes fall = exp_lanes(log_lanes(1.0f - u.x) * (1.0f / 3));
    const FloatLanes r = radius * sqrt_lanes(max_lanes(1.0f - fall, FloatLanes{}));
    const auto wave = cos_sin_turns(u.y);
    const FloatLanes inverse = 1.0f / max_lanes(radius * radius, splat(1e-30f));
    return {x + r * wave.cosine, y + r * wave.sine,
            3 * std::numbers::inv_pi_v<float> * inverse * fall * fall};
}

inline float FlakeView::lobe_pdf(const DiffractionLobe& lobe, Vec3f wi, int k, Vec2f slope) const {
    const float x = slope_x[k], y = slope_y[k];
    const float width = own_radius(lobe, wi, splat(x), splat(y), splat(lobe_radius[k]))[0];
    const float dx = x - slope.x, dy = y - slope.y, distance2 = dx * dx + dy * dy;
    return distance2 < width * width ? lobe.density(distance2, width) : 0.0f;
}

inline float FlakeView::slope_pdf(const DiffractionLobe& lobe, Vec3f wi, Vec2f slope) const {
    float sum = 0;
    for (int first = 0; first < count; first += kLanes) {
        const FloatLanes x = load_lanes(&slope_x[first]), y = load_lanes(&slope_y[first]);
        const FloatLanes dx = x - slope.x, dy = y - slope.y, distance2 = dx * dx + dy * dy;
        const FloatLanes width =
            own_radius(lobe, wi, x, y, load_lanes(&lobe_radius[first]), detail::kSampledWidening);
        for_each_set_lane(distance2 < width * width, [&](int lane) {
            sum += weight[first + lane] * lobe.density(distance2[lane], width[lane]);
        });
    }
    return weight_sum > 0 ? sum / weight_sum : 0.0f;
}

}  // namespace nacre::sparkle
