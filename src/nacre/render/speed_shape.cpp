#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/render/mesh.h"

// The speed shape is lofted: sections across x, each given in polar form about the ground below
// it. A section is the soft union of a wide, low body and a narrow, tall cabin, pressed in along
// the flank and tucked in at the sill. All functions are smooth, and so are the reflections.

namespace nacre::render {
namespace {

constexpr double kPi = std::numbers::pi;

// Proportions in units of half of the length.
constexpr double kHalfWidth = 0.44;
constexpr double kBodyHeight = 0.29;
constexpr double kBodyFall = 0.10;  // of the body's height, from the middle to the nose
constexpr double kCabinHeight = 0.50;
constexpr double kCabinHalfWidth = 0.33;
constexpr double kCabinMiddle = -0.12;  // behind the middle
constexpr double kCabinHalfLength = 0.80;
constexpr double kFlankDepth = 0.075;     // of the flank's hollow, relative to the radius
constexpr double kFlankElevation = 0.32;  // of the hollow above the ground, in rad about the axis
constexpr double kFlankSpread = 0.16;
constexpr double kSillDepth = 0.10;
constexpr double kSillSpread = 0.10;

double square(double x) { return x * x; }

/// Radius of a superellipse of half axes a and b in direction (cosine, sine).
double superellipse(double a, double b, double cosine, double sine, double exponent) {
    if (a <= 0 || b <= 0) return 0;
    return std::pow(std::pow(std::abs(cosine) / a, exponent) + std::pow(sine / b, exponent),
                    -1 / exponent);
}

/// Point at station u along the body and v around it, both in [0, 1], for a half length of 1.
std::array<double, 3> point(double u, double v) {
    const double s = -std::cos(kPi * u);  // tail -1, nose +1; even steps round the ends
    const double angle = kPi * v;         // from the right sill over the roof to the left
    const double cosine = std::cos(angle);
    const double sine = std::max(0.0, std::sin(angle));

    const double end = std::sqrt(std::max(0.0, 1 - std::pow(std::abs(s), 3.0)));
    const double width = kHalfWidth * (1 - 0.05 * s) * end;
    const double height = kBodyHeight * (1 - kBodyFall * s) * end;
    const double body = superellipse(width, height, cosine, sine, 3.0);

    const double t = (s - kCabinMiddle) / kCabinHalfLength;
    const double bump = std::abs(t) < 1 ? square(1 - t * t) : 0.0;
    const double cabin =
        superellipse(kCabinHalfWidth * std::sqrt(bump), kCabinHeight * bump, cosine, sine, 2.2);

    constexpr double kUnion = 9;  // the larger, the sharper the line between cabin and shoulder
    double radius =
        body > 0 ? body * std::pow(1 + std::pow(cabin / body, kUnion), 1 / kUnion) : 0.0;

    const double elevation = std::asin(std::clamp(sine, 0.0, 1.0));
    const double along = square(1 - s * s);  // the hollow runs out before nose and tail
    radius *=
        1 - kFlankDepth * along * std::exp(-square((elevation - kFlankElevation) / kFlankSpread));
    radius *= 1 - kSillDepth * std::exp(-square(elevation / kSillSpread));
    return {s, -radius * cosine, radius * sine};
}

std::array<double, 3> difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Normal by central differences; at the two tips, where all v meet, along x.
Vec3f normal(double u, double v) {
    constexpr double kStep = 1e-4;
    const double u0 = std::max(u - kStep, 0.0), u1 = std::min(u + kStep, 1.0);
    const double v0 = std::max(v - kStep, 0.0), v1 = std::min(v + kStep, 1.0);
    const auto du = difference(point(u1, v), point(u0, v));
    const auto dv = difference(point(u, v1), point(u, v0));
    const double x = du[1] * dv[2] - du[2] * dv[1];
    const double y = du[2] * dv[0] - du[0] * dv[2];
    const double z = du[0] * dv[1] - du[1] * dv[0];
    const double norm = std::sqrt(x * x + y * y + z * z);
    if (norm < 1e-12) return {u < 0.5 ? -1.0f : 1.0f, 0, 0};
    return {static_cast<float>(x / norm), static_cast<float>(y / norm),
            static_cast<float>(z / norm)};
}

}  // namespace

Mesh make_mesh(const SpeedShape& shape) {
    const double scale = 0.5 * shape.length_mm;
    return mesh_of_surface(384, 256, [&](double u, double v) {
        const auto p = point(u, v);
        return SurfacePoint{{static_cast<float>(scale * p[0]), static_cast<float>(scale * p[1]),
                             static_cast<float>(scale * p[2])},
                            normal(u, v)};
    });
}

}  // namespace nacre::render
