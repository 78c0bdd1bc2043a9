#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/core/range.h"

namespace nacre::discs {

/// A rectangle of paint that repeats itself: its opposite edges are joined, so that it has no
/// border, and what light sees beyond an edge is what lies at the other one.
struct Tile {
    double width_um = 0, height_um = 0;

    /// Moves a place into the tile.
    void wrap(double& x, double& y) const {
        x = modulo(x, width_um);
        y = modulo(y, height_um);
    }
    /// How far a ray goes until it leaves the tile; infinite along the normal.
    double to_edge(double x, double y, double dx, double dy) const {
        return std::min(along(x, dx, width_um), along(y, dy, height_um));
    }
    /// Out at the edge that the ray has come to, in at the opposite one.
    void step_over(double& x, double& y, double dx, double dy) const {
        over(x, dx, width_um);
        over(y, dy, height_um);
    }

 private:
    static double modulo(double x, double period) {
        const double rest = x - period * std::floor(x / period);
        return rest < period ? rest : 0;
    }
    static double along(double x, double direction, double side) {
        if (direction == 0) return std::numeric_limits<double>::infinity();
        return std::max(0.0, ((direction > 0 ? side : 0) - x) / direction);
    }
    static void over(double& x, double direction, double side) {
        const double near = 1e-9 * side;  // what rounding leaves of the way to the edge
        if (direction > 0 && x >= side - near) {
            x = 0;
        } else if (direction < 0 && x <= near) {
            x = side;
        }
    }
};

inline constexpr Range kTileSide{.lo = 0.01, .hi = 1000, .unit = "mm"};

}  // namespace nacre::discs
