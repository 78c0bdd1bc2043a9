#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "nacre/bsdf/microfacet.h"

// Single reflection off microfacets, without what each facet reflects.

namespace nacre::bsdf {

/// Two directions on the same side of a rough surface, and the facet that turns one into the other.
struct FacetReflection {
    float cosine = 0;  ///< of incidence on the facet
    float value = 0;   ///< D G / (4 cos_i cos_o), in 1/sr                     [walter-2007, eq. 20]
    float pdf = 0;     ///< of draw(), per solid angle of wo

    /// @param wi, wo  unit, z > 0
    FacetReflection(const MicrofacetDistribution& facets, Vec3f wi, Vec3f wo) {
        const Vec3f sum = wi + wo;
        const float twice = length(sum);
        cosine = std::min(1.0f, 0.5f * twice);
        const float density = facets.density(sum * (1 / twice));
        const float lambda_i = facets.lambda(wi);
        const float seen = MicrofacetDistribution::masking_shadowing(lambda_i, facets.lambda(wo));
        value = 0.25f * density * seen / (wi.z * wo.z);
        pdf = 0.25f * density / (wi.z * (1 + lambda_i));
    }

    /// A direction into which a facet reflects that is visible from wi; empty below the horizon.
    static std::optional<Vec3f> draw(const MicrofacetDistribution& facets, Vec3f wi, Vec2f u) {
        const Vec3f h = facets.sample_visible(wi, u);
        const Vec3f wo = 2 * dot(wi, h) * h - wi;
        if (wo.z <= 0) return std::nullopt;
        return wo;
    }
};

/// The fraction of light from one direction that facets reflect which reflect once, by the cosine of
/// incidence: linear between kIntervals + 1 cosines.
class ReflectedFraction {
 public:
    /// @param reflectance  of a facet, by the cosine of incidence on it
    ReflectedFraction(const MicrofacetDistribution& facets,
                      const std::function<float(float)>& reflectance);

    float at(float cosine) const {
        const float x = std::min(cosine, 1.0f) * kIntervals;
        const int row = std::min(static_cast<int>(x), kIntervals - 1);
        return rows_[row] + (x - static_cast<float>(row)) * (rows_[row + 1] - rows_[row]);
    }

    static constexpr int kIntervals = 64;

 private:
    std::array<float, kIntervals + 1> rows_{};
};

/// 2 int E(mu) mu dmu over [0, 1]: the mean of a function of the cosine under diffuse light.
template <class F>
auto diffuse_mean(F&& value) {
    // Midpoints in mu^2, where a rise at grazing counts little.
    constexpr int kMidpoints = 1024;
    auto sum = value(std::sqrt(0.5f / kMidpoints));
    for (int i = 1; i < kMidpoints; ++i) sum += value(std::sqrt((i + 0.5f) / kMidpoints));
    return sum * (1.0f / kMidpoints);
}

/// The facets of a scene's material, or none: roughness 0 is a smooth surface.
/// @throws DomainError if the roughness is neither 0 nor in paint::limits::kMicrofacetAlpha
std::optional<MicrofacetDistribution> facets_of(double roughness);

/// The index by which a scene's materials refract, which do not disperse: that at 550 nm.
/// @return at least 1
/// @throws DomainError if the material absorbs there, its index is below 1 or its data do not reach there
float refracting_index(const optics::Material& material);

}  // namespace nacre::bsdf
