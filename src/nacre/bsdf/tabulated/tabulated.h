#pragma once

#include <memory>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/bsdf/tabulated/fourier_table.h"

namespace nacre::bsdf {

/// A paint rendered from a table of RGB values, raw or compressed, as Mir et al. 2022 do.
///                                                            [mir-2022; docs/tables.md]
/// Evaluation interpolates the table (BrdfCell), multiplies it by the analytic factor of
/// the interface, and turns RGB into a spectrum by spectra::linear_rec709_basis. The specular lobe
/// of a smooth interface is analytic, at the binder's mean index. Spectra that the basis makes
/// negative (colours outside the gamut) are cut off at zero.
///
/// With n = 256 and m = 128 the raw table agrees with the colour of SolvedPaint::brdf to
/// kTabulatedError of the peak of each incident direction, for flake roughness 0.07 to 0.5,
/// incidence up to 89 deg and a smooth interface of any index; compressed with r = 3, to
/// kTabulatedCompressedError under an index of 1.3 or more. Colours are exact under D65
/// and anything that has its spectrum; under another light, and after more than one reflection,
/// they are those of the basis, which knows nothing of the paint's spectrum.
///
/// Samples come from a mixture of specular lobe, flake lobe, a lobe twice as rough and a cosine
/// lobe, its weights fitted to the table.
class Tabulated final : public Bsdf {
 public:
    /// @throws DomainError if the table's grid or sizes are out of range or do not fit together
    explicit Tabulated(std::shared_ptr<const RawBrdfTable> table);
    explicit Tabulated(std::shared_ptr<const CompressedBrdfTable> table);
    explicit Tabulated(const BrdfTable& table);
    /// Stored as the paper stores its tables.
    explicit Tabulated(std::shared_ptr<const FourierBrdfTable> table);
    ~Tabulated() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

/// Takes over a table read from a file.
BrdfTable shared_brdf_table(std::variant<RawBrdfTable, CompressedBrdfTable> table);

inline constexpr double kTabulatedError = 1e-3;
inline constexpr double kTabulatedCompressedError = 4e-3;

}  // namespace nacre::bsdf
