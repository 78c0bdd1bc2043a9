#pragma once

#include <functional>
#include <vector>

namespace nacre::measure {

/// What an instrument is held against: the BRDF in 1/sr at each of some wavelengths, without the
/// mirror of a smooth interface. Polar angles in rad in [0, pi/2); phi = phi_o - phi_i, pi being
/// the mirror side (docs/conventions.md). May be called from several threads at once.
using Brdf = std::function<std::vector<double>(double theta_i, double theta_o, double phi)>;

}  // namespace nacre::measure
