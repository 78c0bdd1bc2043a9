#include "nacre/bsdf/materials/conductor.h"

#include <numbers>
#include <utility>

#include "nacre/bsdf/materials/facet_reflection.h"
#include "nacre/bsdf/warp.h"
#include "nacre/optics/fresnel.h"

namespace nacre::bsdf {
namespace {

struct MetalIndex {
    FloatLanes n, k;

    MetalIndex(const optics::Material& metal, const Wavelengths& wavelengths_nm) {
        n = make_lanes(
            [&](int i) { return static_cast<float>(metal.index(wavelengths_nm[i]).real()); });
        k = make_lanes(
            [&](int i) { return static_cast<float>(metal.index(wavelengths_nm[i]).imag()); });
    }
    FloatLanes reflectance(float cosine) const {
        return optics::conductor_reflectance(n, k, cosine);
    }
};

class BoundSmoothConductor final : public BoundBsdf {
 public:
    explicit BoundSmoothConductor(const MetalIndex& index) : index_(index) {}

    FloatLanes eval(Vec3f, Vec3f) const override { return FloatLanes{}; }
    float pdf(Vec3f, Vec3f) const override { return 0; }
    std::optional<BsdfSample> sample(Vec3f wi, float, Vec2f) const override {
        if (wi.z <= 0) return std::nullopt;
        return BsdfSample{.wo = {-wi.x, -wi.y, wi.z},
                          .weight = index_.reflectance(wi.z),
                          .pdf = 1,
                          .kind = SampleKind::specular,
                          .exit_mm = {}};
    }
    FloatLanes albedo(Vec3f wi) const override {
        return wi.z > 0 ? index_.reflectance(wi.z) : FloatLanes{};
    }

 private:
    MetalIndex index_;
};

class BoundRoughConductor final : public BoundBsdf {
 public:
    BoundRoughConductor(const MetalIndex& index, const MicrofacetDistribution& facets,
                        std::shared_ptr<const ReflectedFraction> mirror)
        : index_(index), facets_(facets), mirror_(std::move(mirror)) {
        const float e = diffuse_mean([this](float c) { return mirror_->at(c); });
        const FloatLanes f = diffuse_mean([this](float c) { return index_.reflectance(c); });
        const FloatLanes again = f * f * e / (splat(1.0f) - f * (1 - e));
        diffuse_ = again * (std::numbers::inv_pi_v<float> / (1 - e));
        albedo_.tabulate([&](Vec3f wi, std::array<float, 4> u) {
            const auto s = sample(wi, u[2], {u[0], u[1]});
            return s ? s->weight : FloatLanes{};
        });
    }

    FloatLanes eval(Vec3f wi, Vec3f wo) const override { return evaluate(wi, wo).f; }
    float pdf(Vec3f wi, Vec3f wo) const override { return evaluate(wi, wo).pdf; }
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const FacetReflection r(facets_, wi, wo);
        const float once = mirror_->at(wi.z);
        return {r.value * index_.reflectance(r.cosine) +
                    ((1 - once) * (1 - mirror_->at(wo.z))) * diffuse_,
                once * r.pdf + (1 - once) * std::numbers::inv_pi_v<float> * wo.z};
    }
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const auto wo = u_select < mirror_->at(wi.z) ? FacetReflection::draw(facets_, wi, u)
                                                     : std::optional(cosine_hemisphere(u));
        if (!wo || !(wo->z > 0)) return std::nullopt;
        const BsdfValue value = evaluate(wi, *wo);
        if (!(value.pdf > 0)) return std::nullopt;
        return BsdfSample{
            .wo = *wo, .weight = (wo->z / value.pdf) * value.f, .pdf = value.pdf, .exit_mm = {}};
    }
    FloatLanes albedo(Vec3f wi) const override {
        return wi.z > 0 ? albedo_.at(wi.z) : FloatLanes{};
    }

 private:
    MetalIndex index_;
    MicrofacetDistribution facets_;
    std::shared_ptr<const ReflectedFraction> mirror_;
    FloatLanes diffuse_;
    MicrofacetAlbedo albedo_;
};

}  // namespace

Conductor::Conductor(optics::Material metal, double roughness)
    : metal_(std::move(metal)), facets_(facets_of(roughness)) {
    if (!facets_) return;
    mirror_ = std::make_shared<const ReflectedFraction>(*facets_, [](float) { return 1.0f; });
}

std::unique_ptr<const BoundBsdf> Conductor::bind(const Wavelengths& wavelengths_nm) const {
    const MetalIndex index(metal_, wavelengths_nm);
    if (facets_) return std::make_unique<BoundRoughConductor>(index, *facets_, mirror_);
    return std::make_unique<BoundSmoothConductor>(index);
}

}  // namespace nacre::bsdf
