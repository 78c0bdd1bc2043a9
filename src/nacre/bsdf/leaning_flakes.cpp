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

/// Probability of a sample of the cosine-weighted hemisphere: those of the flat paint do not reach
/// directions beyond its critical angle, which have a tenth and more of all light.
constexpr float kHemisphereProbability = 1 / 4.0f;

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
    const float scale = 2 * n.z / (2 * n.z * n.z - 1);  // sin(t) scale = tan(2t)
    return Lean({n.x * scale, n.y * scale});
}

std::unique_ptr<const BoundBsdf> bind_with_lean(const Bsdf& surface,
                                                const Wavelengths& wavelengths_nm) {
    auto bound = surface.bind(wavelengths_nm);
    const auto lean = surface.flake_lean();
    if (!lean) return bound;
    return std::make_unique<const LeaningFlakes>(std::move(bound), LeaningFlakes::Lean(*lean));
}

LeaningFlakes::LeaningFlakes(const BoundBsdf& flat, const Lean& lean,
                             std::optional<Vec3f> fixed_direction)
    : flat_(flat),
      lean_(lean),
      double_lean_(lean.twice()),
      index_(flat.binder_index()),
      coat_depth_(flat.coat_depth()),
      coat_absorbs_(lane_max(coat_depth_) > 0),
      critical_cosine_(
          std::sqrt(1 - (1 - kMinFlatCosine * kMinFlatCosine) / (index_.mean * index_.mean))),
      ground_(flat.multiply_scattered({0, 0, 1}, direction_away_from({1, 0})).from_ground) {
    if (over_ground()) along_normal_ = flat_passage(1, 1);
    if (const auto ray = fixed_direction ? ray_of(*fixed_direction) : std::nullopt) {
        kept_path_ = path_of(*ray);
        if (over_ground()) kept_path_->ground = ground_rays(*kept_path_);
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
    if (!(ray.cosine > 0) || !(dot(ray.inside, double_lean_.n) > 0)) return std::nullopt;
    ray.flat = outside_flat_coat(lean_, ray.inside);
    const bool leaves = ray.flat.z > kMinFlatCosine;
    ray.jacobian = leaves ? ray.cosine * w.z / (ray.inside.z * ray.flat.z) : 0.0f;
    return ray;
}

// Outside a flat coat over flakes that lean so, of a direction inside; at the critical angle if beyond it.
Vec3f LeaningFlakes::outside_flat_coat(const Lean& lean, Vec3f inside) const {
    const float n = index_.mean, x = n * dot(inside, lean.s), y = n * dot(inside, lean.t);
    const float sine2 = x * x + y * y, cosine2 = 1 - sine2;
    if (cosine2 > kMinFlatCosine * kMinFlatCosine) return {x, y, std::sqrt(cosine2)};
    const float scale = std::sqrt((1 - kMinFlatCosine * kMinFlatCosine) / sine2);
    return {x * scale, y * scale, kMinFlatCosine};
}

LeaningFlakes::Path LeaningFlakes::path_of(const Ray& ray) const {
    Path path;
    static_cast<Ray&>(path) = ray;
    path.double_lean = outside_flat_coat(double_lean_, ray.inside);
    const OpticalDepths depths = flat_.optical_depths(ray.cosine);
    const FloatLanes depth = depths.flake_extinction + depths.pigment_extinction;
    path.depth = depth * (1 / ray.inside.z);
    path.flat_depth = depth * (1 / ray.cosine);
    path.transmittance = transmittance(ray.outside.z);
    path.multiple_factor = path.transmittance / transmittance(ray.flat.z);
    path.returned_factor = path.transmittance / transmittance(path.double_lean.z);
    if (coat_absorbs_) {
        const float path_length = 1 / ray.inside.z;  // through a coat of thickness 1
        path.multiple_factor *= exp_lanes((1 / ray.cosine - path_length) * coat_depth_);
        path.returned_factor *=
            exp_lanes((1 / dot(ray.inside, double_lean_.n) - path_length) * coat_depth_);
    }
    return path;
}

const LeaningFlakes::Path* LeaningFlakes::path_of(Vec3f w, std::optional<Path>& storage) const {
    if (kept_path_ && w == kept_path_->outside) return &*kept_path_;
    const auto ray = ray_of(w);
    if (!ray) return nullptr;
    return &storage.emplace(path_of(*ray));
}

FloatLanes LeaningFlakes::attenuation_ratio(const Path& i, const Path& o) const {
    return (i.cosine * o.cosine / (i.inside.z * o.inside.z)) * mean_attenuation(i.depth + o.depth) /
           mean_attenuation(i.flat_depth + o.flat_depth);
}

LeaningFlakes::SubstitutePair LeaningFlakes::substitute_pair(const Path& path_i,
                                                             const Path& path_o) const {
    const float n = index_.mean;
    const Vec3f i = lean_.to_flakes(path_i.inside), o = lean_.to_flakes(path_o.inside);
    const Vec3f difference = i - o, h = normalize(i + o);
    Vec3f inside_i, inside_o;
    const bool steep = h.z <= critical_cosine_;
    if (steep) {
        const float scale =
            std::sqrt((1 - critical_cosine_ * critical_cosine_) / (h.x * h.x + h.y * h.y));
        inside_i = inside_o = {h.x * scale, h.y * scale, critical_cosine_};
    } else {
        const Vec3f e = dot(difference, difference) > 0 ? normalize(difference) : Vec3f{};
        // cos d h.z - sin d |e.z| = critical_cosine_, d half the angle between the two.
        const float d =
            std::acos(critical_cosine_ / std::hypot(h.z, e.z)) - std::atan2(std::abs(e.z), h.z);
        inside_i = std::cos(d) * h + std::sin(d) * e;
        inside_o = std::cos(d) * h - std::sin(d) * e;
    }
    const auto refract_out = [&](Vec3f in) {
        const float sine2 = n * n * (in.x * in.x + in.y * in.y);
        return normalize(Vec3f{n * in.x, n * in.y, std::sqrt(std::max(1e-8f, 1 - sine2))});
    };
    SubstitutePair pair;
    pair.wi = refract_out(inside_i);
    pair.wo = refract_out(inside_o);
    const auto with_flat_cosine = [&](Path path, float cosine) {
        const OpticalDepths depths = flat_.optical_depths(cosine);
        path.cosine = cosine;
        path.flat_depth = (depths.flake_extinction + depths.pigment_extinction) / cosine;
        return path;
    };
    const float extra_length =
        1 / path_i.inside.z - 1 / inside_i.z + 1 / path_o.inside.z - 1 / inside_o.z;
    pair.multiple_factor = path_i.transmittance / transmittance(pair.wi.z) *
                           (path_o.transmittance / transmittance(pair.wo.z)) *
                           exp_lanes(-extra_length * coat_depth_);
    if (!steep) {
        pair.single_factor =
            pair.multiple_factor * attenuation_ratio(with_flat_cosine(path_i, inside_i.z),
                                                     with_flat_cosine(path_o, inside_o.z));
    }
    return pair;
}

template <class F>
FloatLanes LeaningFlakes::value(const Path& i, const Path& o, const FloatLanes& f,
                                const F& eval_substitute) const {
    FloatLanes no_internal_reflection;
    if (beyond_critical(i, o)) {
        const SubstitutePair pair = substitute_pair(i, o);
        const MultiplyScattered multiple = flat_.multiply_scattered(pair.wi, pair.wo);
        no_internal_reflection =
            multiple.no_internal_reflection * pair.multiple_factor +
            max_lanes(eval_substitute(pair.wi, pair.wo) - multiple.all, FloatLanes{}) *
                pair.single_factor;
    } else {
        const MultiplyScattered multiple = flat_.multiply_scattered(i.flat, o.flat);
        no_internal_reflection =
            multiple.no_internal_reflection * i.multiple_factor * o.multiple_factor +
            (f - min_lanes(multiple.all, f)) * single_factor(i, o);
    }
    const MultiplyScattered double_lean = flat_.multiply_scattered(i.double_lean, o.double_lean);
    const FloatLanes returned =
        max_lanes(double_lean.all - (double_lean.no_internal_reflection + double_lean.from_ground),
                  FloatLanes{});
    return no_internal_reflection + returned * i.returned_factor * o.returned_factor +
           from_ground(i, o, double_lean.from_ground);
}

float LeaningFlakes::mixed_pdf(float flat, const Ray& o) {
    return (1 - kHemisphereProbability) * flat * o.jacobian +
           kHemisphereProbability * std::numbers::inv_pi_v<float> * o.outside.z;
}

float LeaningFlakes::pdf(Vec3f wi, Vec3f wo) const {
    const auto i = ray_of(wi), o = ray_of(wo);
    return i && o ? mixed_pdf(flat_.pdf(i->flat, o->flat), *o) : 0.0f;
}

template <class Evaluate, class F>
BsdfValue LeaningFlakes::evaluate_by(Vec3f wi, Vec3f wo, const Evaluate& evaluate_flat,
                                     const F& eval_substitute) const {
    std::optional<Path> storage_i, storage_o;
    const Path *i = path_of(wi, storage_i), *o = path_of(wo, storage_o);
    if (!i || !o) return {};
    BsdfValue flat;
    if (o->jacobian > 0) flat = evaluate_flat(i->flat, o->flat);
    return {value(*i, *o, flat.f, eval_substitute), mixed_pdf(flat.pdf, *o)};
}

template <class Sample, class Evaluate, class F>
std::optional<BsdfSample> LeaningFlakes::sample_by(Vec3f wi, float u_select, Vec2f u,
                                                   const Sample& sample_flat,
                                                   const Evaluate& evaluate_flat,
                                                   const F& eval_substitute) const {
    std::optional<Path> storage_i, storage_o;
    const Path* const i = path_of(wi, storage_i);
    if (!i) return std::nullopt;
    if (u_select >= 1 - kHemisphereProbability) {
        BsdfSample out;
        out.wo = cosine_hemisphere(u);
        const BsdfValue value = evaluate_by(wi, out.wo, evaluate_flat, eval_substitute);
        if (!(value.pdf > 0)) return std::nullopt;
        out.pdf = value.pdf;
        out.weight = value.f * (out.wo.z / value.pdf);
        return out;
    }
    const float u_flat = std::min(u_select / (1 - kHemisphereProbability), 0x1.fffffep-1f);
    auto out = sample_flat(i->flat, u_flat, u);
    if (!out) return std::nullopt;
    if (out->kind == SampleKind::specular) {
        // Of the interface, which does not lean.
        out->pdf *= 1 - kHemisphereProbability;
        out->wo = {-wi.x, -wi.y, wi.z};
        out->weight = (1.0f - i->transmittance) * (1 / out->pdf);
        return out;
    }
    const Vec3f inside = lean_.from_flakes(refracted(out->wo, index_.mean));
    const float x = index_.mean * inside.x, y = index_.mean * inside.y, cosine2 = 1 - x * x - y * y;
    if (!(cosine2 > 0) || !(inside.z > 0)) return std::nullopt;
    const auto ray = ray_of({x, y, std::sqrt(cosine2)});
    if (!ray || ray->jacobian == 0) return std::nullopt;
    // As evaluate_by(), with the f that the sample has.
    const Path* const o = &storage_o.emplace(path_of(*ray));
    const FloatLanes f = out->weight * (out->pdf / out->wo.z);
    out->wo = o->outside;
    out->pdf = mixed_pdf(out->pdf, *o);
    out->weight = value(*i, *o, f, eval_substitute) * (out->wo.z / out->pdf);
    return out;
}

FloatLanes LeaningFlakes::pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const {
    const auto i = ray_of(wi);
    if (!i) return FloatLanes{};
    // ray_of() and mixed_pdf() of eight directions; those below the horizon are computed as if above, and
    // masked at the end.
    const float n = index_.mean;
    const FloatLanes outside = max_lanes(wo.z, splat(1e-6f));
    const FloatLanes cosine_inside = sqrt_lanes(n * n - 1 + outside * outside);  // times n
    const Vec3Lanes inside = {wo.x, wo.y, cosine_inside};
    const FloatLanes x = dot(inside, splat(lean_.s)), y = dot(inside, splat(lean_.t)),
                     cosine = dot(inside, splat(lean_.n)), cosine2 = 1.0f - x * x - y * y;
    const FloatLanes z = sqrt_lanes(max_lanes(cosine2, splat(kMinFlatCosine * kMinFlatCosine)));
    const FloatLanes flat = flat_.pdf_lanes(i->flat, {x, y, z});
    const FloatLanes drawn = cosine2 > kMinFlatCosine * kMinFlatCosine
                                 ? flat * (cosine * outside / (cosine_inside * z))
                                 : FloatLanes{};
    const FloatLanes pdf = (1 - kHemisphereProbability) * drawn +
                           kHemisphereProbability * std::numbers::inv_pi_v<float> * outside;
    return wo.z > 0.0f ? pdf : FloatLanes{};
}

float LeaningFlakes::specular_probability(Vec3f wi) const {
    const auto i = ray_of(wi);
    return i ? (1 - kHemisphereProbability) * flat_.specular_probability(i->flat) : 0.0f;
}

BsdfValue LeaningFlakes::evaluate(Vec3f wi, Vec3f wo) const {
    return evaluate_by(
        wi, wo, [&](Vec3f i, Vec3f o) { return flat_.evaluate(i, o); },
        [&](Vec3f i, Vec3f o) { return flat_.eval(i, o); });
}

BsdfValue LeaningFlakes::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    return evaluate_by(
        wi, wo, [&](Vec3f i, Vec3f o) { return flat_.evaluate_on(patch, i, o); },
        [&](Vec3f i, Vec3f o) { return eval_substitute_on(patch, i, o); });
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
        [&](Vec3f i, Vec3f o) { return eval_substitute_on(patch, i, o); });
}

// Flakes are not sampled there; those that samples of wide light hit by chance would be outliers.
bool LeaningFlakes::is_substitute_mean(const Patch& patch) {
    return patch.flakes != Patch::Flakes::shown && !(patch.narrow_light_pdf > 0);
}

FloatLanes LeaningFlakes::eval_substitute_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    return is_substitute_mean(patch) ? flat_.eval(wi, wo) : flat_.evaluate_on(patch, wi, wo).f;
}

float LeaningFlakes::narrow_light_pdf(Vec3f wi) const {
    const auto i = ray_of(wi);
    return i ? flat_.narrow_light_pdf(i->flat) : std::numeric_limits<float>::infinity();
}

void LeaningFlakes::sample_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                                  std::vector<FlakeSamples>& list) const {
    list.clear();
    const auto i = ray_of(wi);
    // Substitute pairs have no samples of their own: eval_substitute_on() or flakes_at() has all their light.
    if (!i || i->jacobian == 0) return;
    flat_.sample_flakes(patch, i->flat, random, list);
    const float n = index_.mean;
    for_each_sample(list, [&](Vec3f& wo, float& pdf) {
        if (wo.z <= kMinFlatCosine) return false;
        const Vec3f in_flakes = refracted(wo, n), inside = lean_.from_flakes(in_flakes);
        const float x = n * inside.x, y = n * inside.y, cosine2 = 1 - x * x - y * y;
        if (!(cosine2 > 0)) return false;
        const float z = std::sqrt(cosine2);
        pdf *= in_flakes.z * z / (inside.z * wo.z);
        wo = {x, y, z};
        return true;
    });
}

FloatLanes LeaningFlakes::flake_weight(const Patch& patch, Vec3f wi,
                                       const FlakeSample& flake) const {
    std::optional<Path> storage_i, storage_o;
    const Path *i = path_of(wi, storage_i), *o = path_of(flake.wo, storage_o);
    if (!i || !o || beyond_critical(*i, *o)) return FloatLanes{};
    FlakeSample in_flat = flake;
    in_flat.wo = o->flat;
    in_flat.pdf = flake.pdf / o->jacobian;
    // The flat paint's cosine to its normal is c', here it is mu.
    return flat_.flake_weight(patch, i->flat, in_flat) * single_factor(*i, *o) *
           (o->inside.z / o->cosine);
}

FloatLanes LeaningFlakes::flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const {
    std::optional<Path> storage_i, storage_o;
    const Path *i = path_of(wi, storage_i), *o = path_of(wo, storage_o);
    if (!i || !o) return FloatLanes{};
    if (beyond_critical(*i, *o)) {
        if (is_substitute_mean(patch)) return FloatLanes{};
        const SubstitutePair pair = substitute_pair(*i, *o);
        return flat_.flakes_at(patch, pair.wi, pair.wo, std::numeric_limits<float>::infinity()) *
               pair.single_factor;
    }
    return flat_.flakes_at(patch, i->flat, o->flat, pdf / o->jacobian) * single_factor(*i, *o);
}

}  // namespace nacre::bsdf
