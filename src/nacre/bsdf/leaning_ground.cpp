#include <algorithm>
#include <cmath>

#include "nacre/bsdf/leaning_flakes.h"
#include "nacre/core/lane_math.h"

// Light from the ground of flakes that lean; formulas and symbols in leaning_flakes.h.

namespace nacre::bsdf {
namespace {

/// rho* of light that flakes reflect along the layer or down into it.
constexpr float kMinUpwardRatio = 0.1f;

/// Cosine outside of the direction for which B is computed.
constexpr float kReferenceCosine = 0.5f;
/// Least B - (B - 1) sqrt(rho* / rho), of light that hardly leaves flakes and interface but by the ground.
constexpr float kMinReturnRatio = 0.1f;

FloatLanes attenuation_depth(const OpticalDepths& depths) {
    return depths.flake_extinction + depths.pigment_absorption;
}

}  // namespace

Vec3f LeaningFlakes::direction_away_from(Vec2f azimuth) {
    const float sine = std::sqrt(1 - kReferenceCosine * kReferenceCosine);
    return {-sine * azimuth.x, -sine * azimuth.y, kReferenceCosine};
}

// t = e^kappa / (cosh gamma + s sinh(gamma) / gamma), times the transmittance of the interface.
LeaningFlakes::Passage LeaningFlakes::passage(const FloatLanes& s, const FloatLanes& r,
                                              const FloatLanes& kappa,
                                              const FloatLanes& transmittance) {
    const FloatLanes gamma = sqrt_lanes(max_lanes(s * s - r * r, splat(1e-8f)));
    const FloatLanes half = 0.5f * one_minus_exp_lanes(2.0f * gamma);
    return {kappa - gamma, transmittance / (1.0f - half + s * half / gamma)};
}

LeaningFlakes::Passage LeaningFlakes::flat_passage(float inside, float outside) const {
    const OpticalDepths depths = flat_.optical_depths(inside);
    const float path = 1 / inside;
    return passage(attenuation_depth(depths) * path, depths.flake_scattering * path,
                   -path * coat_depth_, transmittance(outside));
}

LeaningFlakes::GroundRays LeaningFlakes::ground_rays(const Path& path) const {
    const float cosine = path.cosine;
    const OpticalDepths depths = flat_.optical_depths(cosine);
    const FloatLanes s = attenuation_depth(depths) * (1 / cosine);
    const float down = path.inside.z / cosine, up = std::max(2 * lean_.n.z - down, kMinUpwardRatio);
    const Passage leaning = passage(
        0.5f * (1 / up + 1 / down) * s,
        depths.flake_scattering * (1 / (cosine * std::sqrt(down * up))),
        0.5f * (1 / up - 1 / down) * s - (1 / path.inside.z) * coat_depth_, path.transmittance);
    const auto over = [&](const Passage& flat) {
        return exp_lanes(leaning.exponent - flat.exponent) * (leaning.factor / flat.factor);
    };
    const float n = index_.mean, z = dot(path.inside, double_lean_.n);
    const float x = dot(path.inside, double_lean_.s), y = dot(path.inside, double_lean_.t);
    const float across = std::sqrt(x * x + y * y);
    const Vec2f azimuth = across > 0 ? Vec2f{x / across, y / across} : Vec2f{1.0f, 0.0f};
    // B is computed at the opposite azimuth, far from the hot spot of large flakes.
    const Vec3f from = direction_away_from(azimuth);
    GroundRays rays;
    FloatLanes ground_here{};
    const auto add_ray = [&](float inside, float weight) {
        const float sine = n * std::sqrt(std::max(0.0f, 1 - inside * inside));
        const Vec3f w = normalize(
            Vec3f{sine * azimuth.x, sine * azimuth.y, std::sqrt(std::max(1e-8f, 1 - sine * sine))});
        rays.w[rays.count] = w;
        rays.factor[rays.count] = weight * over(flat_passage(inside, w.z));
        ground_here += flat_.multiply_scattered(w, from).from_ground * rays.factor[rays.count];
        ++rays.count;
    };
    if (z >= critical_cosine_) {
        add_ray(z, 1);
    } else {
        add_ray(critical_cosine_, 2);
        add_ray(std::cos(2 * std::acos(critical_cosine_) - std::acos(z)), -1);
    }
    const FloatLanes along_normal = ground_ * over(along_normal_);
    const FloatLanes gain =
        max_lanes(ground_here / max_lanes(along_normal, splat(1e-20f)), splat(1.0f)) - 1.0f;
    const FloatLanes divisor =
        max_lanes(1.0f + gain * (1 - std::sqrt(up / down)), splat(kMinReturnRatio));
    for (int k = 0; k < rays.count; ++k) {
        rays.factor[k] = along_normal > 0.0f ? rays.factor[k] / divisor : rays.factor[k];
    }
    return rays;
}

// `flat_from_ground` is the flat paint's at Path::double_lean.
FloatLanes LeaningFlakes::from_ground(const Path& i, const Path& o,
                                      const FloatLanes& flat_from_ground) const {
    const bool both_leave = i.double_lean.z > kMinFlatCosine && o.double_lean.z > kMinFlatCosine;
    if (!(lane_max(flat_from_ground) > 0) && (both_leave || !over_ground())) return FloatLanes{};
    const GroundRays rays_i = i.ground ? *i.ground : ground_rays(i);
    const GroundRays rays_o = o.ground ? *o.ground : ground_rays(o);
    if (both_leave) return flat_from_ground * rays_i.factor[0] * rays_o.factor[0];
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
