#pragma once

#include "nacre/core/lanes.h"
#include "nacre/sparkle/flake_view.h"
#include "nacre/sparkle/lane_bits.h"

namespace nacre::sparkle {

namespace detail {

// Sampled lobes are a little wider than those that are evaluated, whose radius is that at the half
// vector instead of the normal: they should cover them.
inline constexpr float kSampledWidening = 1.1f;

}  // namespace detail

template <class Visit>
float FlakeView::for_each_answer(const DiffractionLobe& law, Vec2f slope, float cosine,
                                 Visit&& visit) const {
    const float slope2 = slope.x * slope.x + slope.y * slope.y;
    const float scale = law.widening(1 + slope2, cosine);
    const float correction = variance_correction(law.exponent(slope2), scale);
    float inverse_density = 0;  // worked out with the first answer
    for (int first = 0; first < count; first += kLanes) {
        const FloatLanes dx = load_lanes(&slope_x[first]) - slope.x;
        const FloatLanes dy = load_lanes(&slope_y[first]) - slope.y;
        const FloatLanes distance2 = dx * dx + dy * dy;
        const FloatLanes width =
            min_lanes(load_lanes(&lobe_radius[first]) * scale, splat(law.most_radius()));
        for_each_set_lane(distance2 < width * width, [&](int lane) {
            if (inverse_density == 0) inverse_density = correction / law.slope_density(slope2);
            const float w = width[lane];
            visit(first + lane, weight[first + lane] * law.density(distance2[lane], w) *
                                    inverse_density / law.blur(slope2, w));
        });
    }
    return 1 - (1 - background) * correction;
}

inline Vec2f FlakeView::sample_slope(const DiffractionLobe& law, Vec3f wi, float u_flake,
                                     Vec2f u) const {
    float rest = u_flake * weight_sum;
    int k = 0;
    while (k + 1 < count && rest >= weight[k]) rest -= weight[k++];
    const float x = slope_x[k], y = slope_y[k], sec2 = 1 + x * x + y * y;
    const float cosine = std::abs(wi.x * x + wi.y * y + wi.z) / std::sqrt(sec2);
    // As slope_pdf() does it, in lanes: the same bits.
    const float width = law.radius_at(splat(detail::kSampledWidening * lobe_radius[k]), splat(sec2),
                                      splat(cosine))[0];
    // The inverse of 1 - (1 - r^2/w^2)^3.
    const float r = width * std::sqrt(std::max(0.0f, 1 - std::cbrt(1 - u.x)));
    const float angle = 2 * std::numbers::pi_v<float> * u.y;
    return {x + r * std::cos(angle), y + r * std::sin(angle)};
}

inline float FlakeView::slope_pdf(const DiffractionLobe& law, Vec3f wi, Vec2f slope) const {
    float sum = 0;
    for (int first = 0; first < count; first += kLanes) {
        const FloatLanes x = load_lanes(&slope_x[first]), y = load_lanes(&slope_y[first]);
        const FloatLanes dx = x - slope.x, dy = y - slope.y, distance2 = dx * dx + dy * dy;
        // radius_at() of the flakes' own slopes: sec^(3/2) / cosine, the cosine over sec.
        const FloatLanes sec2 = 1.0f + x * x + y * y;
        const FloatLanes facing = wi.x * x + wi.y * y + wi.z;
        const FloatLanes cosine = (facing < 0.0f ? -facing : facing) / sqrt_lanes(sec2);
        const FloatLanes width =
            law.radius_at(detail::kSampledWidening * load_lanes(&lobe_radius[first]), sec2, cosine);
        for_each_set_lane(distance2 < width * width, [&](int lane) {
            sum += weight[first + lane] * law.density(distance2[lane], width[lane]);
        });
    }
    return weight_sum > 0 ? sum / weight_sum : 0.0f;
}

}  // namespace nacre::sparkle
