#pragma once

#include <functional>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/solver/medium.h"

// Tables of functions of one direction, which models of flakes share.

namespace nacre::bsdf {

/// Functions of one direction are tabulated over x = tan(theta/2), even in x.
inline constexpr int kDirectionIntervals = 128;

/// Angle outside the coat of a row of the direction tables, just short of the horizon at the last.
double direction_angle(int row);

/// [direction][wavelength] of a function of the direction refracted into the coat. value(mu, first, count)
/// gives that of `count` blocks of wavelengths from `first` on, in the direction of cosine mu; it is asked
/// once for all wavelengths at which the binder has one index, by several threads.
std::vector<float> tabulate_inside(
    const solver::PaintMedium& medium,
    const std::function<std::vector<DoubleLanes>(double mu, int first, int count)>& value);

/// [layer][direction][wavelength]: extinction in 1/um of the direction refracted into the coat.
std::vector<std::vector<float>> extinction_by_direction(const solver::PaintMedium& medium);

}  // namespace nacre::bsdf
