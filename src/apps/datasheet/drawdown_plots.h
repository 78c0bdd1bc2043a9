#pragma once

#include <array>
#include <vector>

#include "apps/datasheet/measurement_plots.h"
#include "nacre/fit/drawdown.h"

namespace nacre::datasheet {

inline constexpr std::array kDrawdownPlots = {"coefficients", "reflectance"};

/// A pigment's coefficients with their standard errors, and the reflectances of its drawdowns:
/// dots as measured, lines as the coefficients have them.
std::vector<NamedPlot> drawdown_plots(const fit::PigmentEstimate& estimate);

}  // namespace nacre::datasheet
