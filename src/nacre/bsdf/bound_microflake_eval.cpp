#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/bound_microflake.h"
#include "nacre/bsdf/warp.h"
#include "nacre/core/lane_math.h"
#include "nacre/optics/dielectric.h"

namespace nacre::bsdf {

Ray BoundMicroflake::make_ray(Vec3f w) const {
    Ray ray;
    ray.outside = w;
    ray.inside = refract_in(w, inverse_mean_ior_);
    ray.sine = std::sqrt(w.x * w.x + w.y * w.y);
    ray.x = ray.sine / (1 + w.z);
    const float at = ray.x * kDirectionIntervals;
    ray.row = std::min(static_cast<int>(at), kDirectionIntervals - 1);
    ray.fraction = at - ray.row;
    return ray;
}

// Single scattering without the interface: layers::single_scattering at eight wavelengths.
FloatLanes BoundMicroflake::single(Vec3f inside_i, Vec3f inside_o, const Ray& i,
                                   const Ray& o) const {
    const Vec3f h = inside_i + inside_o;
    const float inverse_mu_i = 1 / inside_i.z, inverse_mu_o = 1 / inside_o.z;
    const float tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
    const float sec2 = 1 + tan2, sec = std::sqrt(sec2);
    const float cosine = std::min(1.0f, 0.5f * h.z * sec);

    FloatLanes sum{};
    FloatLanes depth = clearcoat_depth_ * (inverse_mu_i + inverse_mu_o);
    for (const BoundLayer& layer : layers_) {
        const FloatLanes rate =
            i.look_up(layer.extinction) * inverse_mu_i + o.look_up(layer.extinction) * inverse_mu_o;
        const FloatLanes here = layer.thickness_um * rate;

        FloatLanes kernel{};
        bool any = !layer.pigments.empty();
        for (const BoundFlake& flake : layer.flakes) {
            const float exponent = tan2 * flake.inverse_alpha2;
            if (exponent > 60) continue;  // e^-60: outside the lobe
            any = true;
            const float density =
                flake.half_density * flake.norm * sec2 * sec * std::exp(-exponent);
            const float x = cosine * flake.intervals;
            const int at = std::min(static_cast<int>(x), std::max(flake.intervals - 1, 0));
            FloatLanes reflectance = flake.reflectance[at];
            if (flake.intervals) {
                reflectance += (x - at) * (flake.reflectance[at + 1] - reflectance);
            }
            kernel += density * reflectance;
        }
        for (const BoundPigment& pigment : layer.pigments) {
            const float g = pigment.g, turn = 1 + g * g + 2 * g * dot(inside_i, inside_o);
            const float phase =
                (1 - g * g) * 0.25f * std::numbers::inv_pi_v<float> / (turn * std::sqrt(turn));
            kernel += phase * pigment.scattering;
        }
        if (any) {
            FloatLanes escape;
            if (layer.thick) {
                escape = (1.0f - exp_lanes(-here)) / rate;
            } else {
                // (1 - e^-x)/x stays finite for a layer without any extinction.
                const FloatLanes safe = max_lanes(here, splat(1e-20f));
                escape = layer.thickness_um * one_minus_exp_lanes(safe) / safe;
            }
            sum += layer.buried ? kernel * exp_lanes(-depth) * escape : kernel * escape;
        }
        depth += here;
    }
    return sum * (inverse_mu_i * inverse_mu_o);
}

// layers::RoughInterface::brdf at eight wavelengths.
FloatLanes BoundMicroflake::rough_lobe(const Ray& i, const Ray& o) const {
    const Vec3f h = i.outside + o.outside;
    const float tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z), sec2 = 1 + tan2;
    const float exponent = tan2 * rough_->inverse_alpha2;
    FloatLanes f = rough_->diffuse_scale * i.look_up(rough_->masked) * o.look_up(rough_->masked);
    if (exponent < 60) {
        const float facets = std::exp(-exponent) * rough_->inverse_alpha2 *
                             std::numbers::inv_pi_v<float> * sec2 * sec2;
        const float cosine = std::min(1.0f, 0.5f * length(h));
        f += (0.25f * facets * i.look_up(rough_->masking) * o.look_up(rough_->masking)) *
             optics::dielectric_reflectance(splat(1.0f), ior_, splat(cosine));
    }
    return f;
}

FloatLanes BoundMicroflake::value(const Ray& i, const Ray& o) const {
    const SmoothCell cell = locate(grid_, i.outside, o.outside, i.sine, o.sine, i.x, o.x);
    // The truncated Fourier series may dip below zero by its own error.
    const FloatLanes smooth = max_lanes(interpolate(grid_, smooth_.data(), cell), FloatLanes{}) *
                              (1 / (i.inside.z + o.inside.z));
    if (rough_) return smooth + rough_lobe(i, o);
    FloatLanes once;
    if (!dispersive_) {
        once = single(i.inside, o.inside, i, o);
    } else {
        // Each wavelength refracts its own way: rare, and eight times the work.
        for (int lane = 0; lane < kLanes; ++lane) {
            const float inverse = 1 / ior_[lane];
            once[lane] =
                single(refract_in(i.outside, inverse), refract_in(o.outside, inverse), i, o)[lane];
        }
    }
    const FloatLanes interface = i.look_up(transmittance_over_cosine_) *
                                 o.look_up(transmittance_over_cosine_) * inverse_ior2_;
    return (once + smooth) * interface * (i.outside.z * o.outside.z);
}

const LobeOdds& BoundMicroflake::odds_at(const Ray& i) const {
    return tables_->odds[i.row + (i.fraction > 0.5f)];
}

float BoundMicroflake::density(const LobeOdds& odds, const Ray& i, const Ray& o) const {
    const float inside = flake_lobe_.mixed_pdf(i.inside, o.inside, odds.flakes, odds.wide);
    const float interface = rough_ ? odds.interface * rough_->lobe.pdf(i.outside, o.outside) : 0.0f;
    return interface + o.outside.z * (odds.diffuse * std::numbers::inv_pi_v<float> +
                                      inside * inverse_mean_ior_ * inverse_mean_ior_ / o.inside.z);
}

FloatLanes BoundMicroflake::eval(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    return value(make_ray(wi), make_ray(wo));
}

float BoundMicroflake::pdf(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return 0;
    const Ray i = make_ray(wi);
    return density(odds_at(i), i, make_ray(wo));
}

BsdfValue BoundMicroflake::evaluate(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    const Ray i = make_ray(wi), o = make_ray(wo);
    return {value(i, o), density(odds_at(i), i, o)};
}

std::optional<BsdfSample> BoundMicroflake::sample(Vec3f wi, float u_lobe, Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    const Ray i = make_ray(wi);
    const LobeOdds& odds = odds_at(i);
    Vec3f wo;
    if (u_lobe < odds.interface && !rough_) {
        BsdfSample s;
        s.wo = {-wi.x, -wi.y, wi.z};
        s.weight =
            optics::dielectric_reflectance(splat(1.0f), ior_, splat(wi.z)) * (1 / odds.interface);
        s.pdf = odds.interface;
        s.mirror = true;
        return s;
    }
    if (u_lobe < odds.interface) {
        wo = rough_->lobe.sample(wi, u_lobe / odds.interface, u);
    } else if ((u_lobe -= odds.interface) < odds.flakes + odds.wide) {
        const bool narrow = u_lobe < odds.flakes;
        const float u_sign = narrow ? u_lobe / odds.flakes : (u_lobe - odds.flakes) / odds.wide;
        const Vec3f inside = (narrow ? flake_lobe_ : wide_lobe_).sample(i.inside, u_sign, u);
        if (inside.z <= 0) return std::nullopt;
        const auto outside = refract_out(inside, mean_ior_);
        if (!outside) return std::nullopt;
        wo = *outside;
    } else {
        wo = cosine_hemisphere(u);
    }
    if (wo.z <= 0) return std::nullopt;
    const Ray o = make_ray(wo);
    BsdfSample s;
    s.wo = wo;
    s.pdf = density(odds, i, o);
    if (!(s.pdf > 0)) return std::nullopt;
    s.weight = value(i, o) * (wo.z / s.pdf);
    return s;
}

FloatLanes BoundMicroflake::albedo(Vec3f wi) const {
    if (wi.z <= 0) return FloatLanes{};
    const Ray i = make_ray(wi);
    const int count = tables_->wavelength_count();
    const auto at = [&](int row) {
        return at_wavelengths(where_, [&](int w) { return tables_->albedo[row * count + w]; });
    };
    const FloatLanes a = at(i.row);
    return a + i.fraction * (at(i.row + 1) - a);
}

}  // namespace nacre::bsdf
