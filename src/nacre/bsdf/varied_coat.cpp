#include "nacre/bsdf/varied_coat.h"

namespace nacre::bsdf {

FloatLanes VariedCoat::changed(const FloatLanes& f, Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    const CoatChange change = mean_.coat_change(wi, wo, deviation_);
    return max_lanes(change.factor * f + change.added, FloatLanes{});
}

std::optional<BsdfSample> VariedCoat::changed(std::optional<BsdfSample> sample, Vec3f wi) const {
    if (!sample || sample->kind != SampleKind::density) return sample;
    const float weight_of_f = sample->wo.z / sample->pdf;
    sample->weight = changed(sample->weight * (1 / weight_of_f), wi, sample->wo) * weight_of_f;
    return sample;
}

FloatLanes VariedCoat::eval(Vec3f wi, Vec3f wo) const {
    return changed(mean_.eval(wi, wo), wi, wo);
}

BsdfValue VariedCoat::evaluate(Vec3f wi, Vec3f wo) const {
    const BsdfValue value = mean_.evaluate(wi, wo);
    return {changed(value.f, wi, wo), value.pdf};
}

BsdfValue VariedCoat::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    const BsdfValue value = mean_.evaluate_on(patch, wi, wo);
    return {changed(value.f, wi, wo), value.pdf};
}

std::optional<BsdfSample> VariedCoat::sample(Vec3f wi, float u_select, Vec2f u) const {
    return changed(mean_.sample(wi, u_select, u), wi);
}

std::optional<BsdfSample> VariedCoat::sample_on(const Patch& patch, Vec3f wi, float u_select,
                                                Vec2f u) const {
    return changed(mean_.sample_on(patch, wi, u_select, u), wi);
}

MultiplyScattered VariedCoat::multiply_scattered(Vec3f wi, Vec3f wo) const {
    const MultiplyScattered mean = mean_.multiply_scattered(wi, wo);
    const FloatLanes once_each_way = mean_.coat_factor(wi, wo, deviation_);
    return {changed(mean.all, wi, wo), mean.from_ground * once_each_way,
            mean.no_internal_reflection * once_each_way};
}

FloatLanes VariedCoat::flake_weight(const Patch& patch, Vec3f wi, const FlakeSample& flake) const {
    return mean_.flake_weight(patch, wi, flake) * mean_.coat_factor(wi, flake.wo, deviation_);
}

FloatLanes VariedCoat::flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const {
    return mean_.flakes_at(patch, wi, wo, pdf) * mean_.coat_factor(wi, wo, deviation_);
}

}  // namespace nacre::bsdf
