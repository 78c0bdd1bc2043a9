#include "nacre/bsdf/materials/facet_reflection.h"

#include <fmt/format.h>

#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/paint/limits.h"

namespace nacre::bsdf {

ReflectedFraction::ReflectedFraction(const MicrofacetDistribution& facets,
                                     const std::function<float(float)>& reflectance) {
    // Over Hammersley's points, each a visible facet weighed by the part of its reflection that no
    // other facet hides.
    constexpr unsigned kPoints = 1024;
    for (int row = 0; row <= kIntervals; ++row) {
        const float z = std::max(static_cast<float>(row) / kIntervals, 1e-3f);
        const Vec3f wi{std::sqrt(1 - z * z), 0, z};
        double sum = 0;
        for (unsigned p = 0; p < kPoints; ++p) {
            const Vec2f u{(static_cast<float>(p) + 0.5f) / kPoints,
                          static_cast<float>(radical_inverse(p, 2)) + 0.5f / kPoints};
            const auto wo = FacetReflection::draw(facets, wi, u);
            if (!wo) continue;
            const FacetReflection r(facets, wi, *wo);
            sum += reflectance(r.cosine) * r.value * wo->z / r.pdf;
        }
        rows_[row] = static_cast<float>(sum / kPoints);
    }
}

std::optional<MicrofacetDistribution> facets_of(double roughness) {
    if (roughness == 0) return std::nullopt;
    if (!paint::limits::kMicrofacetAlpha.contains(roughness)) {
        throw DomainError(fmt::format("roughness = {} is neither 0 nor in {}", roughness,
                                      paint::limits::kMicrofacetAlpha.text()));
    }
    return MicrofacetDistribution(paint::FacetDistribution::ggx, roughness);
}

float refracting_index(const optics::Material& material) {
    constexpr double kWavelength_nm = 550;
    const optics::ComplexIndex index = material.index(kWavelength_nm);
    if (index.imag() != 0) {
        throw DomainError(fmt::format(
            "index = '{}' absorbs ({:.4g} + {:.4g}i at {} nm); glass and plastic take a real index "
            "and absorb by keys of their own",
            material.name(), index.real(), index.imag(), kWavelength_nm));
    }
    if (index.real() < 1) {
        throw DomainError(
            fmt::format("index = '{}' is {:.4g} at {} nm; glass and plastic take one of at least 1",
                        material.name(), index.real(), kWavelength_nm));
    }
    return static_cast<float>(index.real());
}

}  // namespace nacre::bsdf
