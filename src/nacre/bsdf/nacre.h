#pragma once

#include <cstdint>
#include <memory>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/single_flakes.h"
#include "nacre/layers/solved_paint.h"

namespace nacre::bsdf {

struct NacreSettings {
    /// Large flakes: light that has come in between the flakes finds the same gaps on its way out
    /// (nacre_hot_spot.h). Then the mean is no longer that of the solver.
    bool hot_spot = false;
};

/// The micro-flake model with single flakes: colour travel, sparkle and multiple scattering at
/// once.
///
/// Light that met exactly one flake is a sum over those of the patch that is looked at, each with
/// its own place, size, slope, depth and films (sparkle/flake_field.h); the interface and what is
/// scattered again are those of Microflake. Without a patch it is Microflake: that is the mean over
/// all patches, exactly. A patch is read from Patch::rest, in millimetres; which flakes there are
/// depends on the seed alone.                                          [docs/nacre-model.md]
///
/// Under a binder whose index depends on the wavelength, which flakes answer is decided with the
/// mean index; the mean of each wavelength stays its own.
class Nacre final : public Bsdf, public SingleFlakes {
 public:
    /// @throws DomainError if the paint's clearcoat is rough, or its flakes are such as no
    ///         FlakeField takes
    Nacre(std::shared_ptr<const layers::SolvedPaint> paint, std::uint64_t seed,
          const NacreSettings& settings = {});
    ~Nacre() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;
    Layout layout() const override { return Layout::rest_space; }
    double exact_patch_mm() const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

}  // namespace nacre::bsdf
