#pragma once

#include <optional>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/microfacet.h"
#include "nacre/optics/material.h"
#include "nacre/spectra/spectrum.h"

// Transparent dielectrics. Radiance is counted as L / n^2, which refraction leaves as it is: a light
// has the luminance with which it appears from outside, wherever it stands.

namespace nacre::bsdf {

/// The face of a solid of glass, smooth or of GGX facets that refract or reflect once. It does not
/// disperse: Nacre follows eight wavelengths along one path.       [walter-2007, section 4]
class Glass final : public Bsdf {
 public:
    /// @param index      real, >= 1 at 550 nm, in a surrounding of 1
    /// @param absorption_per_mm  of the solid, >= 0
    /// @param roughness  alpha of GGX, or 0
    /// @throws DomainError if one is out of range
    Glass(const optics::Material& index, spectra::Spectrum absorption_per_mm, double roughness);

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

 private:
    float index_;
    spectra::Spectrum absorption_per_mm_;
    std::optional<MicrofacetDistribution> facets_;
};

/// A pane of glass as one surface: both faces smooth and parallel, with all reflections between
/// them, without interference. Light that goes through keeps its line; the shift aside is neglected.
///
///     R = F + (1 - F)^2 t^2 F / (1 - F^2 t^2),   T = (1 - F)^2 t / (1 - F^2 t^2)
///
/// t being what absorption leaves on one way.                    [born-wolf-1999, section 7.6]
class Pane final : public Bsdf {
 public:
    /// @param thickness_mm  > 0; matters for absorption only
    /// @throws DomainError as Glass
    Pane(const optics::Material& index, spectra::Spectrum absorption_per_mm, double thickness_mm);

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;
    bool has_null_transmission() const override { return true; }

 private:
    float index_;
    spectra::Spectrum absorption_per_mm_;
    double thickness_mm_;
};

}  // namespace nacre::bsdf
