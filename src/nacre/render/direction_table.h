#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "nacre/core/vec.h"

// Importance sampling of an environment by a piecewise constant density over the sphere.
//
// The sphere is cut by height z (equal areas) and by the "diamond" azimuth, y / (|x| + |y|) within
// each quadrant, whose maps in both directions need no trigonometry:
//     v = (1 - z) / 2,    u = (quadrant + y' / (x' + y')) / 4,
//     du dv / d omega = 1 / (8 (|cos phi| + |sin phi|)^2)

namespace nacre::render {

struct DirectionSample {
    Vec3f direction;
    float pdf;  ///< per solid angle
};

class DirectionTable {
 public:
    /// Density in proportion to the mean of `brightness` (finite, >= 0) over each of
    /// columns x rows cells. Where it vanishes everywhere the density is uniform.
    DirectionTable(int columns, int rows, const std::function<float(Vec3f)>& brightness);

    DirectionSample sample(Vec2f u) const;
    float pdf(Vec3f direction) const;
    /// Mean of the brightness over the sphere.
    float mean_brightness() const { return mean_; }

    static Vec2f to_square(Vec3f direction);
    static Vec3f from_square(Vec2f square);

 private:
    int columns_, rows_;
    float mean_ = 0;
    std::vector<float> density_;     // per cell, mean 1 over the square
    std::vector<float> column_cdf_;  // per row: columns + 1 values
    std::vector<float> row_cdf_;     // rows + 1 values
};

}  // namespace nacre::render
