#pragma once

#include "nacre/bsdf/bsdf.h"
#include "nacre/layers/recipe.h"

// A smooth clearcoat over microfacets: light is refracted on its way to them and back, and what
// they send below the critical angle, or what the interface throws back at them, is lost: the
// interreflection of coat and facets is neglected.

namespace nacre::bsdf {

/// The index that surrounds the microfacets of a recipe: 1, or under a clearcoat that of the binder
/// at 550 nm (microfacet models take indices that do not depend on wavelength).
double index_around_facets(const layers::Recipe& recipe);

/// @throws DomainError if the recipe has no [microfacet] or its clearcoat is rough, or as
///         layers::validate
void validate_microfacet_recipe(const layers::Recipe& recipe);

/// The clearcoat of a microfacet recipe at eight wavelengths, or none at all.
class MicrofacetCoat {
 public:
    MicrofacetCoat(const layers::Recipe& recipe, const Wavelengths& wavelengths_nm);

    /// A direction outside, w.z > 0, and what it becomes inside.
    struct Ray {
        Vec3f outside, inside;
        float transmittance;  ///< Fresnel's, unpolarised
    };
    Ray refract(Vec3f outside) const;
    /// The direction outside of one inside; empty beyond the critical angle.
    std::optional<Vec3f> leave(Vec3f inside) const;

    /// BRDF outside over BRDF of the facets inside: t_i t_o / n^2 times the coat's absorption.
    FloatLanes transfer(const Ray& i, const Ray& o) const;
    /// Solid angle inside over solid angle outside.
    float solid_angle_ratio(const Ray& o) const {
        return present_ ? o.outside.z * inverse_ior2_ / o.inside.z : 1.0f;
    }
    /// Reflectance of the coat's mirror; 0 without a coat.
    float mirror_reflectance(const Ray& i) const { return 1 - i.transmittance; }
    /// The mirror's direction, when it is sampled with this probability.
    BsdfSample mirror_sample(const Ray& i, float probability) const {
        return {.wo = {-i.outside.x, -i.outside.y, i.outside.z},
                .weight = splat(mirror_reflectance(i) / probability),
                .pdf = probability,
                .mirror = true,
                .exit_mm = {}};
    }
    bool present() const { return present_; }

 private:
    bool present_, absorbs_;
    float ior_, inverse_ior_, inverse_ior2_;
    FloatLanes depth_;  // of absorption, along the normal
};

}  // namespace nacre::bsdf
