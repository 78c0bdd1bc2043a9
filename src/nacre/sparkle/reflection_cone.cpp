#include "nacre/sparkle/reflection_cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"

namespace nacre::sparkle {

ConeRule::ConeRule(double gamma_rad, double alpha) {
    require_in_range(gamma_rad, 1e-5, 0.5 * std::numbers::pi, "half-angle of the cone in rad");
    require_in_range(alpha, 1e-4, 2, "roughness alpha of the facets");
    const double half_sine = std::sin(0.5 * gamma_rad);
    const double versine = 2 * half_sine * half_sine;
    solid_angle_ = 2 * std::numbers::pi * versine;
    chord2_ = static_cast<float>(2 * versine);
    versine_ = static_cast<float>(versine);
    inverse_alpha2_ = static_cast<float>(1 / (alpha * alpha));
    norm_ = static_cast<float>(std::numbers::inv_pi / (alpha * alpha));

    // Nodes for Gaussians of width alpha over a region that reaches gamma/2 across the plane of
    // incidence near normal and several times as much at grazing incidence.
    const double width = gamma_rad / alpha;
    require_in_range(width, 0, kMaxConePerRoughness, "half-angle of the cone over alpha");
    const int rings = std::max(3, static_cast<int>(std::ceil(2 + 1.5 * width)));
    constexpr int kMaxGrazingRings = 48;
    groups_ = product_rule(rings, versine);
    grazing_groups_ = product_rule(std::min(3 * rings, kMaxGrazingRings), versine);
}

std::vector<ConeRule::Group> ConeRule::product_rule(int rings, double versine) {
    const int spokes = kLanes * ((2 * rings + kLanes - 1) / kLanes);  // whole groups of lanes
    const Quadrature& rule = unit_gauss_legendre(rings);
    std::vector<Group> groups;
    for (int ring = 0; ring < rings; ++ring) {
        const double drop = versine * rule.nodes[ring];
        const double sine = std::sqrt(drop * (2 - drop));
        for (int first = 0; first < spokes; first += kLanes) {
            // Rings are turned against each other, so that spokes do not line up.
            const auto angle = [&](int i) {
                return 2 * std::numbers::pi * (first + i + 0.5 * (ring % 2)) / spokes;
            };
            groups.push_back(
                {make_lanes([&](int i) { return static_cast<float>(sine * std::cos(angle(i))); }),
                 make_lanes([&](int i) { return static_cast<float>(sine * std::sin(angle(i))); }),
                 splat(static_cast<float>(1 - drop)),
                 splat(static_cast<float>(rule.weights[ring] / spokes))});
        }
    }
    return groups;
}

}  // namespace nacre::sparkle
