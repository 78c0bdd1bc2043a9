#pragma once

#include "nacre/bsdf/bsdf.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::bsdf {

/// A perfectly diffuse reflector: the BRDF is reflectance / pi in every direction.
class Lambertian final : public Bsdf {
 public:
    /// @throws DomainError if the reflectance leaves [0, 1]
    explicit Lambertian(spectra::Spectrum reflectance);

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

 private:
    spectra::Spectrum reflectance_;
};

}  // namespace nacre::bsdf
