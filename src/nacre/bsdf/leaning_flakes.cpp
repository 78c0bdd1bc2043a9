#include "nacre/bsdf/leaning_flakes.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/lane_math.h"

namespace nacre::bsdf {

LeaningFlakes::Lean::Lean(Vec2f tangents) : n(normalize(Vec3f{tangents.x, tangents.y, 1})) {
    // Of the upper half, as n always is, this is the shortest turn of z into n.
    const Frame frame = Frame::around(n);
    s = frame.s;
    t = frame.t;
}

std::unique_ptr<const BoundBsdf> bind_with_lean(const Bsdf& surface,
                                                const Wavelengths& wavelengths_nm) {
    auto bound = surface.bind(wavelengths_nm);
    const auto lean = surface.flake_lean();
    if (!lean) return bound;
    return std::make_unique<const LeaningFlakes>(std::move(bound), LeaningFlakes::Lean(*lean));
}

LeaningFlakes::Factors LeaningFlakes::factors(Vec3f wi, Vec3f wo) const {
    const float n = index_.mean;
    // The cosine to the layer's normal, and the tilted coat's own.
    const auto inside = [&](Vec3f w) {
        const float sine2 = w.x * w.x + w.y * w.y;
        const Vec3f refracted = {w.x / n, w.y / n, std::sqrt(std::max(0.0f, 1 - sine2 / (n * n)))};
        return Vec2f{refracted.z, dot(refracted, lean_.n)};
    };
    const Vec2f i = inside(wi), o = inside(wo);
    if (!(i.x > 0) || !(i.y > 0) || !(o.x > 0) || !(o.y > 0)) return {};
    const float ratio_i = i.x / i.y, ratio_o = o.x / o.y;
    const float longer = 1 / i.x - 1 / i.y + 1 / o.x - 1 / o.y;  // the way through the clear coat
    const FloatLanes again = ratio_o * exp_lanes(-longer * coat_depth_);
    return {again * (2 / (ratio_i + ratio_o)), again};
}

FloatLanes LeaningFlakes::righted(const FloatLanes& tilted, Vec3f wi, Vec3f wo) const {
    const Factors by = factors(wi, wo);
    const FloatLanes again =
        min_lanes(coat_again_.eval(lean_.to_flakes(wi), lean_.to_flakes(wo)), tilted);
    return (tilted - again) * by.once + again * by.again;
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
    value.f = righted(value.f, wi, wo);
    return value;
}

BsdfValue LeaningFlakes::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    BsdfValue value = coat_.evaluate_on(patch, lean_.to_flakes(wi), lean_.to_flakes(wo));
    value.f = righted(value.f, wi, wo);
    return value;
}

std::optional<BsdfSample> LeaningFlakes::turned(std::optional<BsdfSample> sample, Vec3f wi) const {
    if (!sample) return sample;
    if (sample->kind == SampleKind::specular) {
        sample->wo = {-wi.x, -wi.y, wi.z};  // whatever the flakes do
        return sample;
    }
    sample->wo = lean_.from_flakes(sample->wo);
    if (!(sample->wo.z > 0)) return std::nullopt;
    const float cosine_over_pdf = sample->wo.z / sample->pdf;
    sample->weight =
        righted(sample->weight * (1 / cosine_over_pdf), wi, sample->wo) * cosine_over_pdf;
    return sample;
}

std::optional<BsdfSample> LeaningFlakes::sample(Vec3f wi, float u_select, Vec2f u) const {
    return turned(coat_.sample(lean_.to_flakes(wi), u_select, u), wi);
}

std::optional<BsdfSample> LeaningFlakes::sample_on(const Patch& patch, Vec3f wi, float u_select,
                                                   Vec2f u) const {
    return turned(coat_.sample_on(patch, lean_.to_flakes(wi), u_select, u), wi);
}

float LeaningFlakes::narrow_light(Vec3f wi) const {
    return coat_.narrow_light(lean_.to_flakes(wi));
}

void LeaningFlakes::ask_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                               std::vector<AskedFlake>& list) const {
    coat_.ask_flakes(patch, lean_.to_flakes(wi), random, list);
    for (AskedFlake& flake : list) flake.wo = lean_.from_flakes(flake.wo);
    std::erase_if(list, [](const AskedFlake& flake) { return !(flake.wo.z > 0); });
}

FloatLanes LeaningFlakes::flake_weight(const Patch& patch, Vec3f wi,
                                       const AskedFlake& flake) const {
    AskedFlake asked = flake;
    asked.wo = lean_.to_flakes(flake.wo);
    return coat_.flake_weight(patch, lean_.to_flakes(wi), asked) * factors(wi, flake.wo).once;
}

FloatLanes LeaningFlakes::flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const {
    return coat_.flakes_at(patch, lean_.to_flakes(wi), lean_.to_flakes(wo), pdf) *
           factors(wi, wo).once;
}

}  // namespace nacre::bsdf
