#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"

namespace nacre::bsdf {

/// A paint at one point of a tinted coat whose thickness varies: all light that has crossed the coat is
/// changed by BoundBsdf::coat_change(), and is sampled with the densities of the mean thickness. What the
/// interface mirrors stays as it is.                                 [docs/coat-thickness.md]
class VariedCoat final : public BoundBsdf {
 public:
    /// @param mean  must outlive this
    /// @param deviation  of the thickness from its mean, in standard deviations
    VariedCoat(const BoundBsdf& mean, float deviation) : mean_(mean), deviation_(deviation) {}

    FloatLanes eval(Vec3f wi, Vec3f wo) const override;
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override;
    BsdfValue evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override;
    std::optional<BsdfSample> sample_on(const Patch& patch, Vec3f wi, float u_select,
                                        Vec2f u) const override;
    FloatLanes flake_weight(const Patch& patch, Vec3f wi, const FlakeSample& flake) const override;
    FloatLanes flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const override;

    float pdf(Vec3f wi, Vec3f wo) const override { return mean_.pdf(wi, wo); }
    FloatLanes pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const override {
        return mean_.pdf_lanes(wi, wo);
    }
    float specular_probability(Vec3f wi) const override { return mean_.specular_probability(wi); }
    bool samples_flakes() const override { return mean_.samples_flakes(); }
    float narrow_light_pdf(Vec3f wi) const override { return mean_.narrow_light_pdf(wi); }
    void sample_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                       std::vector<FlakeSamples>& list) const override {
        mean_.sample_flakes(patch, wi, random, list);
    }
    std::size_t patch_memory_bytes() const override { return mean_.patch_memory_bytes(); }
    BinderIndex binder_index() const override { return mean_.binder_index(); }
    const InterfaceLobe* interface_lobe() const override { return mean_.interface_lobe(); }
    UnitRange interface_lobe_range(const Patch* patch, Vec3f wi) const override {
        return mean_.interface_lobe_range(patch, wi);
    }
    FloatLanes coat_depth() const override { return mean_.coat_depth(); }
    /// What the interface returns of the ground's light on its way, through the coat once more, is left to
    /// the rest.
    MultiplyScattered multiply_scattered(Vec3f wi, Vec3f wo) const override;
    OpticalDepths optical_depths(float cosine) const override {
        return mean_.optical_depths(cosine);
    }
    /// Of the mean thickness.
    FloatLanes albedo(Vec3f wi) const override { return mean_.albedo(wi); }

 private:
    FloatLanes changed(const FloatLanes& f, Vec3f wi, Vec3f wo) const;
    std::optional<BsdfSample> changed(std::optional<BsdfSample> sample, Vec3f wi) const;

    const BoundBsdf& mean_;
    float deviation_;
};

}  // namespace nacre::bsdf
