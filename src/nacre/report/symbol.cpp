#include "nacre/report/symbol.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::report {

std::string svg_number(double pixels) {
    // Rasterisers count in 24 bits before the point.
    constexpr double kFar = 1e5;
    const double rounded = std::round(100 * std::clamp(pixels, -kFar, kFar)) / 100;
    return fmt::format("{}", rounded == 0 ? 0.0 : rounded);  // no -0
}

std::string symbol_path(std::string_view symbol, double radius) {
    const double area = std::numbers::pi * radius * radius;
    if (symbol == "square") {
        const double side = std::sqrt(area);
        return fmt::format("M{0} {0}h{1}v{1}h-{1}z", svg_number(-side / 2), svg_number(side));
    }
    if (symbol == "triangle") {
        // Equilateral, its centroid at the point.
        const double side = std::sqrt(4 * area / std::numbers::sqrt3);
        const double height = side * std::numbers::sqrt3 / 2;
        return fmt::format("M0 {}L{} {}H{}z", svg_number(-2 * height / 3), svg_number(side / 2),
                           svg_number(height / 3), svg_number(-side / 2));
    }
    if (symbol == "diamond") {
        const double half = std::sqrt(area / 2);
        return fmt::format("M0 -{0}L{0} 0L0 {0}L-{0} 0z", svg_number(half));
    }
    return fmt::format("M-{0} 0a{0} {0} 0 1 0 {1} 0a{0} {0} 0 1 0 -{1} 0z", svg_number(radius),
                       svg_number(2 * radius));
}

}  // namespace nacre::report
