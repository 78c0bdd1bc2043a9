#pragma once

#include <string>

#include "nacre/measure/measurement.h"

// Numbers and conditions in words.

namespace nacre::panel {

/// "45°", "−15°", with the minus sign of typography.
std::string degrees_text(double angle_deg);

/// A number with so many decimals and the minus sign of typography.
std::string decimal_text(double value, int decimals);

/// "illuminant D65, 10° observer, point apertures".
std::string conditions_text(const measure::Conditions& conditions);

}  // namespace nacre::panel
