#pragma once

#include <memory>

#include "nacre/bsdf/bsdf.h"
#include "nacre/layers/solved_paint.h"

namespace nacre::bsdf {

/// The micro-flake model of Ergun et al. 2016 for rendering: interface + single scattering in
/// closed form + the solver's remainder from a table.           [ergun-2016; docs/microflake.md]
///
/// Agrees with SolvedPaint::brdf to kMicroflakeError of the peak of each incident direction, for a
/// binder of index 1.3 or more, flake roughness 0.02 to 0.5 and incidence up to 89 deg. Without a
/// coat (index near 1) lobes sharpen without bound towards grazing angles, where the table of the
/// remainder does not follow: up to 5 % of the peak beyond 60 deg at roughness 0.1. The solved
/// paint itself stays exact there. Wavelengths between those of the paint are interpolated
/// linearly, those beyond its ends take the end's value.
class Microflake final : public Bsdf {
 public:
    explicit Microflake(std::shared_ptr<const layers::SolvedPaint> paint);
    ~Microflake() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

inline constexpr double kMicroflakeError = 2e-3;
/// The same under a rough clearcoat, where the table holds single scattering too.
inline constexpr double kMicroflakeRoughError = 5e-3;

}  // namespace nacre::bsdf
