#pragma once

#include <array>
#include <vector>

#include "nacre/bsdf/smooth_table.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/solver/solved_paint.h"

// The table of all light of a paint that has no closed form (SmoothTable): multiple scattering, and
// single scattering too under a rough clearcoat.

namespace nacre::bsdf {

/// What the table sums, in the order of its basis.
std::vector<const solver::MultipleScattering*> tabulated_tensors(const solver::SolvedPaint& paint);

/// @throws Error as has_rough_interface()
SmoothTable smooth_table(const solver::SolvedPaint& paint);

/// The table of this paint at eight wavelengths.
/// @param single_only  only what was scattered once, under a rough clearcoat
BoundSmoothTable bind_table(const SmoothTable& table, const solver::SolvedPaint& paint,
                            const std::array<WavelengthPosition, kLanes>& where,
                            bool single_only = false);

}  // namespace nacre::bsdf
