#pragma once

#include <string>

#include "nacre/panel/colour_atlas.h"

namespace nacre::panel {

/// The atlas as a grid of chips (measure::srgb_chip_at_full_light()), with what they stand for:
/// SVG 1.1 without scripts, as report::plot_svg().
std::string atlas_svg(const Atlas& atlas);

/// One line a chip: the value under the heading atlas.column, theta_i, aspecular_deg, L, a, b, C,
/// h, chip.
std::string atlas_csv(const Atlas& atlas);

}  // namespace nacre::panel
