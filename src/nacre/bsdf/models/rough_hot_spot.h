#pragma once

#include <memory>

#include "nacre/bsdf/models/hot_spot.h"
#include "nacre/solver/solved_paint.h"

namespace nacre::bsdf {

// The hot spot under a rough clearcoat.
//
// There single scattering has no closed form but the solver's table of it, f_single, which is
// multiplied by the gain of the hot spot as it is under a smooth coat, with half vectors and rays
// spread as the facets spread them:
//
//     f_single' = f_single  sum_l f_l E[V]_l / E[exp(-kappa z)]_l / sum_l f_l,
//
// f_l the single scattering of layer l in closed form and the quotient of means over depth its gain
// (HotSpot::Pair::mean). The ground's own reflection, of light that nothing else has scattered, is taken
// to be f_ground = Tr_i Tr_o / n^2 R_g / pi exp(-tau_a), Tr the fraction that the rough interface lets
// through and tau_a that along the rays refracted by a smooth one; it gains in the same way. What both gain
// is missing from what is scattered again: of all that enters the coat, less what leaves after it was
// scattered once, the fraction that is left scales the albedo of multiple scattering, by C(i) C(o)
// as under a smooth coat (hot_spot_compensation.h). Albedos are those of the tables, so that no light is
// lost or gained where nothing absorbs.

/// The same paint with the hot spot in its tables of single and multiple scattering. Under a smooth
/// clearcoat it stays as it is: there the hot spot is worked out as it is asked for (hot_spot.h).
/// @throws Error as balance(), has_rough_interface()
solver::SolvedPaint with_rough_hot_spot(const solver::SolvedPaint& paint);
/// Under a smooth clearcoat `paint` itself.
/// @param tables  those of `paint`, for callers that need them as well
std::shared_ptr<const solver::SolvedPaint> with_rough_hot_spot(
    std::shared_ptr<const solver::SolvedPaint> paint, const HotSpotTables& tables);

}  // namespace nacre::bsdf
