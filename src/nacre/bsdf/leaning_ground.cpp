#include <algorithm>
#include <cmath>

#include "nacre/bsdf/leaning_flakes.h"
#include "nacre/core/lane_math.h"

// Of flakes that lean: the light that has met the ground.

namespace nacre::bsdf {
namespace {

/// rho* of light that is mirrored along the layer or down into it.
constexpr float kMinMirroredRatio = 0.1f;

/// Cosine outside under which the ground is seen where it is compared with itself.
constexpr float kFarCosine = 0.5f;
/// A - (A - 1) sqrt(rho* / rho) of light that would hardly leave flakes and interface but by the ground.
constexpr float kMinReturnRatio = 0.1f;

FloatLanes lost_on_the_way(const FlakeDepths& depths) { return depths.flakes + depths.swallowed; }

}  // namespace

Vec3f LeaningFlakes::far_from(Vec2f azimuth) {
    const float sine = std::sqrt(1 - kFarCosine * kFarCosine);
    return {-sine * azimuth.x, -sine * azimuth.y, kFarCosine};
}

// e^kappa / (cosh g + s sinh(g) / g), g^2 = s^2 - r^2, for light that is `transmitted` by the interface.
LeaningFlakes::Passage LeaningFlakes::passage(const FloatLanes& s, const FloatLanes& r,
                                              const FloatLanes& kappa,
                                              const FloatLanes& transmitted) {
    const FloatLanes g = sqrt_lanes(max_lanes(s * s - r * r, splat(1e-8f)));
    const FloatLanes half = 0.5f * one_minus_exp_lanes(2.0f * g);
    return {kappa - g, transmitted / (1.0f - half + s * half / g)};
}

LeaningFlakes::Passage LeaningFlakes::flat_passage(float inside, float outside) const {
    const FlakeDepths depths = flat_.flake_depths(inside);
    const float path = 1 / inside;
    return passage(lost_on_the_way(depths) * path, depths.mirrored * path, -path * coat_depth_,
                   transmittance(outside));
}

LeaningFlakes::GroundRays LeaningFlakes::ground_rays(const Seen& seen) const {
    const float cosine = seen.cosine;
    const FlakeDepths depths = flat_.flake_depths(cosine);
    const FloatLanes met = lost_on_the_way(depths) * (1 / cosine);
    const float down = seen.inside.z / cosine,
                up = std::max(2 * lean_.n.z - down, kMinMirroredRatio);
    const Passage here = passage(
        0.5f * (1 / up + 1 / down) * met, depths.mirrored * (1 / (cosine * std::sqrt(down * up))),
        0.5f * (1 / up - 1 / down) * met - (1 / seen.inside.z) * coat_depth_, seen.transmitted);
    const auto over = [&](const Passage& flat) {
        return exp_lanes(here.exponent - flat.exponent) * (here.factor / flat.factor);
    };
    const float n = index_.mean, z = dot(seen.inside, twice_.n);
    const float x = dot(seen.inside, twice_.s), y = dot(seen.inside, twice_.t);
    const float across = std::sqrt(x * x + y * y);
    const Vec2f azimuth = across > 0 ? Vec2f{x / across, y / across} : Vec2f{1.0f, 0.0f};
    // A is seen from far on the other side, where large flakes have no hot spot.
    const Vec3f from = far_from(azimuth);
    GroundRays rays;
    FloatLanes from_here{};
    const auto ask = [&](float inside, float weight) {
        const float sine = n * std::sqrt(std::max(0.0f, 1 - inside * inside));
        const Vec3f asked = normalize(
            Vec3f{sine * azimuth.x, sine * azimuth.y, std::sqrt(std::max(1e-8f, 1 - sine * sine))});
        rays.w[rays.count] = asked;
        rays.factor[rays.count] = weight * over(flat_passage(inside, asked.z));
        from_here += flat_.multiply_scattered(asked, from).from_ground * rays.factor[rays.count];
        ++rays.count;
    };
    if (z >= least_cosine_) {
        ask(z, 1);
    } else {
        ask(least_cosine_, 2);
        ask(std::cos(2 * std::acos(least_cosine_) - std::acos(z)), -1);
    }
    const FloatLanes along_normal = ground_ * over(along_normal_);
    const FloatLanes returned =
        max_lanes(from_here / max_lanes(along_normal, splat(1e-20f)), splat(1.0f)) - 1.0f;
    const FloatLanes here_over_flat =
        max_lanes(1.0f + returned * (1 - std::sqrt(up / down)), splat(kMinReturnRatio));
    for (int k = 0; k < rays.count; ++k) {
        rays.factor[k] = along_normal > 0.0f ? rays.factor[k] / here_over_flat : rays.factor[k];
    }
    return rays;
}

// `twice` is the flat paint's at Seen::twice.
FloatLanes LeaningFlakes::from_ground(const Seen& i, const Seen& o, const FloatLanes& twice) const {
    const bool both_leave = i.twice.z > kMinFlatCosine && o.twice.z > kMinFlatCosine;
    if (!(lane_max(twice) > 0) && (both_leave || !over_ground())) return FloatLanes{};
    const GroundRays rays_i = i.ground ? *i.ground : ground_rays(i);
    const GroundRays rays_o = o.ground ? *o.ground : ground_rays(o);
    if (both_leave) return twice * rays_i.factor[0] * rays_o.factor[0];
    FloatLanes sum{};
    for (int a = 0; a < rays_i.count; ++a) {
        for (int b = 0; b < rays_o.count; ++b) {
            sum += flat_.multiply_scattered(rays_i.w[a], rays_o.w[b]).from_ground *
                   rays_i.factor[a] * rays_o.factor[b];
        }
    }
    return max_lanes(sum, FloatLanes{});
}

}  // namespace nacre::bsdf
