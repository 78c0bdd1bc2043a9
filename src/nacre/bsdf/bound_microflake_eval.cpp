#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/bound_microflake.h"
#include "nacre/bsdf/warp.h"
#include "nacre/core/lane_math.h"
#include "nacre/optics/dielectric.h"

namespace nacre::bsdf {

template FloatLanes BoundMicroflake::value(const Ray&, const Ray&, const MeanFlakes&) const;
template FloatLanes BoundMicroflake::single(Vec3f, Vec3f, const Ray&, const Ray&,
                                            const MeanFlakes&) const;

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
    return value(make_ray(wi), make_ray(wo), MeanFlakes{});
}

float BoundMicroflake::pdf(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return 0;
    const Ray i = make_ray(wi);
    return density(odds_at(i), i, make_ray(wo));
}

BsdfValue BoundMicroflake::evaluate(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    const Ray i = make_ray(wi), o = make_ray(wo);
    return {value(i, o, MeanFlakes{}), density(odds_at(i), i, o)};
}

BsdfSample BoundMicroflake::mirror_sample(Vec3f wi, float probability) const {
    BsdfSample s;
    s.wo = {-wi.x, -wi.y, wi.z};
    s.weight = optics::dielectric_reflectance(splat(1.0f), ior_, splat(wi.z)) * (1 / probability);
    s.pdf = probability;
    s.mirror = true;
    return s;
}

Vec3f BoundMicroflake::draw(const LobeOdds& odds, const Ray& i, float u_lobe, Vec2f u) const {
    constexpr Vec3f kNothing{0, 0, 0};
    if (u_lobe < odds.interface) return rough_->lobe.sample(i.outside, u_lobe / odds.interface, u);
    u_lobe -= odds.interface;
    if (u_lobe < odds.flakes + odds.wide) {
        const bool narrow = u_lobe < odds.flakes;
        const float u_sign = narrow ? u_lobe / odds.flakes : (u_lobe - odds.flakes) / odds.wide;
        const Vec3f inside = (narrow ? flake_lobe_ : wide_lobe_).sample(i.inside, u_sign, u);
        return leave(inside).value_or(kNothing);
    }
    return cosine_hemisphere(u);
}

std::optional<BsdfSample> BoundMicroflake::sample(Vec3f wi, float u_lobe, Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    const Ray i = make_ray(wi);
    const LobeOdds& odds = odds_at(i);
    if (draws_mirror(odds, u_lobe)) return mirror_sample(wi, odds.interface);
    BsdfSample s;
    s.wo = draw(odds, i, u_lobe, u);
    if (s.wo.z <= 0) return std::nullopt;
    const Ray o = make_ray(s.wo);
    s.pdf = density(odds, i, o);
    if (!(s.pdf > 0)) return std::nullopt;
    s.weight = value(i, o, MeanFlakes{}) * (s.wo.z / s.pdf);
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
