#pragma once

#include <functional>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"
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

/// One direction, and what evaluation and sampling both need of it.
struct Ray {
    Vec3f outside, inside;  ///< inside: refracted with the mean index
    float sine, x;          ///< outside: sin theta, tan(theta/2)
    int row;                ///< of the direction tables
    float fraction;

    /// A function of direction between its rows.
    template <class T>
    T look_up(const std::vector<T>& table) const {
        return table[row] + fraction * (table[row + 1] - table[row]);
    }
};

/// @param w  outside, in the upper hemisphere
Ray make_ray(Vec3f w, float inverse_mean_ior);
/// @param theta, phi  of that direction
Ray make_ray(double theta, double phi, float inverse_mean_ior);

}  // namespace nacre::bsdf
