#pragma once

#include <vector>

#include "nacre/core/vec.h"

namespace nacre::bsdf {

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
