#include "nacre/measure/cone.h"

#include <cmath>
#include <numbers>

#include "nacre/core/quadrature.h"

namespace nacre::measure {

std::vector<ConeNode> cone_rule(double theta, double phi, double half_angle, int rings) {
    if (half_angle == 0) return {{theta, phi, 1.0}};
    const int around = 4 * rings;
    const Quadrature& rule = unit_gauss_legendre(rings);
    const double sine = std::sin(theta), cosine = std::cos(theta);
    // 1 - cos by the half angle: no digits are lost in a narrow cone.
    const double whole = 2 * std::pow(std::sin(half_angle / 2), 2);
    std::vector<ConeNode> nodes;
    double sum = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const double fall = whole * rule.nodes[ring];  // 1 - cos of the angle to the axis
        const double along = 1 - fall, across = std::sqrt(fall * (2 - fall));
        for (int step = 0; step < around; ++step) {
            const double turn = 2 * std::numbers::pi * (step + 0.5) / around;
            // In the frame of the axis: across it away from the normal, and aside.
            const double away = across * std::cos(turn), aside = across * std::sin(turn);
            const double x = along * sine + away * cosine, z = along * cosine - away * sine;
            if (!(z > 1e-12)) continue;
            const double weight = rule.weights[ring] * z;
            nodes.push_back(
                {std::atan2(std::hypot(x, aside), z), phi + std::atan2(aside, x), weight});
            sum += weight;
        }
    }
    for (ConeNode& node : nodes) node.weight /= sum;
    return nodes;
}

}  // namespace nacre::measure
