#pragma once

#include <string>

#include "nacre/core/progress.h"

namespace nacre::datasheet {

/// The materials that ship, as CSV: name, wavelengths in nm between which they are known (empty for
/// a constant), n and k at 550 nm, chip, source. The chip is the colour of a polished, thick piece in
/// air at normal incidence, under D65 for the observer of 10 deg, as it stands beside the perfect
/// diffuser, with the last index beyond data that end within 400 to 700 nm.
std::string materials_csv();

/// The pigments that ship, as CSV: the name by which a recipe says `from`, what it is called,
/// whether by particles or by coefficients, wavelengths in nm between which it is known (empty:
/// all), the colours of 40 um with 3 % by volume in a binder of index 1.5 over black (reflectance
/// 0.02) and over white (0.9), read at 45:0 under D65 by the observer of 10 deg, and the source.
/// Beyond the data of a material its last index is taken.
/// @throws Error, Stopped as solver::solve
std::string pigments_csv(const Progress& progress = {});

}  // namespace nacre::datasheet
