#include "nacre/bsdf/tilted_coat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/bsdf/models/interface_lobe.h"
#include "nacre/bsdf/warp.h"
#include "nacre/optics/fresnel.h"

namespace nacre::bsdf {
namespace {

/// Cosine of the direction outside a flat coat that stands for all beyond its critical angle inside.
constexpr float kMinFlatCosine = 1e-3f;
/// Cosine between the eye and a slope that is just seen.
constexpr float kMinSeenCosine = 1e-3f;
/// Fraction of the samples that are spread over the tilted hemisphere: what the others do not reach.
constexpr float kAround = 1 / 32.0f;
/// At the most of those beyond the flat coat's critical angle, which are as many as the coat is tilted
/// by, in rad: a choice that keeps the weights of samples of silver below 3.
constexpr float kMaxBeyond = 0.2f;

}  // namespace

TiltedCoat::TiltedCoat(const BoundBsdf& flat, Vec2f slope, Vec3f seen_from)
    : flat_(flat),
      lobe_(flat.interface_lobe()),
      index_(flat.binder_index()),
      normal_(normalize(Vec3f{-slope.x, -slope.y, 1})) {
    const float facing = dot(normal_, seen_from);
    if (seen_from.z > 0 && facing < kMinSeenCosine) {
        normal_ = normalize(normal_ + (kMinSeenCosine - facing) * seen_from);
    }
    tilt_ = std::atan2(std::hypot(normal_.x, normal_.y), normal_.z);
    beyond_ = std::min(tilt_, kMaxBeyond);
    if (lobe_) frame_ = Frame::around(normal_);
}

float TiltedCoat::as_flat() const { return 1 - kAround - beyond_; }

std::optional<TiltedCoat::Ray> TiltedCoat::ray_of(Vec3f w) const {
    const float cosine = dot(w, normal_);
    if (w.z <= 0 || cosine <= 0) return std::nullopt;
    const float n = index_.mean;
    const float sine2 = std::max(0.0f, 1 - cosine * cosine);
    const float cosine_inside = std::sqrt(std::max(0.0f, 1 - sine2 / (n * n)));
    const float turn = n * cosine_inside - cosine;
    const Vec3f inside = w + turn * normal_;  // times n
    if (inside.z <= 0 || cosine_inside <= 0) return std::nullopt;

    Ray ray;
    ray.cosine = cosine;
    const float through = inside.z / n * cosine / cosine_inside;
    ray.irradiance = through / w.z;
    const float flat_sine2 = inside.x * inside.x + inside.y * inside.y;
    const float flat_cosine2 = 1 - flat_sine2;
    if (flat_cosine2 > kMinFlatCosine * kMinFlatCosine) {
        const float flat_cosine = std::sqrt(flat_cosine2);
        ray.flat = {inside.x, inside.y, flat_cosine};
        ray.jacobian = through / flat_cosine;
        ray.beyond = 0;
    } else {
        const float shorter =
            std::sqrt((1 - kMinFlatCosine * kMinFlatCosine) / std::max(flat_sine2, 0.5f));
        ray.flat = {inside.x * shorter, inside.y * shorter, kMinFlatCosine};
        ray.jacobian = 0;
        ray.beyond = beyond_pdf(inside, cosine, cosine_inside);
    }
    return ray;
}

// Directions of the lune, by their angle theta to the mean normal inside and their azimuth psi from
// that of the tilted one: from the critical angle theta_c on by at most tilt cos(psi), to first order.
// sin(psi) and theta are drawn evenly, which is 1 / (2 tilt sin(theta)) per solid angle inside.
float TiltedCoat::beyond_pdf(Vec3f inside, float cosine, float cosine_inside) const {
    if (beyond_ == 0) return 0;
    const float n = index_.mean;
    const float across = std::hypot(inside.x, inside.y), lean = std::hypot(normal_.x, normal_.y);
    const float cosine_psi = (inside.x * normal_.x + inside.y * normal_.y) / (across * lean);
    const float theta = std::atan2(across, inside.z);
    if (theta > critical_angle() + tilt_ * cosine_psi) return 0;
    return cosine / (2 * tilt_ * (across / n) * n * n * cosine_inside);
}

std::optional<Vec3f> TiltedCoat::sample_beyond(Vec2f u) const {
    const float sine_psi = 2 * u.x - 1;
    const float cosine_psi = std::sqrt(std::max(0.0f, 1 - sine_psi * sine_psi));
    const float theta = critical_angle() + tilt_ * cosine_psi * u.y;
    const float lean = std::hypot(normal_.x, normal_.y);
    const Vec2f along{normal_.x / lean, normal_.y / lean};
    const float sine = index_.mean * std::sin(theta);
    return refract_out({sine * (cosine_psi * along.x - sine_psi * along.y),
                        sine * (cosine_psi * along.y + sine_psi * along.x),
                        index_.mean * std::cos(theta)});
}

float TiltedCoat::critical_angle() const { return std::asin(1 / index_.mean); }

FloatLanes TiltedCoat::transmittance(const Ray& ray) const {
    if (lobe_) return lobe_->transmittance(ray.cosine) / lobe_->transmittance(ray.flat.z);
    const auto at = [&](float cosine) {
        return 1.0f - optics::dielectric_reflectance(splat(1.0f), index_.each, splat(cosine));
    };
    return at(ray.cosine) / at(ray.flat.z);
}

std::optional<Vec3f> TiltedCoat::leave(Vec3f flat) const {
    if (flat.z <= kMinFlatCosine) return std::nullopt;
    const float n = index_.mean;
    return refract_out(
        {flat.x, flat.y, std::sqrt(std::max(0.0f, n * n - flat.x * flat.x - flat.y * flat.y))});
}

std::optional<Vec3f> TiltedCoat::refract_out(Vec3f inside) const {
    const Vec3f across = cross(inside, normal_);
    const float cosine2 = 1 - dot(across, across), along = dot(inside, normal_);
    if (!(cosine2 > 0) || along <= 0) return std::nullopt;
    const Vec3f w = normalize(inside - (along - std::sqrt(cosine2)) * normal_);
    if (w.z <= 0) return std::nullopt;
    return w;
}

float TiltedCoat::mixed_pdf(float pdf, const Ray& o) const {
    return as_flat() * pdf + beyond_ * o.beyond +
           kAround * std::numbers::inv_pi_v<float> * o.cosine;
}

std::array<Vec3f, 2> TiltedCoat::turned_up(Vec3f wo) const {
    return {frame_.to_local(wo), frame_.to_local(Vec3f{wo.x, wo.y, -wo.z})};
}

float TiltedCoat::chosen(const Patch* patch, const Ray& i) const {
    if (!lobe_) return 0;
    const UnitRange range = flat_.interface_lobe_range(patch, i.flat);
    return range.to - range.from;
}

float TiltedCoat::density(Vec3f wi, const Ray& i, Vec3f wo, const Ray& o, float flat,
                          float chosen) const {
    if (!lobe_) return mixed_pdf(flat * o.jacobian, o);
    const float others = std::max(flat - chosen * lobe_->pdf(i.flat, o.flat), 0.0f);
    const auto [up, down] = turned_up(wo);
    const Vec3f from = frame_.to_local(wi);
    const float lobe = lobe_->pdf(from, up) + lobe_->pdf(from, down);
    return mixed_pdf(others * o.jacobian + chosen * lobe, o);
}

FloatLanes TiltedCoat::value(Vec3f wi, const Ray& i, Vec3f wo, const Ray& o,
                             const FloatLanes& flat) const {
    if (!lobe_) return flat * transmittance(i) * transmittance(o) * o.irradiance;
    const FloatLanes layers = max_lanes(flat - lobe_->eval(i.flat, o.flat), FloatLanes{});
    const auto [up, down] = turned_up(wo);
    const Vec3f from = frame_.to_local(wi);
    const FloatLanes lobe = lobe_->eval(from, up) * up.z + lobe_->eval(from, down) * down.z;
    return layers * transmittance(i) * transmittance(o) * o.irradiance + lobe * (1 / wo.z);
}

template <class Evaluate>
BsdfValue TiltedCoat::evaluate_by(const Patch* patch, Vec3f wi, Vec3f wo,
                                  const Evaluate& evaluate) const {
    const auto i = ray_of(wi), o = ray_of(wo);
    if (!i || !o) return {};
    const BsdfValue flat = evaluate(i->flat, o->flat);
    return {value(wi, *i, wo, *o, flat.f), density(wi, *i, wo, *o, flat.pdf, chosen(patch, *i))};
}

template <class Sample, class Evaluate>
std::optional<BsdfSample> TiltedCoat::sample_by(const Patch* patch, Vec3f wi, float u_select,
                                                Vec2f u, const Sample& sample,
                                                const Evaluate& evaluate) const {
    const auto i = ray_of(wi);
    if (!i) return std::nullopt;
    const auto valued = [&](Vec3f wo) -> std::optional<BsdfSample> {
        BsdfSample out;
        out.wo = wo;
        const BsdfValue value = evaluate_by(patch, wi, wo, evaluate);
        if (!(value.pdf > 0)) return std::nullopt;
        out.pdf = value.pdf;
        out.weight = value.f * (wo.z / value.pdf);
        return out;
    };
    if (u_select >= 1 - kAround)
        return valued(Frame::around(normal_).to_world(cosine_hemisphere(u)));
    if (u_select >= as_flat()) {
        const auto wo = sample_beyond(u);
        return wo ? valued(*wo) : std::nullopt;
    }
    const float rest = std::min(u_select / as_flat(), 0x1.fffffep-1f);
    const UnitRange of_lobe = lobe_ ? flat_.interface_lobe_range(patch, i->flat) : UnitRange{};
    if (rest >= of_lobe.from && rest < of_lobe.to) {
        const float u_sign = (rest - of_lobe.from) / (of_lobe.to - of_lobe.from);
        const Vec3f reflected = lobe_->sample(frame_.to_local(wi), u_sign, u);
        if (reflected.z <= 0) return std::nullopt;
        Vec3f wo = frame_.to_world(reflected);
        wo.z = std::abs(wo.z);
        return valued(wo);
    }
    auto out = sample(i->flat, rest, u);
    if (!out) return std::nullopt;
    if (out->kind == SampleKind::specular) {
        out->pdf *= as_flat();
        out->wo = 2 * i->cosine * normal_ - wi;
        out->wo.z = std::max(std::abs(out->wo.z), 1e-6f);
        out->weight = optics::dielectric_reflectance(splat(1.0f), index_.each, splat(i->cosine)) *
                      (1 / out->pdf);
        return out;
    }
    const auto wo = leave(out->wo);
    const auto o = wo ? ray_of(*wo) : std::nullopt;
    if (!o || o->jacobian == 0) return std::nullopt;
    // The same as evaluate_by(), without asking the flat coat again.
    if (lobe_) {
        const float flat_pdf = out->pdf;
        const FloatLanes f = value(wi, *i, *wo, *o, out->weight * (flat_pdf / out->wo.z));
        out->wo = *wo;
        out->pdf = density(wi, *i, *wo, *o, flat_pdf, of_lobe.to - of_lobe.from);
        out->weight = f * (wo->z / out->pdf);
        return out;
    }
    out->wo = *wo;
    const float flat_pdf = out->pdf * o->jacobian;
    out->pdf = mixed_pdf(flat_pdf, *o);
    out->weight *= transmittance(*i) * transmittance(*o) * (flat_pdf / out->pdf);
    return out;
}

float TiltedCoat::pdf(Vec3f wi, Vec3f wo) const {
    const auto i = ray_of(wi), o = ray_of(wo);
    if (!i || !o) return 0;
    return density(wi, *i, wo, *o, flat_.pdf(i->flat, o->flat), chosen(nullptr, *i));
}

FloatLanes TiltedCoat::pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const {
    const auto i = ray_of(wi);
    if (!i) return FloatLanes{};
    std::array<std::optional<Ray>, kLanes> rays;
    Vec3Lanes flat = splat(Vec3f{0, 0, 1});
    for (int k = 0; k < kLanes; ++k) {
        rays[k] = ray_of(lane(wo, k));
        if (!rays[k]) continue;
        flat.x[k] = rays[k]->flat.x;
        flat.y[k] = rays[k]->flat.y;
        flat.z[k] = rays[k]->flat.z;
    }
    const FloatLanes pdf = flat_.pdf_lanes(i->flat, flat);
    const float of_lobe = chosen(nullptr, *i);
    return make_lanes([&](int k) {
        if (!rays[k]) return 0.0f;
        return density(wi, *i, lane(wo, k), *rays[k], pdf[k], of_lobe);
    });
}

float TiltedCoat::specular_probability(Vec3f wi) const {
    const auto i = ray_of(wi);
    return i ? as_flat() * flat_.specular_probability(i->flat) : 0.0f;
}

BsdfValue TiltedCoat::evaluate(Vec3f wi, Vec3f wo) const {
    return evaluate_by(nullptr, wi, wo, [&](Vec3f i, Vec3f o) { return flat_.evaluate(i, o); });
}

BsdfValue TiltedCoat::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    return evaluate_by(&patch, wi, wo,
                       [&](Vec3f i, Vec3f o) { return flat_.evaluate_on(patch, i, o); });
}

std::optional<BsdfSample> TiltedCoat::sample(Vec3f wi, float u_select, Vec2f u) const {
    return sample_by(
        nullptr, wi, u_select, u,
        [&](Vec3f i, float select, Vec2f at) { return flat_.sample(i, select, at); },
        [&](Vec3f i, Vec3f o) { return flat_.evaluate(i, o); });
}

std::optional<BsdfSample> TiltedCoat::sample_on(const Patch& patch, Vec3f wi, float u_select,
                                                Vec2f u) const {
    return sample_by(
        &patch, wi, u_select, u,
        [&](Vec3f i, float select, Vec2f at) { return flat_.sample_on(patch, i, select, at); },
        [&](Vec3f i, Vec3f o) { return flat_.evaluate_on(patch, i, o); });
}

float TiltedCoat::narrow_light_pdf(Vec3f wi) const {
    const auto i = ray_of(wi);
    return i ? flat_.narrow_light_pdf(i->flat) : std::numeric_limits<float>::infinity();
}

void TiltedCoat::sample_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                               std::vector<FlakeSamples>& list) const {
    list.clear();
    const auto i = ray_of(wi);
    if (!i) return;
    flat_.sample_flakes(patch, i->flat, random, list);
    for_each_sample(list, [&](Vec3f& flake_wo, float& pdf) {
        const auto wo = leave(flake_wo);
        const auto o = wo ? ray_of(*wo) : std::nullopt;
        if (!o || o->jacobian == 0) return false;
        flake_wo = *wo;
        pdf *= o->jacobian;
        return true;
    });
}

FloatLanes TiltedCoat::flake_weight(const Patch& patch, Vec3f wi, const FlakeSample& flake) const {
    const auto i = ray_of(wi), o = ray_of(flake.wo);
    if (!i || !o || o->jacobian == 0) return FloatLanes{};
    FlakeSample in_flat = flake;
    in_flat.wo = o->flat;
    in_flat.pdf = flake.pdf / o->jacobian;
    return flat_.flake_weight(patch, i->flat, in_flat) * transmittance(*i) * transmittance(*o);
}

FloatLanes TiltedCoat::flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const {
    const auto i = ray_of(wi), o = ray_of(wo);
    if (!i || !o) return FloatLanes{};
    // Beyond the flat coat's critical angle no flake is sampled, and nothing is weighed.
    const float flat_pdf =
        o->jacobian > 0 ? pdf / o->jacobian : std::numeric_limits<float>::infinity();
    return flat_.flakes_at(patch, i->flat, o->flat, flat_pdf) * transmittance(*i) *
           transmittance(*o) * o->irradiance;
}

}  // namespace nacre::bsdf
