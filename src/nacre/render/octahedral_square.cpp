#include "nacre/render/octahedral_square.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::render {

std::array<double, 2> octahedral_square(Vec3f n) {
    const double x = std::abs(double{n.x}), y = std::abs(double{n.y}), z = std::abs(double{n.z});
    // Distance from the pole such that areas are kept; of the two equal forms of 1 - z the one that
    // does not cancel.
    const double r = std::sqrt((x * x + y * y) / (1 + z));
    const double turn = x + y > 0 ? std::atan2(y, x) * (2 * std::numbers::inv_pi) : 0;
    double a = r * (1 - turn), b = r * turn;
    if (n.z < 0) {
        const double unfolded = 1 - b;
        b = 1 - a;
        a = unfolded;
    }
    const double u = 0.5 + 0.5 * std::copysign(a, double{n.x});
    const double v = 0.5 + 0.5 * std::copysign(b, double{n.y});
    return {std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0)};  // r may exceed 1 by rounding
}

}  // namespace nacre::render
