#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "nacre/core/vec.h"

// Through which planes a surface sees the flakes that lie on it.

namespace nacre::sparkle {

/// One of the six sides of the rest space's axes, and the share of the flakes that it gives.
struct Projection {
    int side;     ///< 2 axis + (1 if the surface faces the negative side)
    float share;  ///< of the flakes of the surface; the shares of a normal add up to 1
};

struct Projections {
    std::array<Projection, 3> list;
    int count = 0;
};

/// Squares of the components of a normal that differ by less share the flakes.
inline constexpr float kProjectionBlend = 0.1f;
/// The largest of (share / |component of the normal|): flakes per area of the plane over flakes per
/// area of the surface. It is reached where one side alone serves and two others are about to.
inline constexpr float kMostStretch = 1.5811388f;  // 1 / sqrt((1 + 2 kProjectionBlend) / 3)

/// The sides that the unit vector n faces. Where it turns from one to the next the shares change
/// continuously, so that flakes come and go one by one and no border shows.
inline Projections projections_of(Vec3f n) {
    const std::array<float, 3> component = {n.x, n.y, n.z};
    std::array<float, 3> weight;
    float most = 0, sum = 0;
    for (float c : component) most = std::max(most, c * c);
    for (int axis = 0; axis < 3; ++axis) {
        weight[axis] = std::max(0.0f, component[axis] * component[axis] - most + kProjectionBlend);
        sum += weight[axis];
    }
    Projections out;
    for (int axis = 0; axis < 3; ++axis) {
        if (weight[axis] > 0) {
            out.list[out.count++] = {2 * axis + (component[axis] < 0), weight[axis] / sum};
        }
    }
    return out;
}

}  // namespace nacre::sparkle
