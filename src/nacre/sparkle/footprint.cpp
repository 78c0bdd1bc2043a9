#include "nacre/sparkle/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nacre::sparkle {
namespace {

struct Corner {
    double u, v;
};

// A convex polygon: a parallelogram cut by four lines has at most eight corners.
struct Polygon {
    static constexpr int kMaxCorners = 8;
    std::array<Corner, kMaxCorners> corners;
    int count = 0;

    // Rounding can make a line seem to cut a sliver more than twice; its area is negligible.
    void add(Corner p) {
        if (count < kMaxCorners) corners[count++] = p;
    }
    double area() const {
        double twice = 0;
        for (int i = 2; i < count; ++i) {
            const Corner a = corners[0], b = corners[i - 1], c = corners[i];
            twice += (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
        }
        return 0.5 * std::abs(twice);
    }
};

// The part of a convex polygon with depth(p) >= 0, depth linear.
template <class Depth>
Polygon cut(const Polygon& polygon, Depth&& depth) {
    Polygon out;
    for (int i = 0; i < polygon.count; ++i) {
        const Corner a = polygon.corners[i], b = polygon.corners[(i + 1) % polygon.count];
        const double in_a = depth(a), in_b = depth(b);
        if (in_a >= 0) out.add(a);
        if ((in_a >= 0) != (in_b >= 0)) {
            const double f = in_a / (in_a - in_b);
            out.add({a.u + f * (b.u - a.u), a.v + f * (b.v - a.v)});
        }
    }
    return out;
}

Polygon cut_to(const Box& box, Polygon polygon) {
    polygon = cut(polygon, [&](Corner p) { return p.u - box.u_lo; });
    polygon = cut(polygon, [&](Corner p) { return box.u_hi - p.u; });
    polygon = cut(polygon, [&](Corner p) { return p.v - box.v_lo; });
    return cut(polygon, [&](Corner p) { return box.v_hi - p.v; });
}

Polygon corners_of(double u, double v, Vec2f a, Vec2f b) {
    Polygon out;
    const double sum_x = 0.5 * (static_cast<double>(a.x) + b.x);
    const double sum_y = 0.5 * (static_cast<double>(a.y) + b.y);
    const double difference_x = 0.5 * (static_cast<double>(a.x) - b.x);
    const double difference_y = 0.5 * (static_cast<double>(a.y) - b.y);
    out.add({u - sum_x, v - sum_y});
    out.add({u + difference_x, v + difference_y});
    out.add({u + sum_x, v + sum_y});
    out.add({u - difference_x, v - difference_y});
    return out;
}

}  // namespace

Footprint::Footprint(double u, double v, Vec2f edge_1, Vec2f edge_2)
    : u_(u), v_(v), edge_1_(edge_1), edge_2_(edge_2) {
    const double a = edge_1.x, b = edge_1.y, c = edge_2.x, d = edge_2.y;
    const double twist = a * d - b * c;
    if (!std::isfinite(u) || !std::isfinite(v) || !std::isfinite(1 / twist)) return;
    s_ = {d / twist, -c / twist};
    t_ = {-b / twist, a / twist};
    if (!std::isfinite(s_.du + s_.dv) || !std::isfinite(t_.du + t_.dv)) return;
    const double reach_u = 0.5 * (std::abs(a) + std::abs(c));
    const double reach_v = 0.5 * (std::abs(b) + std::abs(d));
    bounds_ = {std::max(0.0, u - reach_u), std::max(0.0, v - reach_v), std::min(1.0, u + reach_u),
               std::min(1.0, v + reach_v)};
    const bool inside =
        u - reach_u >= 0 && v - reach_v >= 0 && u + reach_u <= 1 && v + reach_v <= 1;
    const double area = inside ? std::abs(twist) : shared_area({0, 0, 1, 1});
    area_ = std::isfinite(area) ? area : 0;
}

double Footprint::shared_area(const Box& box) const {
    return cut_to(box, corners_of(u_, v_, edge_1_, edge_2_)).area();
}

}  // namespace nacre::sparkle
