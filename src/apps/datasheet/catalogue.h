#pragma once

#include <string>

namespace nacre::datasheet {

/// The materials that ship, as CSV: name, wavelengths in nm between which they are known (empty for
/// a constant), n and k at 550 nm, chip, source. The chip is the colour of a polished, thick piece in
/// air at normal incidence, under D65 for the observer of 10 deg, as it stands beside the perfect
/// diffuser; it is empty where the data do not cover 400 to 700 nm.
std::string materials_csv();

}  // namespace nacre::datasheet
