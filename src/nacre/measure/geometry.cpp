#include "nacre/measure/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/range.h"

namespace nacre::measure {

namespace {

using Direction = std::array<double, 3>;

constexpr double kDegree = std::numbers::pi / 180;
constexpr Range kPolar{0, 90, "deg", false, true};

void require(double value, const Range& range, const char* what) {
    if (!range.contains(value)) {
        throw DomainError(fmt::format("{} = {}: must be in {}", what, value, range.text()));
    }
}

Direction direction(double theta_deg, double phi_deg) {
    const double sine = std::sin(theta_deg * kDegree);
    return {sine * std::cos(phi_deg * kDegree), sine * std::sin(phi_deg * kDegree),
            std::cos(theta_deg * kDegree)};
}

/// Between unit vectors; exact for small angles too, where the arc cosine loses half its digits.
double angle_deg(const Direction& a, const Direction& b) {
    double sum = 0, difference = 0;
    for (int i = 0; i < 3; ++i) {
        sum += (a[i] + b[i]) * (a[i] + b[i]);
        difference += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return 2 * std::atan2(std::sqrt(difference), std::sqrt(sum)) / kDegree;
}

/// An angle in [0, 360).
double wrapped(double degrees) {
    const double rest = std::fmod(degrees, 360);
    // A tiny negative angle would round to 360.
    return rest < 0 ? std::fmod(rest + 360, 360) : rest;
}

Direction lamp(const Geometry& geometry) { return direction(geometry.theta_i_deg, 0); }
Direction view(const Geometry& geometry) {
    return direction(geometry.theta_o_deg, geometry.phi_deg);
}
Direction mirror(double theta_i_deg) { return direction(theta_i_deg, 180); }

}  // namespace

Geometry in_plane(double theta_i_deg, double aspecular_deg) {
    require(theta_i_deg, kPolar, "lamp in deg");
    const double view_deg = theta_i_deg - aspecular_deg;
    if (!(std::abs(view_deg) < 90)) {
        throw DomainError(
            fmt::format("aspecular angle = {} deg: with the lamp at {} deg it must be in ({}, {}), "
                        "or the view is below the horizon",
                        aspecular_deg, theta_i_deg, theta_i_deg - 90, theta_i_deg + 90));
    }
    return {fmt::format("{}as{}", theta_i_deg, aspecular_deg), theta_i_deg, aspecular_deg,
            std::abs(view_deg), view_deg >= 0 ? 180.0 : 0.0};
}

Geometry off_plane(double theta_i_deg, double aspecular_deg, double azimuth_deg) {
    require(theta_i_deg, kPolar, "lamp in deg");
    require(aspecular_deg, {0, 180, "deg", false, true}, "aspecular angle");
    require(azimuth_deg, {-180, 180, "deg"}, "azimuth about the mirror direction");
    if (azimuth_deg == 0) return in_plane(theta_i_deg, -aspecular_deg);
    if (std::abs(azimuth_deg) == 180) return in_plane(theta_i_deg, aspecular_deg);
    if (aspecular_deg == 0) return in_plane(theta_i_deg, 0);
    // Of a step along the mirror direction and two across it: away from the normal, and off the
    // plane.
    const double along = std::cos(aspecular_deg * kDegree),
                 across = std::sin(aspecular_deg * kDegree),
                 away = across * std::cos(azimuth_deg * kDegree),
                 aside = across * std::sin(azimuth_deg * kDegree),
                 sine = std::sin(theta_i_deg * kDegree), cosine = std::cos(theta_i_deg * kDegree);
    const double x = -along * sine - away * cosine, z = along * cosine - away * sine;
    if (!(z > 1e-12)) {
        throw DomainError(fmt::format(
            "aspecular angle = {} deg, azimuth = {} deg: with the lamp at {} deg the view is below "
            "the horizon",
            aspecular_deg, azimuth_deg, theta_i_deg));
    }
    return {fmt::format("{}as{}az{}", theta_i_deg, aspecular_deg, azimuth_deg), theta_i_deg,
            aspecular_deg, std::atan2(std::hypot(x, aside), z) / kDegree,
            wrapped(std::atan2(aside, x) / kDegree)};
}

Geometry towards(double theta_i_deg, double theta_o_deg, double phi_deg) {
    require(theta_i_deg, kPolar, "lamp in deg");
    require(theta_o_deg, kPolar, "theta of the view in deg");
    require(phi_deg, {-360, 360, "deg"}, "phi of the view");
    const double phi = wrapped(phi_deg);
    if (phi == 180 || theta_o_deg == 0) return in_plane(theta_i_deg, theta_i_deg - theta_o_deg);
    if (phi == 0) return in_plane(theta_i_deg, theta_i_deg + theta_o_deg);
    return {fmt::format("{}to{},{}", theta_i_deg, theta_o_deg, phi), theta_i_deg,
            angle_deg(direction(theta_o_deg, phi), mirror(theta_i_deg)), theta_o_deg, phi};
}

bool is_in_plane(const Geometry& geometry) {
    return geometry.theta_o_deg == 0 || geometry.phi_deg == 0 || geometry.phi_deg == 180;
}

double separation_deg(const Geometry& a, const Geometry& b) {
    return std::max(angle_deg(lamp(a), lamp(b)), angle_deg(view(a), view(b)));
}

}  // namespace nacre::measure
