#pragma once

#include <memory>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/rgl_table.h"

namespace nacre::bsdf {

/// A BRDF measured in the adaptive parameterization, isotropic or anisotropic, spectral or RGB.
///                                                      [dupuy-jakob-2018, section 4]
/// Evaluation is that of the format: the half vector goes back through the visible-normal map to a
/// point of the unit square, where the table is read bilinearly; linear between incident
/// directions; linear between wavelengths and constant beyond their ends. RGB becomes a spectrum by
/// spectra::linear_rec709_basis(). Negative values (noise) are cut off at zero.
///
/// Sampling follows the luminance table and then the visible normals; the density is exact, and
/// samples that leave below the horizon are lost, so that it integrates to less than 1. Where both
/// tables come from the same measurement, weights are near the albedo.
///
/// Measured data, and their interpolation, conserve neither energy nor reciprocity: wi plays the
/// part of the lamp in the measurement, whichever way the light goes. There is no mirror.
class MeasuredRgl final : public Bsdf {
 public:
    /// @throws DomainError as validate(table)
    explicit MeasuredRgl(const RglTable& table);
    ~MeasuredRgl() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

}  // namespace nacre::bsdf
