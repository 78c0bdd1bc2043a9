#include "nacre/layers/brdf_table_grid.h"

#include <numbers>

#include "nacre/core/error.h"
#include "nacre/layers/directions.h"
#include "nacre/optics/dielectric.h"

namespace nacre::layers {

void validate(const BrdfGrid& grid) {
    require_in_range(grid.angles, 8, BrdfGrid::kMostAngles, "angles of a BRDF table");
    require_in_range(grid.azimuths, 8, BrdfGrid::kMostAzimuths, "azimuths of a BRDF table");
    require_in_range(grid.ior, 1, 3, "ior of a BRDF table");
    require_in_range(grid.roughness, 0, 1, "roughness of a BRDF table");
    require_in_range(grid.lobe_alpha, 1e-4, 1, "lobe_alpha of a BRDF table");
}

double BrdfGrid::angle(int node) const {
    const double x = static_cast<double>(node) / (angles - 1);
    return std::min(2 * std::atan(x), std::numbers::pi / 2 - 1e-4);
}

double BrdfGrid::azimuth(double theta_i, double theta_o, int node) const {
    const double u2 = std::pow(static_cast<double>(node) / (azimuths - 1), 2);
    const double side = side_ior();
    const double scale =
        side * lobe_alpha * (inside_cosine(side, theta_i) + inside_cosine(side, theta_o));
    const double ratio = 4 * std::sin(theta_i) * std::sin(theta_o) / (scale * scale);
    const double v2 = ratio > 1e-4 ? std::expm1(u2 * std::log1p(ratio)) / ratio : u2;
    return std::numbers::pi - 2 * std::asin(std::sqrt(std::min(v2, 1.0)));
}

double BrdfGrid::factor(double theta_i, double theta_o) const {
    const double side = side_ior();
    const double mu = inside_cosine(side, theta_i) + inside_cosine(side, theta_o);
    if (roughness > 0) return 1 / mu;
    const double t_i = 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta_i));
    const double t_o = 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta_o));
    return t_i * t_o / (ior * ior * mu);
}

}  // namespace nacre::layers
