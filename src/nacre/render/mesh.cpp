#include "nacre/render/mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/math.h"

namespace nacre::render {

Mesh mesh_of_surface(int columns, int rows,
                     const std::function<SurfacePoint(double u, double v)>& surface) {
    Mesh mesh;
    mesh.positions_mm.reserve(static_cast<std::size_t>(columns + 1) * (rows + 1));
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c) {
            const double u = static_cast<double>(c) / columns;
            const double v = static_cast<double>(r) / rows;
            const SurfacePoint p = surface(u, v);
            mesh.positions_mm.push_back(p.position_mm);
            mesh.normals.push_back(p.normal);
            mesh.uv.push_back({static_cast<float>(u), static_cast<float>(v)});
        }
    }
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t r = 0; r < static_cast<std::uint32_t>(rows); ++r) {
        for (std::uint32_t c = 0; c < static_cast<std::uint32_t>(columns); ++c) {
            const std::uint32_t i = r * stride + c;
            mesh.triangles.push_back({i, i + 1, i + stride + 1});
            mesh.triangles.push_back({i, i + stride + 1, i + stride});
        }
    }
    return mesh;
}

AffineMap::AffineMap(const Transform& transform)
    : translation_(transform.translation_mm), scale_(static_cast<float>(transform.scale)) {
    const double cx = std::cos(transform.rotation_deg.x * kDegree);
    const double sx = std::sin(transform.rotation_deg.x * kDegree);
    const double cy = std::cos(transform.rotation_deg.y * kDegree);
    const double sy = std::sin(transform.rotation_deg.y * kDegree);
    const double cz = std::cos(transform.rotation_deg.z * kDegree);
    const double sz = std::sin(transform.rotation_deg.z * kDegree);
    const auto vec = [](double x, double y, double z) {
        return Vec3f{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    };
    // R = Rz Ry Rx: x turns first.
    row_[0] = vec(cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx);
    row_[1] = vec(sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx);
    row_[2] = vec(-sy, cy * sx, cy * cx);
}

void apply(const AffineMap& map, Mesh& mesh) {
    for (Vec3f& p : mesh.positions_mm) p = map.point(p);
    for (Vec3f& n : mesh.normals) n = map.direction(n);
}

namespace {

Vec3f vec(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

Mesh rectangle(double width_mm, double height_mm) {
    return mesh_of_surface(1, 1, [&](double u, double v) {
        return SurfacePoint{vec((u - 0.5) * width_mm, (v - 0.5) * height_mm, 0), {0, 0, 1}};
    });
}

}  // namespace

Mesh make_mesh(const FlatPanel& panel) { return rectangle(panel.width_mm, panel.height_mm); }

Mesh make_mesh(const GroundPlane& plane) { return rectangle(plane.size_mm, plane.size_mm); }

Mesh make_mesh(const CurvedPanel& panel) {
    // 256 facets round the bend: their chords lie within 1e-4 of the radius at a half turn.
    return mesh_of_surface(256, 1, [&](double u, double v) {
        const double r = panel.bend_radius_mm;
        const double angle = (u - 0.5) * panel.width_mm / r;
        return SurfacePoint{
            vec(r * std::sin(angle), (v - 0.5) * panel.height_mm, r * (std::cos(angle) - 1)),
            vec(std::sin(angle), 0, std::cos(angle))};
    });
}

Mesh make_mesh(const Backdrop& backdrop) {
    // The profile in the yz plane: floor, quarter circle, wall, each in its own rows so that the
    // straight parts stay exactly flat.
    const double r = backdrop.fillet_radius_mm;
    constexpr int kFilletRows = 64;
    constexpr int kRows = kFilletRows + 2;
    return mesh_of_surface(1, kRows, [&](double u, double v) {
        const double x = (u - 0.5) * backdrop.width_mm;
        const int row = static_cast<int>(std::lround(v * kRows));
        if (row == 0) return SurfacePoint{vec(x, -backdrop.depth_mm, 0), {0, 0, 1}};
        if (row == kRows) {
            return SurfacePoint{vec(x, backdrop.depth_mm, backdrop.height_mm), {0, -1, 0}};
        }
        const double angle = 0.5 * std::numbers::pi * (row - 1) / kFilletRows;
        return SurfacePoint{
            vec(x, backdrop.depth_mm - r + r * std::sin(angle), r - r * std::cos(angle)),
            vec(0, -std::sin(angle), std::cos(angle))};
    });
}

// The speed shape is lofted: sections across x, each given in polar form about the ground below
// it. A section is the soft union of a wide, low body and a narrow, tall cabin, pressed in along
// the flank and tucked in at the sill. All functions are smooth, and so are the reflections.

namespace {

// Proportions in units of half of the length.
constexpr double kHalfWidth = 0.40;     // of the plan at its mean
constexpr double kSwell = 0.06;         // how much wider it is where it is widest,
constexpr double kWidest = -0.35;       // behind the middle
constexpr double kCabinHeight = 0.165;  // of the roof above the deck
constexpr double kCabinWidth = 0.50;    // at its base, of the width of the body,
constexpr double kCabinSwell = 0.20;    // and how much more under the roof
constexpr double kScreenFoot = 0.52, kRoofFront = -0.02;  // the windscreen rises between them
constexpr double kRoofBack = -0.10, kTail = -0.98;        // and the back falls between these
constexpr double kFlankDepth = 0.085, kFlankElevation = 0.24, kFlankRise = 0.03;
constexpr double kFlankSpread = 0.12;  // of the hollow, radians of elevation
constexpr double kSillDepth = 0.10, kSillSpread = 0.07;

/// Radius of a superellipse of half axes a and b in direction (cosine, sine).
double superellipse(double a, double b, double cosine, double sine, double exponent) {
    if (a <= 0 || b <= 0) return 0;
    return std::pow(std::pow(std::abs(cosine) / a, exponent) + std::pow(sine / b, exponent),
                    -1 / exponent);
}

/// From 1 in the middle to 0 at the end, the more suddenly the larger the exponent.
double rounded_end(double from_middle, double exponent) {
    return std::sqrt(std::max(0.0, 1 - std::pow(from_middle, exponent)));
}

/// From 0 at `from` to 1 at `to`, level at both ends, with even curvature: highlights do not break.
double rise(double from, double to, double s) {
    const double t = std::clamp((s - from) / (to - from), 0.0, 1.0);
    return t * t * t * (t * (6 * t - 15) + 10);
}

/// Point at station u along the body and v around it, both in [0, 1], for a half length of 1.
Vec3d point(double u, double v) {
    const double s =
        -std::cos(std::numbers::pi * u);        // tail -1, nose +1; even steps round the ends
    const double angle = std::numbers::pi * v;  // from the right sill over the roof to the left
    const double cosine = std::cos(angle);
    const double sine = std::max(0.0, std::sin(angle));

    // The nose is drawn out, the tail cut off: in plan, and in side view.
    const double ahead = std::abs(s);
    const double plan = rounded_end(ahead, s > 0 ? 3.2 : 5);
    const double side = rounded_end(ahead, s > 0 ? 4.5 : 7);
    const double width =
        kHalfWidth * (1 + kSwell * std::cos(std::numbers::pi * (s - kWidest))) * plan;
    const double deck = (0.225 - 0.03 * s - 0.045 * s * s) * side;
    const double body = superellipse(width, deck, cosine, sine, 4.5);

    const double raised = rise(kScreenFoot, kRoofFront, s) * rise(kTail, kRoofBack, s);
    const double cabin = superellipse(width * (kCabinWidth + kCabinSwell * raised),
                                      deck + kCabinHeight * raised, cosine, sine, 2.3);

    constexpr double kUnion = 24;  // the larger, the sharper the line between cabin and shoulder
    double radius =
        body > 0 ? body * std::pow(1 + std::pow(cabin / body, kUnion), 1 / kUnion) : 0.0;

    const double elevation = std::asin(std::clamp(sine, 0.0, 1.0));
    const double along = 1 - s * s;  // the hollow of the flank runs out before nose and tail
    const double middle = kFlankElevation + kFlankRise * s;
    radius *= 1 - kFlankDepth * along * std::exp(-square((elevation - middle) / kFlankSpread));
    radius *= 1 - kSillDepth * std::exp(-square(elevation / kSillSpread));
    return {s, -radius * cosine, radius * sine};
}

/// Normal by central differences; at the two tips, where all v meet, along x.
Vec3f normal(double u, double v) {
    constexpr double kStep = 1e-4;
    const double u0 = std::max(u - kStep, 0.0), u1 = std::min(u + kStep, 1.0);
    const double v0 = std::max(v - kStep, 0.0), v1 = std::min(v + kStep, 1.0);
    const Vec3d n = cross(point(u1, v) - point(u0, v), point(u, v1) - point(u, v0));
    if (length(n) < 1e-12) return {u < 0.5 ? -1.0f : 1.0f, 0, 0};
    return to_float(n / length(n));
}

}  // namespace

Mesh make_mesh(const SpeedShape& shape) {
    const double scale = 0.5 * shape.length_mm;
    return mesh_of_surface(384, 256, [&](double u, double v) {
        return SurfacePoint{to_float(scale * point(u, v)), normal(u, v)};
    });
}

}  // namespace nacre::render
