#pragma once

#include "nacre/core/lane_math.h"
#include "nacre/sparkle/reflection_cone.h"

namespace nacre::sparkle {

template <class Visit>
ConeRule::Means ConeRule::visit(Vec3f wi, Vec3f wo, Visit&& visit) const {
    const Frame frame = Frame::around(wo);
    const float quarter_angle = 0.25f * static_cast<float>(solid_angle_);
    FloatLanes density{}, projected{};
    // |wi + wo| = 2 cos of the incidence on the facets.
    constexpr float kGrazingCosine = 0.35f;
    const Vec3f sum = wi + wo;
    const bool grazing = dot(sum, sum) < 4 * kGrazingCosine * kGrazingCosine;
    for (const Group& g : grazing ? grazing_groups_ : groups_) {
        const FloatLanes hx = wi.x + g.x * frame.s.x + g.y * frame.t.x + g.z * frame.n.x;
        const FloatLanes hy = wi.y + g.x * frame.s.y + g.y * frame.t.y + g.z * frame.n.y;
        const FloatLanes hz = wi.z + g.x * frame.s.z + g.y * frame.t.z + g.z * frame.n.z;
        // Facets face upwards: none lies where the half vector does not.
        const FloatLanes z = max_lanes(hz, splat(1e-6f));
        const FloatLanes r2 = hx * hx + hy * hy, z2 = z * z, length2 = r2 + z2;
        const FloatLanes sec2 = length2 / z2, exponent = r2 / z2 * inverse_alpha2_;
        const FloatLanes d = exp_lanes(-exponent) * (g.weight * norm_) * sec2 * sec2;
        const FloatLanes seen = hz > 0.0f && exponent < 80.0f ? d : FloatLanes{};
        // (m.n) / (wi.m) = hz / (wi.h), and wi.h = |h|^2 / 2 for unit directions.
        const FloatLanes p = seen * (0.5f * z / length2);
        density += seen;
        projected += p;
        const FloatLanes inverse_length = 1.0f / sqrt_lanes(length2);
        visit(hx * inverse_length, hy * inverse_length, z * inverse_length,
              p * (4 * quarter_angle));
    }
    return {lane_sum(density), lane_sum(projected)};
}

inline Vec3f ConeRule::sample(Vec3f wo, Vec2f u) const {
    const float versine = u.x * versine_;
    const float sine = std::sqrt(std::max(0.0f, versine * (2 - versine)));
    const float angle = 2 * std::numbers::pi_v<float> * u.y;
    return Frame::around(wo).to_world(
        {sine * std::cos(angle), sine * std::sin(angle), 1 - versine});
}

}  // namespace nacre::sparkle
