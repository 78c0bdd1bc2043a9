#include "nacre/bsdf/leaning_flakes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/bsdf/warp.h"
#include "nacre/core/lane_math.h"
#include "nacre/optics/fresnel.h"

namespace nacre::bsdf {
namespace {

/// Fraction of the samples that are spread over the hemisphere: the flat paint's own do not reach what
/// lies beyond its critical angle, a tenth and more of all light.
constexpr float kAround = 1 / 4.0f;

Vec3f refracted(Vec3f w, float n) {
    const float sine2 = (w.x * w.x + w.y * w.y) / (n * n);
    return {w.x / n, w.y / n, std::sqrt(std::max(0.0f, 1 - sine2))};
}

}  // namespace

LeaningFlakes::Lean::Lean(Vec2f tangents) : n(normalize(Vec3f{tangents.x, tangents.y, 1})) {
    // Of the upper half, as n always is, this is the shortest turn of z into n.
    const Frame frame = Frame::around(n);
    s = frame.s;
    t = frame.t;
}

LeaningFlakes::Lean LeaningFlakes::Lean::twice() const {
    // n stays far from 45 deg (paint::limits::kLeanTilt).
    const float longer = 2 * n.z / (2 * n.z * n.z - 1);
    return Lean({n.x * longer, n.y * longer});
}

std::unique_ptr<const BoundBsdf> bind_with_lean(const Bsdf& surface,
                                                const Wavelengths& wavelengths_nm) {
    auto bound = surface.bind(wavelengths_nm);
    const auto lean = surface.flake_lean();
    if (!lean) return bound;
    return std::make_unique<const LeaningFlakes>(std::move(bound), LeaningFlakes::Lean(*lean));
}

LeaningFlakes::LeaningFlakes(const BoundBsdf& flat, const Lean& lean,
                             std::optional<Vec3f> seen_from)
    : flat_(flat),
      lean_(lean),
      twice_(lean.twice()),
      index_(flat.binder_index()),
      coat_depth_(flat.coat_depth()),
      coat_absorbs_(lane_max(coat_depth_) > 0),
      least_cosine_(
          std::sqrt(1 - (1 - kMinFlatCosine * kMinFlatCosine) / (index_.mean * index_.mean))),
      ground_(flat.multiply_scattered({0, 0, 1}, far_from({1, 0})).from_ground) {
    if (over_ground()) along_normal_ = flat_passage(1, 1);
    if (const auto ray = seen_from ? ray_of(*seen_from) : std::nullopt) {
        seen_from_ = see(*ray);
        if (over_ground()) seen_from_->ground = ground_rays(*seen_from_);
    }
}

FloatLanes LeaningFlakes::transmittance(float cosine_outside) const {
    return 1.0f - optics::dielectric_reflectance(splat(1.0f), index_.each, splat(cosine_outside));
}

std::optional<LeaningFlakes::Ray> LeaningFlakes::ray_of(Vec3f w) const {
    if (w.z <= 0) return std::nullopt;
    Ray ray;
    ray.outside = w;
    ray.inside = refracted(w, index_.mean);
    // Within the critical angle, and no lean goes beyond the rest (paint::limits::kLeanTilt).
    ray.cosine = dot(ray.inside, lean_.n);
    if (!(ray.cosine > 0) || !(dot(ray.inside, twice_.n) > 0)) return std::nullopt;
    ray.flat = flat_of(lean_, ray.inside);
    const bool leaves = ray.flat.z > kMinFlatCosine;
    ray.jacobian = leaves ? ray.cosine * w.z / (ray.inside.z * ray.flat.z) : 0.0f;
    return ray;
}

// Outside a flat coat, of a direction inside that the frame of the lean turns; beyond the critical angle at it.
Vec3f LeaningFlakes::flat_of(const Lean& lean, Vec3f inside) const {
    const float n = index_.mean, x = n * dot(inside, lean.s), y = n * dot(inside, lean.t);
    const float sine2 = x * x + y * y, cosine2 = 1 - sine2;
    if (cosine2 > kMinFlatCosine * kMinFlatCosine) return {x, y, std::sqrt(cosine2)};
    const float shorter = std::sqrt((1 - kMinFlatCosine * kMinFlatCosine) / sine2);
    return {x * shorter, y * shorter, kMinFlatCosine};
}

LeaningFlakes::Seen LeaningFlakes::see(const Ray& ray) const {
    Seen seen;
    static_cast<Ray&>(seen) = ray;
    seen.twice = flat_of(twice_, ray.inside);
    const FlakeDepths depths = flat_.flake_depths(ray.cosine);
    const FloatLanes depth = depths.flakes + depths.pigments;
    seen.depth = depth * (1 / ray.inside.z);
    seen.asked = depth * (1 / ray.cosine);
    seen.transmitted = transmittance(ray.outside.z);
    seen.again = seen.transmitted / transmittance(ray.flat.z);
    seen.again_twice = seen.transmitted / transmittance(seen.twice.z);
    if (coat_absorbs_) {
        // The way through the clear coat is that of the true direction.
        const float here = 1 / ray.inside.z;
        seen.again *= exp_lanes((1 / ray.cosine - here) * coat_depth_);
        seen.again_twice *= exp_lanes((1 / dot(ray.inside, twice_.n) - here) * coat_depth_);
    }
    return seen;
}

const LeaningFlakes::Seen* LeaningFlakes::see(Vec3f w, std::optional<Seen>& room) const {
    if (seen_from_ && w == seen_from_->outside) return &*seen_from_;
    const auto ray = ray_of(w);
    if (!ray) return nullptr;
    return &room.emplace(see(*ray));
}

FloatLanes LeaningFlakes::seen_once(const Seen& i, const Seen& o) const {
    return (i.cosine * o.cosine / (i.inside.z * o.inside.z)) * mean_attenuation(i.depth + o.depth) /
           mean_attenuation(i.asked + o.asked);
}

LeaningFlakes::Nearest LeaningFlakes::nearest(const Seen& seen_i, const Seen& seen_o) const {
    const float n = index_.mean;
    const Vec3f i = lean_.to_flakes(seen_i.inside), o = lean_.to_flakes(seen_o.inside);
    const Vec3f apart = i - o, h = normalize(i + o);
    Vec3f there_i, there_o;
    const bool steep = h.z <= least_cosine_;
    if (steep) {
        const float flatter =
            std::sqrt((1 - least_cosine_ * least_cosine_) / (h.x * h.x + h.y * h.y));
        there_i = there_o = {h.x * flatter, h.y * flatter, least_cosine_};
    } else {
        const Vec3f e = dot(apart, apart) > 0 ? normalize(apart) : Vec3f{};
        // cos d h.z - sin d |e.z| = least_cosine_, d half the angle between the two.
        const float d =
            std::acos(least_cosine_ / std::hypot(h.z, e.z)) - std::atan2(std::abs(e.z), h.z);
        there_i = std::cos(d) * h + std::sin(d) * e;
        there_o = std::cos(d) * h - std::sin(d) * e;
    }
    const auto leave = [&](Vec3f in) {
        const float sine2 = n * n * (in.x * in.x + in.y * in.y);
        return normalize(Vec3f{n * in.x, n * in.y, std::sqrt(std::max(1e-8f, 1 - sine2))});
    };
    Nearest pair;
    pair.wi = leave(there_i);
    pair.wo = leave(there_o);
    const auto asked_there = [&](Seen seen, float cosine) {
        const FlakeDepths depths = flat_.flake_depths(cosine);
        seen.cosine = cosine;
        seen.asked = (depths.flakes + depths.pigments) / cosine;
        return seen;
    };
    const float longer = 1 / seen_i.inside.z - 1 / there_i.z + 1 / seen_o.inside.z - 1 / there_o.z;
    pair.again = seen_i.transmitted / transmittance(pair.wi.z) *
                 (seen_o.transmitted / transmittance(pair.wo.z)) * exp_lanes(-longer * coat_depth_);
    if (!steep) {
        pair.once =
            pair.again * seen_once(asked_there(seen_i, there_i.z), asked_there(seen_o, there_o.z));
    }
    return pair;
}

template <class F>
FloatLanes LeaningFlakes::value(const Seen& i, const Seen& o, const FloatLanes& f,
                                const F& beyond) const {
    FloatLanes no_internal_reflection;
    if (beyond_critical(i, o)) {
        const Nearest pair = nearest(i, o);
        const MultiplyScattered again = flat_.multiply_scattered(pair.wi, pair.wo);
        no_internal_reflection =
            again.no_internal_reflection * pair.again +
            max_lanes(beyond(pair.wi, pair.wo) - again.all, FloatLanes{}) * pair.once;
    } else {
        const MultiplyScattered again = flat_.multiply_scattered(i.flat, o.flat);
        no_internal_reflection = again.no_internal_reflection * i.again * o.again +
                                 (f - min_lanes(again.all, f)) * once_factor(i, o);
    }
    const MultiplyScattered twice = flat_.multiply_scattered(i.twice, o.twice);
    const FloatLanes returned =
        max_lanes(twice.all - (twice.no_internal_reflection + twice.from_ground), FloatLanes{});
    return no_internal_reflection + returned * i.again_twice * o.again_twice +
           from_ground(i, o, twice.from_ground);
}

float LeaningFlakes::mixed_pdf(float flat, const Ray& o) {
    return (1 - kAround) * flat * o.jacobian +
           kAround * std::numbers::inv_pi_v<float> * o.outside.z;
}

float LeaningFlakes::pdf(Vec3f wi, Vec3f wo) const {
    const auto i = ray_of(wi), o = ray_of(wo);
    return i && o ? mixed_pdf(flat_.pdf(i->flat, o->flat), *o) : 0.0f;
}

template <class Evaluate, class F>
BsdfValue LeaningFlakes::evaluate_by(Vec3f wi, Vec3f wo, const Evaluate& asked,
                                     const F& beyond) const {
    std::optional<Seen> room_i, room_o;
    const Seen *i = see(wi, room_i), *o = see(wo, room_o);
    if (!i || !o) return {};
    BsdfValue flat;
    if (o->jacobian > 0) flat = asked(i->flat, o->flat);
    return {value(*i, *o, flat.f, beyond), mixed_pdf(flat.pdf, *o)};
}

template <class Sample, class Evaluate, class F>
std::optional<BsdfSample> LeaningFlakes::sample_by(Vec3f wi, float u_select, Vec2f u,
                                                   const Sample& sample, const Evaluate& asked,
                                                   const F& beyond) const {
    std::optional<Seen> room_i, room_o;
    const Seen* const i = see(wi, room_i);
    if (!i) return std::nullopt;
    if (u_select >= 1 - kAround) {
        BsdfSample out;
        out.wo = cosine_hemisphere(u);
        const BsdfValue value = evaluate_by(wi, out.wo, asked, beyond);
        if (!(value.pdf > 0)) return std::nullopt;
        out.pdf = value.pdf;
        out.weight = value.f * (out.wo.z / value.pdf);
        return out;
    }
    const float rest = std::min(u_select / (1 - kAround), 0x1.fffffep-1f);
    auto out = sample(i->flat, rest, u);
    if (!out) return std::nullopt;
    if (out->kind == SampleKind::specular) {
        // Of the interface, whatever the flakes do.
        out->pdf *= 1 - kAround;
        out->wo = {-wi.x, -wi.y, wi.z};
        out->weight = (1.0f - i->transmitted) * (1 / out->pdf);
        return out;
    }
    const Vec3f inside = lean_.from_flakes(refracted(out->wo, index_.mean));
    const float x = index_.mean * inside.x, y = index_.mean * inside.y, cosine2 = 1 - x * x - y * y;
    if (!(cosine2 > 0) || !(inside.z > 0)) return std::nullopt;
    const auto ray = ray_of({x, y, std::sqrt(cosine2)});
    if (!ray || ray->jacobian == 0) return std::nullopt;
    // The same as evaluate_by(), without asking the flat paint again.
    const Seen* const o = &room_o.emplace(see(*ray));
    const FloatLanes f = out->weight * (out->pdf / out->wo.z);
    out->wo = o->outside;
    out->pdf = mixed_pdf(out->pdf, *o);
    out->weight = value(*i, *o, f, beyond) * (out->wo.z / out->pdf);
    return out;
}

FloatLanes LeaningFlakes::pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const {
    const auto i = ray_of(wi);
    if (!i) return FloatLanes{};
    // ray_of() and mixed_pdf() of eight directions; those below the horizon are taken somewhere above, and
    // left out then.
    const float n = index_.mean;
    const FloatLanes outside = max_lanes(wo.z, splat(1e-6f));
    const FloatLanes along = sqrt_lanes(n * n - 1 + outside * outside);  // inside, times n
    const Vec3Lanes inside = {wo.x, wo.y, along};
    const FloatLanes x = dot(inside, splat(lean_.s)), y = dot(inside, splat(lean_.t)),
                     cosine = dot(inside, splat(lean_.n)), cosine2 = 1.0f - x * x - y * y;
    const FloatLanes z = sqrt_lanes(max_lanes(cosine2, splat(kMinFlatCosine * kMinFlatCosine)));
    const FloatLanes flat = flat_.pdf_lanes(i->flat, {x, y, z});
    const FloatLanes drawn = cosine2 > kMinFlatCosine * kMinFlatCosine
                                 ? flat * (cosine * outside / (along * z))
                                 : FloatLanes{};
    const FloatLanes pdf =
        (1 - kAround) * drawn + kAround * std::numbers::inv_pi_v<float> * outside;
    return wo.z > 0.0f ? pdf : FloatLanes{};
}

float LeaningFlakes::specular_probability(Vec3f wi) const {
    const auto i = ray_of(wi);
    return i ? (1 - kAround) * flat_.specular_probability(i->flat) : 0.0f;
}

BsdfValue LeaningFlakes::evaluate(Vec3f wi, Vec3f wo) const {
    return evaluate_by(
        wi, wo, [&](Vec3f i, Vec3f o) { return flat_.evaluate(i, o); },
        [&](Vec3f i, Vec3f o) { return flat_.eval(i, o); });
}

BsdfValue LeaningFlakes::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    return evaluate_by(
        wi, wo, [&](Vec3f i, Vec3f o) { return flat_.evaluate_on(patch, i, o); },
        [&](Vec3f i, Vec3f o) { return beyond_on(patch, i, o); });
}

std::optional<BsdfSample> LeaningFlakes::sample(Vec3f wi, float u_select, Vec2f u) const {
    return sample_by(
        wi, u_select, u,
        [&](Vec3f i, float select, Vec2f at) { return flat_.sample(i, select, at); },
        [&](Vec3f i, Vec3f o) { return flat_.evaluate(i, o); },
        [&](Vec3f i, Vec3f o) { return flat_.eval(i, o); });
}

std::optional<BsdfSample> LeaningFlakes::sample_on(const Patch& patch, Vec3f wi, float u_select,
                                                   Vec2f u) const {
    return sample_by(
        wi, u_select, u,
        [&](Vec3f i, float select, Vec2f at) { return flat_.sample_on(patch, i, select, at); },
        [&](Vec3f i, Vec3f o) { return flat_.evaluate_on(patch, i, o); },
        [&](Vec3f i, Vec3f o) { return beyond_on(patch, i, o); });
}

// No flakes are sampled there, and of those that happen to be met by samples of wide light a few would
// outshine the picture.
bool LeaningFlakes::is_mean_beyond(const Patch& patch) {
    return patch.flakes != Patch::Flakes::shown && !(patch.narrow_light_pdf > 0);
}

FloatLanes LeaningFlakes::beyond_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    return is_mean_beyond(patch) ? flat_.eval(wi, wo) : flat_.evaluate_on(patch, wi, wo).f;
}

float LeaningFlakes::narrow_light_pdf(Vec3f wi) const {
    const auto i = ray_of(wi);
    return i ? flat_.narrow_light_pdf(i->flat) : std::numeric_limits<float>::infinity();
}

void LeaningFlakes::sample_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                                  std::vector<FlakeSamples>& list) const {
    list.clear();
    const auto i = ray_of(wi);
    // Where a pair stands for another none is sampled: beyond_on() or flakes_at() has it all.
    if (!i || i->jacobian == 0) return;
    flat_.sample_flakes(patch, i->flat, random, list);
    const float n = index_.mean;
    for_each_sample(list, [&](Vec3f& wo, float& pdf) {
        if (wo.z <= kMinFlatCosine) return false;
        const Vec3f there = refracted(wo, n), inside = lean_.from_flakes(there);
        const float x = n * inside.x, y = n * inside.y, cosine2 = 1 - x * x - y * y;
        if (!(cosine2 > 0)) return false;
        const float z = std::sqrt(cosine2);
        pdf *= there.z * z / (inside.z * wo.z);
        wo = {x, y, z};
        return true;
    });
}

FloatLanes LeaningFlakes::flake_weight(const Patch& patch, Vec3f wi,
                                       const FlakeSample& flake) const {
    std::optional<Seen> room_i, room_o;
    const Seen *i = see(wi, room_i), *o = see(flake.wo, room_o);
    if (!i || !o || beyond_critical(*i, *o)) return FloatLanes{};
    FlakeSample in_flat = flake;
    in_flat.wo = o->flat;
    in_flat.pdf = flake.pdf / o->jacobian;
    // Its cosines are those to the flat paint.
    return flat_.flake_weight(patch, i->flat, in_flat) * once_factor(*i, *o) *
           (o->inside.z / o->cosine);
}

FloatLanes LeaningFlakes::flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const {
    std::optional<Seen> room_i, room_o;
    const Seen *i = see(wi, room_i), *o = see(wo, room_o);
    if (!i || !o) return FloatLanes{};
    if (beyond_critical(*i, *o)) {
        if (is_mean_beyond(patch)) return FloatLanes{};
        const Nearest pair = nearest(*i, *o);
        return flat_.flakes_at(patch, pair.wi, pair.wo, std::numeric_limits<float>::infinity()) *
               pair.once;
    }
    return flat_.flakes_at(patch, i->flat, o->flat, pdf / o->jacobian) * once_factor(*i, *o);
}

}  // namespace nacre::bsdf
