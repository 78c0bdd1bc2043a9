#pragma once

#include <memory>
#include <optional>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/materials/facet_reflection.h"
#include "nacre/bsdf/microfacet.h"
#include "nacre/optics/material.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::bsdf {

/// A Lambertian body of reflectance rho in a binder of index n, under the binder's face, smooth or of
/// GGX facets. With E(w) all that the face reflects of light from w, and E its mean under diffuse
/// light,
///
///     f = specular + (1 - E(w_i)) (1 - E(w_o)) rho / (pi n^2 (1 - rho r)),   r = 1 - (1 - E) / n^2
///
/// r being what the face returns of the body's light. Reciprocal; a body with rho = 1 loses nothing:
/// what facets lose by sending light to other facets counts as entering.
///                                                              [saunderson-1942; walter-2007]
class Plastic final : public Bsdf {
 public:
    /// @param reflectance  rho, of the body in its binder, without the face
    /// @param index        real, >= 1 at 550 nm; does not disperse
    /// @param roughness    alpha of GGX, or 0
    /// @throws DomainError if one is out of range
    Plastic(spectra::Spectrum reflectance, const optics::Material& index, double roughness);

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

 private:
    spectra::Spectrum reflectance_;
    float index_;
    std::optional<MicrofacetDistribution> facets_;
    std::shared_ptr<const ReflectedFraction> outer_;  // null: smooth
    float outer_mean_;
};

}  // namespace nacre::bsdf
