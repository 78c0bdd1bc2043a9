#pragma once

#include <memory>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/merl_table.h"

namespace nacre::bsdf {

/// An isotropic BRDF measured over half and difference angles, in RGB.
///                                                         [matusik-2003; rusinkiewicz-1998]
/// Evaluation interpolates linearly between the middles of the eight nearest cells: in
/// sqrt(theta_half), theta_difference and phi_difference, the last of which is periodic. Cells that
/// were not measured do not take part; where all eight were not, the surface is black. The
/// database's own reading code takes the cell in which the angles lie: in the middle of a cell both
/// give the same. RGB becomes a spectrum by spectra::linear_rec709_basis().
///
/// Reciprocal by construction. Energy is as measured: the database has materials that reflect more
/// than they receive near grazing.
///
/// Samples come from a cosine lobe and lobes of four roughnesses, their odds fitted to the table
/// for each incident angle; the density is exact, weights may vary where no mixture of those fits.
class MeasuredMerl final : public Bsdf {
 public:
    /// @throws DomainError as validate(table)
    explicit MeasuredMerl(const MerlTable& table);
    ~MeasuredMerl() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

}  // namespace nacre::bsdf
