#pragma once

#include <string>
#include <vector>

#include "nacre/paint/recipe.h"

// What can be computed and is hardly a paint: a slip of the unit or of the decimal point, which no
// range refuses since studies need the room. Limits without a source are choices of this project.

namespace nacre::paint {

inline constexpr double kThinnestFilm_nm = 1;      ///< a few atoms: thinner ones are islands
inline constexpr double kThickestLayer_um = 1000;  ///< also of the clearcoat
inline constexpr double kLargestFlake_um = 2000;   ///< glitter is cut up to this
/// Diameter over thickness: the models take flakes for discs that are wide and flat.
inline constexpr double kMinAspectRatio = 3;
/// By volume, of flakes and pigments together in the dry layer. Beyond the critical concentration,
/// 0.3 to 0.6, the binder does not fill the gaps and the layer holds air.   [asbeck-1949]
inline constexpr double kMaxSolids = 0.4;
/// Usual median tilts by area: those of sprayed flakes are 2.4 to 12 deg (alpha 0.05 to 0.25).
inline constexpr double kFlattest_deg = 1, kSteepest_deg = 20;

/// One line for each number that is implausible, in the order of a recipe's keys: key, value, unit,
/// why, and which values are usual.
/// @param recipe  as validate() accepts it
std::vector<std::string> implausible_numbers(const Recipe& recipe);

}  // namespace nacre::paint
