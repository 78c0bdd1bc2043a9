#pragma once

#include "nacre/core/vec.h"
#include "nacre/layers/recipe.h"

// Facets of a rough surface, as the microfacet models share them: how their normals are
// distributed, how they hide each other, and how to draw those that can be seen.

namespace nacre::bsdf {

/// Isotropic microfacets of roughness alpha. Directions are in the local frame, z the mean normal.
class MicrofacetDistribution {
 public:
    /// @param alpha  in layers::limits::kMicrofacetAlpha: for Beckmann sqrt(2) times the standard
    ///               deviation of a slope component
    MicrofacetDistribution(layers::FacetDistribution law, double alpha);

    /// D(h), density of normals per solid angle and per area of the mean surface: its integral
    /// times the cosine is 1.       [walter-2007, eq. 25 (Beckmann) and 33 (GGX)]
    /// @param h  unit, h.z > 0
    float density(Vec3f h) const;

    /// Smith's Lambda(w): hidden area over visible area, in its exact form for either law. The
    /// share seen of the facets that face w is 1 / (1 + Lambda).                [heitz-2014,
    /// section 5]
    /// @param w  unit, w.z > 0
    float lambda(Vec3f w) const;

    /// Share of facets visible from both sides, heights being correlated.  [heitz-2014]
    static float masking_shadowing(float lambda_i, float lambda_o) {
        return 1 / (1 + lambda_i + lambda_o);
    }

    /// Density of the normals visible from wi, per solid angle of h.      [heitz-deon-2014]
    float visible_density(Vec3f wi, float lambda_i, Vec3f h) const {
        const float facing = dot(wi, h);
        return facing > 0 ? density(h) * facing / (wi.z * (1 + lambda_i)) : 0;
    }

    /// Draws a normal with visible_density(). u in [0, 1)^2.
    /// GGX: the disk of the stretched hemisphere, re-projected [heitz-2018]. Beckmann: slopes of
    /// the stretched surface, that towards wi by inverting its distribution [heitz-deon-2014] with
    /// Newton's method in the error function of the slope, where it is nearly straight; the other
    /// by the Gaussian.
    Vec3f sample_visible(Vec3f wi, Vec2f u) const;

    float alpha() const { return alpha_; }
    layers::FacetDistribution law() const { return law_; }

 private:
    layers::FacetDistribution law_;
    float alpha_, inverse_alpha2_;
};

/// The slope x of a visible facet of a surface with the slope density exp(-x^2) / sqrt(pi), seen
/// under the angle whose cotangent is given: density (cot - x) exp(-x^2) on x < cot, normalised;
/// x > 0 turns facets away. Of the result, the error in probability is below kVisibleSlopeError.
/// @param u  in (0, 1)
float sample_visible_beckmann_slope(float cotangent, float u);

inline constexpr double kVisibleSlopeError = 2e-6;

}  // namespace nacre::bsdf
