#include "nacre/bsdf/leaning_flakes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/core/lane_math.h"
#include "nacre/optics/fresnel.h"

namespace nacre::bsdf {
namespace {

/// Cosine outside of the flattest direction with which a flat paint is asked.
constexpr float kMinFlatCosine = 1e-3f;

/// rho* of light that is mirrored along the layer or down into it.
constexpr float kMinMirroredRatio = 0.1f;

/// Cosine outside under which the ground is seen where it is compared with itself.
constexpr float kFarCosine = 0.5f;
/// A - (A - 1) sqrt(rho* / rho) of light that would hardly leave flakes and interface but by the ground.
constexpr float kLeastReturnRatio = 0.1f;

/// E(x) = (1 - e^-x) / x.
FloatLanes escape(const FloatLanes& x) {
    const FloatLanes safe = max_lanes(x, splat(1e-20f));
    return one_minus_exp_lanes(safe) / safe;
}

/// ln(cosh g + s sinh(g) / g), g^2 = s^2 - r^2.
FloatLanes log_blocking(const FloatLanes& s, const FloatLanes& r) {
    const FloatLanes g = sqrt_lanes(max_lanes(s * s - r * r, splat(1e-8f)));
    const FloatLanes once = one_minus_exp_lanes(2.0f * g);
    return g + log_lanes(1.0f - 0.5f * once + s * (0.5f * once / g));
}

FloatLanes lost_on_the_way(const FlakeDepths& depths) { return depths.flakes + depths.swallowed; }

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

FloatLanes LeaningFlakes::Returned::eval(Vec3f wi, Vec3f wo) const {
    const FloatLanes known = flat_.unreturned(wi, wo) + flat_.from_ground(wi, wo);
    return max_lanes(flat_.scattered_again(wi, wo) - known, FloatLanes{});
}

std::unique_ptr<const BoundBsdf> bind_with_lean(const Bsdf& surface,
                                                const Wavelengths& wavelengths_nm) {
    auto bound = surface.bind(wavelengths_nm);
    const auto lean = surface.flake_lean();
    if (!lean) return bound;
    return std::make_unique<const LeaningFlakes>(std::move(bound), LeaningFlakes::Lean(*lean));
}

FloatLanes LeaningFlakes::again_factor(const Lean& lean, Vec3f wi, Vec3f wo) const {
    // The cosine to the layer's normal, and the tilted coat's own.
    const auto inside = [&](Vec3f w) {
        const Vec3f in = refracted(w, index_.mean);
        return Vec2f{in.z, dot(in, lean.n)};
    };
    const Vec2f i = inside(wi), o = inside(wo);
    if (!(i.x > 0) || !(i.y > 0) || !(o.x > 0) || !(o.y > 0)) return FloatLanes{};
    const float longer = 1 / i.x - 1 / i.y + 1 / o.x - 1 / o.y;  // the way through the clear coat
    return (o.x / o.y) * exp_lanes(-longer * coat_depth_);
}

FloatLanes LeaningFlakes::seen_once(Vec3f true_i, Vec3f true_o, float cosine_i,
                                    float cosine_o) const {
    const auto depth = [&](float cosine) {
        const FlakeDepths depths = flat_.flake_depths(cosine);
        return depths.flakes + depths.pigments;
    };
    const FloatLanes here =
        depth(dot(true_i, lean_.n)) / true_i.z + depth(dot(true_o, lean_.n)) / true_o.z;
    const FloatLanes asked = depth(cosine_i) / cosine_i + depth(cosine_o) / cosine_o;
    return (cosine_i * cosine_o / (true_i.z * true_o.z)) * escape(here) / escape(asked);
}

FloatLanes LeaningFlakes::once_over_again(Vec3f wi, Vec3f wo) const {
    const Vec3f i = refracted(wi, index_.mean), o = refracted(wo, index_.mean);
    const float cosine_i = dot(i, lean_.n), cosine_o = dot(o, lean_.n);
    if (!(i.z > 0) || !(o.z > 0) || !(cosine_i > 0) || !(cosine_o > 0)) return FloatLanes{};
    return seen_once(i, o, cosine_i, cosine_o);
}

LeaningFlakes::GroundRays LeaningFlakes::ground_rays(Vec3f w) const {
    const float n = index_.mean;
    const Vec3f in = refracted(w, n), there = twice_.to_flakes(in);
    const float cosine = dot(in, lean_.n);
    GroundRays rays;
    if (!(in.z > 0) || !(cosine > 0) || !(there.z > 0)) return rays;

    const FlakeDepths depths = flat_.flake_depths(cosine);
    const FloatLanes met = lost_on_the_way(depths) * (1 / cosine);
    const float down = in.z / cosine, up = std::max(2 * lean_.n.z - down, kMinMirroredRatio);
    const FloatLanes passed =
        0.5f * (1 / up - 1 / down) * met -
        log_blocking(0.5f * (1 / up + 1 / down) * met,
                     depths.mirrored * (1 / (cosine * std::sqrt(down * up)))) -
        coat_depth_ * (1 / in.z);
    const auto transmittance = [&](float outside) {
        return 1.0f - optics::dielectric_reflectance(splat(1.0f), index_.each, splat(outside));
    };
    const FloatLanes entered = transmittance(w.z);
    // By which light of the flat paint differs that is asked with these cosines inside and outside.
    const auto over_flat = [&](float z, float outside) {
        const FlakeDepths flat = flat_.flake_depths(z);
        const FloatLanes passed_there =
            -log_blocking(lost_on_the_way(flat) * (1 / z), flat.mirrored * (1 / z)) -
            coat_depth_ * (1 / z);
        return entered / transmittance(outside) * exp_lanes(passed - passed_there);
    };
    const float across = std::hypot(there.x, there.y);
    const Vec2f azimuth =
        across > 0 ? Vec2f{there.x / across, there.y / across} : Vec2f{1.0f, 0.0f};
    const auto ask = [&](float z, float weight) {
        const float sine = n * std::sqrt(std::max(0.0f, 1 - z * z));
        const Vec3f asked = normalize(
            Vec3f{sine * azimuth.x, sine * azimuth.y, std::sqrt(std::max(1e-8f, 1 - sine * sine))});
        rays.w[rays.count] = asked;
        rays.factor[rays.count] = weight * over_flat(z, asked.z);
        ++rays.count;
    };
    // The cosine inside at which the flat paint's light just leaves.
    const float least = std::sqrt(1 - (1 - kMinFlatCosine * kMinFlatCosine) / (n * n));
    if (there.z >= least) {
        ask(there.z, 1);
    } else {
        ask(least, 2);
        ask(std::cos(2 * std::acos(least) - std::acos(there.z)), -1);
    }

    // A: seen from far on the other side, where large flakes have no hot spot.
    const float far = std::sqrt(1 - kFarCosine * kFarCosine);
    const Vec3f from{-far * azimuth.x, -far * azimuth.y, kFarCosine};
    const FloatLanes along_normal = flat_.from_ground({0, 0, 1}, from) * over_flat(1, 1);
    FloatLanes here{};
    for (int k = 0; k < rays.count; ++k)
        here += flat_.from_ground(rays.w[k], from) * rays.factor[k];
    const FloatLanes returned =
        max_lanes(here / max_lanes(along_normal, splat(1e-20f)), splat(1.0f)) - 1.0f;
    const FloatLanes here_over_flat =
        max_lanes(1.0f + returned * (1 - std::sqrt(up / down)), splat(kLeastReturnRatio));
    for (int k = 0; k < rays.count; ++k) {
        rays.factor[k] = along_normal > 0.0f ? rays.factor[k] / here_over_flat : rays.factor[k];
    }
    return rays;
}

FloatLanes LeaningFlakes::from_ground_here(Vec3f wi, Vec3f wo) const {
    const GroundRays i = ground_rays(wi), o = ground_rays(wo);
    FloatLanes sum{};
    for (int a = 0; a < i.count; ++a) {
        for (int b = 0; b < o.count; ++b) {
            sum += flat_.from_ground(i.w[a], o.w[b]) * i.factor[a] * o.factor[b];
        }
    }
    return max_lanes(sum, FloatLanes{});
}

std::optional<LeaningFlakes::Nearest> LeaningFlakes::nearest(Vec3f wi, Vec3f wo) const {
    const float n = index_.mean;
    // The cosine inside at which the flat paint's light just leaves.
    const float least = std::sqrt(1 - (1 - kMinFlatCosine * kMinFlatCosine) / (n * n));
    const Vec3f in_i = refracted(wi, n), in_o = refracted(wo, n);
    const Vec3f i = lean_.to_flakes(in_i), o = lean_.to_flakes(in_o);
    if (i.z >= least && o.z >= least) return std::nullopt;
    Nearest pair{{0, 0, 1}, {0, 0, 1}, {}};
    const Vec3f sum = i + o, apart = i - o;
    if (!(i.z > 0) || !(o.z > 0) || !(dot(apart, apart) > 0)) return pair;
    const Vec3f h = normalize(sum), e = normalize(apart);
    if (h.z <= least) return pair;  // of steep flakes, of which there are none
    // cos d h.z - sin d |e.z| = least, d half the angle between the two.
    const float d = std::acos(least / std::hypot(h.z, e.z)) - std::atan2(std::abs(e.z), h.z);
    if (!(d > 0)) return pair;
    const Vec3f there_i = std::cos(d) * h + std::sin(d) * e;
    const Vec3f there_o = std::cos(d) * h - std::sin(d) * e;
    const auto leave = [&](Vec3f in) {
        const float sine2 = n * n * (in.x * in.x + in.y * in.y);
        return normalize(Vec3f{n * in.x, n * in.y, std::sqrt(std::max(1e-8f, 1 - sine2))});
    };
    pair.wi = leave(there_i);
    pair.wo = leave(there_o);
    const auto passed = [&](float cosine) {
        return 1.0f - optics::dielectric_reflectance(splat(1.0f), index_.each, splat(cosine));
    };
    const FloatLanes paths = seen_once(in_i, in_o, there_i.z, there_o.z);
    const float longer = 1 / in_i.z - 1 / there_i.z + 1 / in_o.z - 1 / there_o.z;
    pair.factor = passed(wi.z) / passed(pair.wi.z) * (passed(wo.z) / passed(pair.wo.z)) * paths *
                  exp_lanes(-longer * coat_depth_);
    return pair;
}

template <class Flat>
FloatLanes LeaningFlakes::righted(const FloatLanes& tilted, Vec3f wi, Vec3f wo,
                                  const Flat& flat) const {
    const Vec3f i = lean_.to_flakes(wi), o = lean_.to_flakes(wo);
    const FloatLanes again = again_factor(lean_, wi, wo);
    FloatLanes once{};
    if (const auto pair = nearest(wi, wo)) {
        const FloatLanes all = flat(pair->wi, pair->wo);
        once =
            max_lanes(all - flat_.scattered_again(pair->wi, pair->wo), FloatLanes{}) * pair->factor;
    } else {
        once =
            (tilted - min_lanes(coat_again_.eval(i, o), tilted)) * again * once_over_again(wi, wo);
    }
    const FloatLanes unreturned = coat_unreturned_.eval(i, o);
    const FloatLanes returned = coat_returned_.eval(twice_.to_flakes(wi), twice_.to_flakes(wo));
    return once + unreturned * again + returned * again_factor(twice_, wi, wo) +
           from_ground_here(wi, wo);
}

float LeaningFlakes::pdf(Vec3f wi, Vec3f wo) const {
    return coat_.pdf(lean_.to_flakes(wi), lean_.to_flakes(wo));
}

FloatLanes LeaningFlakes::pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const {
    Vec3Lanes turned;
    for (int k = 0; k < kLanes; ++k) {
        const Vec3f w = lean_.to_flakes(lane(wo, k));
        turned.x[k] = w.x;
        turned.y[k] = w.y;
        turned.z[k] = w.z;
    }
    return coat_.pdf_lanes(lean_.to_flakes(wi), turned);
}

float LeaningFlakes::specular_probability(Vec3f wi) const {
    return coat_.specular_probability(lean_.to_flakes(wi));
}

BsdfValue LeaningFlakes::evaluate(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    BsdfValue value = coat_.evaluate(lean_.to_flakes(wi), lean_.to_flakes(wo));
    value.f = righted(value.f, wi, wo, [&](Vec3f i, Vec3f o) { return flat_.eval(i, o); });
    return value;
}

BsdfValue LeaningFlakes::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    BsdfValue value = coat_.evaluate_on(patch, lean_.to_flakes(wi), lean_.to_flakes(wo));
    value.f = righted(value.f, wi, wo,
                      [&](Vec3f i, Vec3f o) { return flat_.evaluate_on(patch, i, o).f; });
    return value;
}

template <class Flat>
std::optional<BsdfSample> LeaningFlakes::turned(std::optional<BsdfSample> sample, Vec3f wi,
                                                const Flat& flat) const {
    if (!sample) return sample;
    if (sample->kind == SampleKind::specular) {
        sample->wo = {-wi.x, -wi.y, wi.z};  // whatever the flakes do
        return sample;
    }
    sample->wo = lean_.from_flakes(sample->wo);
    if (!(sample->wo.z > 0)) return std::nullopt;
    const float cosine_over_pdf = sample->wo.z / sample->pdf;
    sample->weight =
        righted(sample->weight * (1 / cosine_over_pdf), wi, sample->wo, flat) * cosine_over_pdf;
    return sample;
}

std::optional<BsdfSample> LeaningFlakes::sample(Vec3f wi, float u_select, Vec2f u) const {
    return turned(coat_.sample(lean_.to_flakes(wi), u_select, u), wi,
                  [&](Vec3f i, Vec3f o) { return flat_.eval(i, o); });
}

std::optional<BsdfSample> LeaningFlakes::sample_on(const Patch& patch, Vec3f wi, float u_select,
                                                   Vec2f u) const {
    return turned(coat_.sample_on(patch, lean_.to_flakes(wi), u_select, u), wi,
                  [&](Vec3f i, Vec3f o) { return flat_.evaluate_on(patch, i, o).f; });
}

float LeaningFlakes::narrow_light(Vec3f wi) const {
    return coat_.narrow_light(lean_.to_flakes(wi));
}

void LeaningFlakes::ask_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                               std::vector<AskedFlake>& list) const {
    coat_.ask_flakes(patch, lean_.to_flakes(wi), random, list);
    for (AskedFlake& flake : list) flake.wo = lean_.from_flakes(flake.wo);
    // Where a pair stands for another nothing is asked: flakes_at() has it all.
    std::erase_if(list, [&](const AskedFlake& flake) {
        return !(flake.wo.z > 0) || nearest(wi, flake.wo).has_value();
    });
}

FloatLanes LeaningFlakes::flake_weight(const Patch& patch, Vec3f wi,
                                       const AskedFlake& flake) const {
    AskedFlake asked = flake;
    asked.wo = lean_.to_flakes(flake.wo);
    return coat_.flake_weight(patch, lean_.to_flakes(wi), asked) *
           again_factor(lean_, wi, flake.wo) * once_over_again(wi, flake.wo);
}

FloatLanes LeaningFlakes::flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const {
    if (const auto pair = nearest(wi, wo)) {
        return flat_.flakes_at(patch, pair->wi, pair->wo, std::numeric_limits<float>::infinity()) *
               pair->factor;
    }
    return coat_.flakes_at(patch, lean_.to_flakes(wi), lean_.to_flakes(wo), pdf) *
           again_factor(lean_, wi, wo) * once_over_again(wi, wo);
}

}  // namespace nacre::bsdf
