#include "nacre/bsdf/materials/plastic.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "nacre/bsdf/materials/facet_reflection.h"
#include "nacre/bsdf/warp.h"
#include "nacre/core/error.h"
#include "nacre/optics/fresnel.h"

namespace nacre::bsdf {
namespace {

class BoundPlastic final : public BoundBsdf {
 public:
    BoundPlastic(FloatLanes reflectance, float index,
                 const std::optional<MicrofacetDistribution>& facets,
                 std::shared_ptr<const ReflectedFraction> outer, float outer_mean)
        : index_(index), facets_(facets), outer_(std::move(outer)) {
        const float leaves = (1 - outer_mean) / (index * index);
        inner_ = reflectance / (splat(1.0f) - reflectance * (1 - leaves));
        diffuse_ = inner_ * (1 / (std::numbers::pi_v<float> * index * index));
        // Of light that has entered, what leaves again.
        leaving_ = inner_ * leaves;
    }

    FloatLanes eval(Vec3f wi, Vec3f wo) const override { return evaluate(wi, wo).f; }
    float pdf(Vec3f wi, Vec3f wo) const override { return evaluate(wi, wo).pdf; }
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const float reflected = face(wi.z), p_face = face_probability(reflected);
        BsdfValue value{(1 - reflected) * (1 - face(wo.z)) * diffuse_,
                        (1 - p_face) * std::numbers::inv_pi_v<float> * wo.z};
        if (facets_) {
            const FacetReflection r(*facets_, wi, wo);
            value.f += splat(r.value * optics::fresnel_dielectric(index_, r.cosine));
            value.pdf += p_face * r.pdf;
        }
        return value;
    }
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const float reflected = face(wi.z), p_face = face_probability(reflected);
        Vec3f wo;
        if (u_select >= p_face) {
            wo = cosine_hemisphere(u);
        } else if (!facets_) {
            return BsdfSample{.wo = {-wi.x, -wi.y, wi.z},
                              .weight = splat(reflected / p_face),
                              .pdf = p_face,
                              .kind = SampleKind::specular,
                              .exit_mm = {}};
        } else if (const auto drawn = FacetReflection::draw(*facets_, wi, u)) {
            wo = *drawn;
        } else {
            return std::nullopt;
        }
        const BsdfValue value = evaluate(wi, wo);
        if (!(wo.z > 0) || !(value.pdf > 0)) return std::nullopt;
        return BsdfSample{
            .wo = wo, .weight = (wo.z / value.pdf) * value.f, .pdf = value.pdf, .exit_mm = {}};
    }
    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const float reflected = face(wi.z);
        return splat(reflected) + (1 - reflected) * leaving_;
    }

 private:
    /// What the face reflects altogether.
    float face(float cosine) const {
        return outer_ ? outer_->at(cosine) : optics::fresnel_dielectric(index_, cosine);
    }
    /// With which the face is sampled: in proportion to what it and the body reflect.
    float face_probability(float reflected) const {
        const float body = (1 - reflected) * lane_mean(leaving_);
        constexpr float kMin = 0.05f;  // of either, so that their weights stay bounded
        return reflected > 0 ? std::clamp(reflected / (reflected + body), kMin, 1 - kMin) : 0.0f;
    }

    float index_;
    std::optional<MicrofacetDistribution> facets_;
    std::shared_ptr<const ReflectedFraction> outer_;
    FloatLanes inner_, diffuse_, leaving_;
};

}  // namespace

Plastic::Plastic(spectra::Spectrum reflectance, const optics::Material& index, double roughness)
    : reflectance_(std::move(reflectance)),
      index_(refracting_index(index)),
      facets_(facets_of(roughness)),
      outer_mean_(0) {
    const auto fresnel = [this](float c) { return optics::fresnel_dielectric(index_, c); };
    if (facets_) outer_ = std::make_shared<const ReflectedFraction>(*facets_, fresnel);
    outer_mean_ = diffuse_mean([&](float c) { return outer_ ? outer_->at(c) : fresnel(c); });
    require_in_range(reflectance_.min(), 0, 1, "smallest reflectance of a plastic");
    require_in_range(reflectance_.max(), 0, 1, "largest reflectance of a plastic");
}

std::unique_ptr<const BoundBsdf> Plastic::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundPlastic>(
        make_lanes([&](int i) { return static_cast<float>(reflectance_(wavelengths_nm[i])); }),
        index_, facets_, outer_, outer_mean_);
}

}  // namespace nacre::bsdf
