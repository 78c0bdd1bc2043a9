#include "nacre/bsdf/rgl_map.h"

#include <algorithm>

namespace nacre::bsdf {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

const RglTable& checked(const RglTable& table) {
    validate(table);
    return table;
}

int parts_of_circle(const RglTable& table) {
    if (table.isotropic()) return 1;
    return static_cast<int>(std::round(2 * kPi / (table.phi_i.back() - table.phi_i.front())));
}

}  // namespace

float read_square(const SquareTable& table, Vec2f point) {
    const SquareCell cell = locate_in_square(point, table.rows, table.columns);
    const float* at =
        table.values.data() + static_cast<std::size_t>(cell.row) * table.columns + cell.column;
    const float low = at[0] + cell.column_share * (at[1] - at[0]);
    at += table.columns;
    const float high = at[0] + cell.column_share * (at[1] - at[0]);
    return low + cell.row_share * (high - low);
}

RglMap::RglMap(const RglTable& table)
    : isotropic_(checked(table).isotropic()),
      jacobian_(table.jacobian),
      parts_(parts_of_circle(table)),
      grid_(table.phi_i, table.theta_i),
      ndf_(table.ndf),
      sigma_(table.sigma),
      vndf_(table.vndf, static_cast<int>(table.slices()), table.vndf_rows, table.vndf_columns) {}

// Half the circle was measured where the surface looks the same after half a turn, from -180 to
// 0 deg; a quarter where it has two mirror planes, from -180 to -90 deg.
RglIncident RglMap::incident(Vec3f wi) const {
    RglIncident i;
    i.flip_x = i.flip_y = 1;
    if (parts_ >= 2) {
        i.flip_y = -std::copysign(1.0f, wi.y);
        i.flip_x = parts_ == 4 ? -std::copysign(1.0f, wi.x) : i.flip_y;
    }
    i.direction = {i.flip_x * wi.x, i.flip_y * wi.y, wi.z};
    const float theta = polar_angle(i.direction);
    i.phi = std::atan2(i.direction.y, i.direction.x);
    i.mix = grid_.locate(i.phi, theta);
    i.inverse_sigma = 1 / read_square(sigma_, square_point(theta, i.phi));
    return i;
}

RglPoint RglMap::towards(const RglIncident& i, Vec3f wo) const {
    RglPoint point;
    point.normal = normalize(i.direction + wo);
    const float phi = std::atan2(point.normal.y, point.normal.x);
    point.half = square_point(polar_angle(point.normal), isotropic_ ? phi - i.phi : phi);
    const SquareWarp::Point found = vndf_.invert(i.mix, point.half);
    point.sample = found.at;
    point.density = found.density;
    return point;
}

RglPoint RglMap::at(const RglIncident& i, Vec2f sample) const {
    const SquareWarp::Point found = vndf_.sample(i.mix, sample);
    RglPoint point;
    point.sample = sample;
    point.half = found.at;
    point.density = found.density;
    const float theta = 0.5f * kPi * found.at.x * found.at.x;
    const float phi = (2 * found.at.y - 1) * kPi + (isotropic_ ? i.phi : 0.0f);
    const float sine = std::sin(theta);
    point.normal = {sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)};
    return point;
}

float RglMap::scale(const RglIncident& i, const RglPoint& point) const {
    return jacobian_ ? 0.25f * read_square(ndf_, point.half) * i.inverse_sigma : 1.0f;
}

// Steps of the half vector in the square are 2 pi^2 x dx dy of its angles, those of wo 4 w_i.m of
// its solid angle. At the normal itself, where x and the sine vanish and the interpolated density
// need not, the density has a pole that still can be integrated.
float RglMap::solid_angle_density(const RglIncident& i, const RglPoint& point) const {
    constexpr float kLeast = 1e-12f;
    const float sine = std::sqrt(point.normal.x * point.normal.x + point.normal.y * point.normal.y);
    const float area = 2 * kPi * kPi * point.half.x * sine;
    return point.density / std::max(area * 4 * dot(i.direction, point.normal), kLeast);
}

}  // namespace nacre::bsdf
