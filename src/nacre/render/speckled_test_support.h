#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "nacre/render/test_support.h"

// Only for tests: a paint that differs from place to place, with a mean that is known.

namespace nacre::render::testing {

/// Glossy, times a number that depends on the place and on the half vector. It is sampled as its
/// mean is, so that both meet the same light. Keeps what it is asked about in the memory of the
/// patch, and counts where it finds another patch there.
class Speckled final : public bsdf::Bsdf {
 public:
    /// Of the place at rest and the half vector, both in rest space.
    using Factor = std::function<float(Vec3f position_mm, Vec3f half)>;

    explicit Speckled(Factor factor) : factor_(std::move(factor)) {}

    bsdf::Layout layout() const override { return bsdf::Layout::rest_space; }
    std::unique_ptr<const bsdf::BoundBsdf> bind(const bsdf::Wavelengths& nm) const override {
        return std::make_unique<Bound>(*this, mean_.bind(nm));
    }
    /// Patches that a memory held of which it told that it was not filled, or the other way round.
    static inline thread_local long stale = 0;

 private:
    class Bound final : public bsdf::BoundBsdf {
     public:
        Bound(const Speckled& owner, std::unique_ptr<const bsdf::BoundBsdf> mean)
            : owner_(owner), mean_(std::move(mean)) {}

        FloatLanes eval(Vec3f wi, Vec3f wo) const override { return mean_->eval(wi, wo); }
        float pdf(Vec3f wi, Vec3f wo) const override { return mean_->pdf(wi, wo); }
        FloatLanes albedo(Vec3f wi) const override { return mean_->albedo(wi); }
        std::optional<bsdf::BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const override {
            return mean_->sample(wi, u_lobe, u);
        }
        bsdf::BsdfValue evaluate_on(const bsdf::Patch& patch, Vec3f wi, Vec3f wo) const override {
            bsdf::BsdfValue value = mean_->evaluate(wi, wo);
            value.f *= factor(patch, wi, wo);
            return value;
        }
        std::optional<bsdf::BsdfSample> sample_on(const bsdf::Patch& patch, Vec3f wi, float u_lobe,
                                                  Vec2f u) const override {
            auto drawn = mean_->sample(wi, u_lobe, u);
            if (drawn && !drawn->mirror) drawn->weight *= factor(patch, wi, drawn->wo);
            return drawn;
        }
        std::size_t patch_memory_bytes() const override { return sizeof(Vec3f); }

     private:
        float factor(const bsdf::Patch& patch, Vec3f wi, Vec3f wo) const {
            const sparkle::RestPatch& rest = patch.rest;
            auto& kept = *reinterpret_cast<Vec3f*>(patch.memory->data());
            if (!patch.memory->filled) kept = rest.position_mm;
            patch.memory->filled = true;
            stale += kept != rest.position_mm;
            const Vec3f h = normalize(wi + wo);
            return owner_.factor_(
                rest.position_mm,
                h.x * rest.tangent + h.y * cross(rest.normal, rest.tangent) + h.z * rest.normal);
        }

        const Speckled& owner_;
        std::unique_ptr<const bsdf::BoundBsdf> mean_;
    };

    Factor factor_;
    Glossy mean_;
};

}  // namespace nacre::render::testing
