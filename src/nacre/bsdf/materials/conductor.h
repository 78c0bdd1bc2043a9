#pragma once

#include <memory>
#include <optional>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/materials/facet_reflection.h"
#include "nacre/bsdf/microfacet.h"
#include "nacre/optics/material.h"

namespace nacre::bsdf {

/// A bare metal: Fresnel's reflectance of its complex index at each wavelength, off a smooth surface
/// or off GGX facets. What facets send to other facets leaves diffusely, by what they leave out of a
/// perfect mirror's light: with E(w) that one's reflected fraction, E and F the means of it and of
/// Fresnel's reflectance under diffuse light,
///
///     f = D G F / (4 cos_i cos_o)
///         + (1 - E(w_i)) (1 - E(w_o)) / (pi (1 - E)) F^2 E / (1 - F (1 - E))
///
///                                                   [walter-2007, eq. 20; kulla-conty-2017]
class Conductor final : public Bsdf {
 public:
    /// @param metal      its data must cover the wavelengths that are rendered
    /// @param roughness  alpha of GGX, or 0
    /// @throws DomainError as facets_of()
    Conductor(optics::Material metal, double roughness);

    /// @throws DomainError naming the metal if its data do not reach one of the wavelengths
    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

 private:
    optics::Material metal_;
    std::optional<MicrofacetDistribution> facets_;
    std::shared_ptr<const ReflectedFraction> mirror_;  // E(w), of facets
};

}  // namespace nacre::bsdf
