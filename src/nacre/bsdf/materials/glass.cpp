#include "nacre/bsdf/materials/glass.h"

#include <cmath>
#include <utility>

#include "nacre/bsdf/materials/facet_reflection.h"
#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/optics/fresnel.h"

namespace nacre::bsdf {
namespace {

FloatLanes at(const spectra::Spectrum& spectrum, const Wavelengths& wavelengths_nm) {
    return make_lanes([&](int i) { return static_cast<float>(spectrum(wavelengths_nm[i])); });
}

void require_absorption(const spectra::Spectrum& absorption_per_mm) {
    if (!(absorption_per_mm.min() >= 0)) {
        throw DomainError("absorption_per_mm of glass must not be negative");
    }
}

/// One face of a solid, seen from one of its sides.
class GlassSide {
 public:
    /// @param index  of the far side over that of the side of wi
    GlassSide(float index, const std::optional<MicrofacetDistribution>& facets)
        : index_(index), facets_(facets) {
        // Facets that do not refract are not there; the half vector of what goes straight on is 0 / 0.
        constexpr float kMinRefraction = 1e-4f;
        if (std::abs(index - 1) < kMinRefraction) facets_.reset();
    }

    /// Both for directions on either side.
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const {
        if (!facets_ || wi.z <= 0 || wo.z == 0) return {};
        if (wo.z > 0) {
            const FacetReflection r(*facets_, wi, wo);
            const float reflected = optics::fresnel_dielectric(index_, r.cosine);
            return {splat(r.value * reflected), r.pdf * reflected};
        }
        // The facet that refracts one into the other: along wi + index wo, turned upwards.
        Vec3f h = wi + index_ * wo;
        const float size = length(h);
        if (!(size > 0)) return {};
        h = h * ((h.z < 0 ? -1.0f : 1.0f) / size);
        const float i = dot(wi, h), o = dot(wo, h);
        if (i <= 0 || o >= 0 || h.z <= 0) return {};
        const float density = facets_->density(h);
        const float shown_i = 1 / (1 + facets_->lambda(wi));
        const float shown_o = 1 / (1 + facets_->lambda({wo.x, wo.y, -wo.z}));
        const float passed = 1 - optics::fresnel_dielectric(index_, i);
        const float bend = i + index_ * o;
        // Solid angle of facets over that of refracted directions.    [walter-2007, eq. 17]
        const float jacobian = index_ * index_ * -o / (bend * bend);
        const float pdf = density * shown_i * i / wi.z * jacobian * passed;
        return {splat(pdf * shown_o / -wo.z), pdf};
    }

    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const {
        if (wi.z <= 0) return std::nullopt;
        const Vec3f h = facets_ ? facets_->sample_visible(wi, u) : Vec3f{0, 0, 1};
        const float cosine = dot(wi, h);
        if (cosine <= 0) return std::nullopt;
        const float reflected = optics::fresnel_dielectric(index_, cosine);
        const bool through = u_select >= reflected;
        Vec3f wo = 2 * cosine * h - wi;
        if (through) {
            const float inside = optics::refracted_cos(1.0f, index_, cosine);
            wo = normalize((1 / index_) * (cosine * h - wi) - inside * h);
        }
        if (through ? wo.z >= 0 : wo.z <= 0) return std::nullopt;
        if (!facets_) {
            return BsdfSample{.wo = wo,
                              .weight = splat(1.0f),
                              .pdf = through ? 1 - reflected : reflected,
                              .kind = SampleKind::specular,
                              .exit_mm = {}};
        }
        const BsdfValue value = evaluate(wi, wo);
        if (!(value.pdf > 0)) return std::nullopt;
        return BsdfSample{.wo = wo,
                          .weight = (std::abs(wo.z) / value.pdf) * value.f,
                          .pdf = value.pdf,
                          .exit_mm = {}};
    }

 private:
    float index_;
    std::optional<MicrofacetDistribution> facets_;
};

/// @tparam kFromBehind  seen from within the glass
template <bool kFromBehind>
class BoundGlass : public BoundBsdf {
 public:
    BoundGlass(float index, const std::optional<MicrofacetDistribution>& facets,
               FloatLanes absorption_per_mm)
        : side_(kFromBehind ? 1 / index : index, facets), absorption_per_mm_(absorption_per_mm) {}

    FloatLanes eval(Vec3f wi, Vec3f wo) const override { return side_.evaluate(wi, wo).f; }
    float pdf(Vec3f wi, Vec3f wo) const override { return side_.evaluate(wi, wo).pdf; }
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override { return side_.evaluate(wi, wo); }
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        return side_.sample(wi, u_select, u);
    }
    /// What is not reflected goes through.
    FloatLanes albedo(Vec3f wi) const override { return splat(wi.z > 0 ? 1.0f : 0.0f); }
    bool transmits() const override { return true; }
    FloatLanes transmittance(float distance_mm) const override {
        if constexpr (!kFromBehind) return splat(1.0f);
        return exp_lanes(-distance_mm * absorption_per_mm_);
    }

 private:
    GlassSide side_;
    FloatLanes absorption_per_mm_;
};

class BoundSolidGlass final : public BoundGlass<false> {
 public:
    BoundSolidGlass(float index, const std::optional<MicrofacetDistribution>& facets,
                    FloatLanes absorption_per_mm)
        : BoundGlass<false>(index, facets, absorption_per_mm),
          inside_(index, facets, absorption_per_mm) {}
    const BoundBsdf& from_behind() const override { return inside_; }

 private:
    BoundGlass<true> inside_;
};

class BoundPane final : public BoundBsdf {
 public:
    BoundPane(float index, FloatLanes depth) : index_(index), depth_(depth) {}

    FloatLanes eval(Vec3f, Vec3f) const override { return FloatLanes{}; }
    float pdf(Vec3f, Vec3f) const override { return 0; }
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f) const override {
        if (wi.z <= 0) return std::nullopt;
        const Fractions fractions = fractions_at(wi.z);
        const float reflected = lane_mean(fractions.reflected),
                    through = lane_mean(fractions.through);
        const float p_reflected = reflected / (reflected + through);
        if (u_select < p_reflected) {
            return BsdfSample{.wo = {-wi.x, -wi.y, wi.z},
                              .weight = fractions.reflected * (1 / p_reflected),
                              .pdf = p_reflected,
                              .kind = SampleKind::specular,
                              .exit_mm = {}};
        }
        return BsdfSample{.wo = {-wi.x, -wi.y, -wi.z},
                          .weight = fractions.through * (1 / (1 - p_reflected)),
                          .pdf = 1 - p_reflected,
                          .kind = SampleKind::null,
                          .exit_mm = {}};
    }
    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const Fractions fractions = fractions_at(wi.z);
        return fractions.reflected + fractions.through;
    }
    bool transmits() const override { return true; }
    FloatLanes null_transmission(Vec3f wi) const override {
        return wi.z > 0 ? fractions_at(wi.z).through : FloatLanes{};
    }

 private:
    struct Fractions {
        FloatLanes reflected, through;
    };
    Fractions fractions_at(float cosine) const {
        const float inside = optics::refracted_cos(1.0f, index_, cosine);
        const FloatLanes t = inside > 0 ? exp_lanes(depth_ * (-1 / inside)) : FloatLanes{};
        // Each polarisation is reflected to and fro by itself, then both are averaged.
        Fractions fractions{};
        for (const float r : {(cosine - index_ * inside) / (cosine + index_ * inside),
                              (index_ * cosine - inside) / (index_ * cosine + inside)}) {
            const float f = r * r;
            if (f >= 1) {
                fractions.reflected += 0.5f;
                continue;
            }
            const FloatLanes through = ((1 - f) * (1 - f)) * t / (splat(1.0f) - (f * f) * t * t);
            fractions.through += 0.5f * through;
            fractions.reflected += 0.5f * (splat(f) + f * t * through);
        }
        return fractions;
    }

    float index_;
    FloatLanes depth_;  // of absorption, along the normal
};

}  // namespace

Glass::Glass(const optics::Material& index, spectra::Spectrum absorption_per_mm, double roughness)
    : index_(refracting_index(index)),
      absorption_per_mm_(std::move(absorption_per_mm)),
      facets_(facets_of(roughness)) {
    require_absorption(absorption_per_mm_);
}

std::unique_ptr<const BoundBsdf> Glass::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundSolidGlass>(index_, facets_,
                                             at(absorption_per_mm_, wavelengths_nm));
}

Pane::Pane(const optics::Material& index, spectra::Spectrum absorption_per_mm, double thickness_mm)
    : index_(refracting_index(index)),
      absorption_per_mm_(std::move(absorption_per_mm)),
      thickness_mm_(thickness_mm) {
    require_absorption(absorption_per_mm_);
    if (!(thickness_mm > 0)) throw DomainError("thickness_mm of a pane must be positive");
}

std::unique_ptr<const BoundBsdf> Pane::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundPane>(
        index_, static_cast<float>(thickness_mm_) * at(absorption_per_mm_, wavelengths_nm));
}

}  // namespace nacre::bsdf
