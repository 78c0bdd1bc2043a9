#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "nacre/core/lane_math.h"
#include "nacre/core/vec.h"
#include "nacre/sparkle/footprint.h"

// How much of eight discs lies in a parallelogram.

namespace nacre::sparkle {

/// The parallelogram about the origin that two edges span, by its sides.
struct Parallelogram {
    struct Side {
        Vec2f from, along;  // a corner, and the unit vector towards the next, anticlockwise
        float size;
    };
    std::array<Side, 4> sides;
    float area;

    Parallelogram() {}  // of no shape yet
    /// Edges of non-zero area, anticlockwise from the first to the second.
    Parallelogram(Vec2f edge_1, Vec2f edge_2) {
        const auto size = [](Vec2f e) { return std::sqrt(e.x * e.x + e.y * e.y); };
        const float size_1 = size(edge_1), size_2 = size(edge_2);
        set(edge_1, size_1, {edge_1.x / size_1, edge_1.y / size_1}, edge_2, size_2,
            {edge_2.x / size_2, edge_2.y / size_2});
    }
    /// The same where the lengths of the edges and their unit vectors are known.
    void set(Vec2f edge_1, float size_1, Vec2f along_1, Vec2f edge_2, float size_2, Vec2f along_2) {
        area = edge_1.x * edge_2.y - edge_1.y * edge_2.x;
        const Vec2f a = {0.5f * (edge_1.x + edge_2.x), 0.5f * (edge_1.y + edge_2.y)};
        const Vec2f b = {0.5f * (edge_2.x - edge_1.x), 0.5f * (edge_2.y - edge_1.y)};
        sides[0] = {{-a.x, -a.y}, along_1, size_1};
        sides[1] = {{-b.x, -b.y}, along_2, size_2};
        sides[2] = {a, {-along_1.x, -along_1.y}, size_1};
        sides[3] = {b, {-along_2.x, -along_2.y}, size_2};
    }
};

/// Error of disc_overlap(), in areas of the disc.
inline constexpr double kDiscOverlapError = 2e-6;

/// Area that a disc about (x, y) shares with a parallelogram.
///
/// By the angles under which the centre sees the sides: a side at the signed distance d, seen from
/// t_0 to t_1 along it, bounds the area  Int min(r^2, d^2 + t^2)/2 d(angle). The angles add up to
/// a full turn if the centre is inside and to none outside, so only those of the chords are needed.
inline FloatLanes disc_overlap(FloatLanes x, FloatLanes y, FloatLanes radius,
                               const Parallelogram& shape) {
    const FloatLanes radius2 = radius * radius;
    FloatLanes triangles{}, sectors{};
    auto inside = x == x;  // all lanes
    for (const Parallelogram::Side& side : shape.sides) {
        const FloatLanes px = side.from.x - x, py = side.from.y - y;
        const FloatLanes distance = px * side.along.y - py * side.along.x;
        const FloatLanes t0 = px * side.along.x + py * side.along.y, t1 = t0 + side.size;
        const FloatLanes chord = sqrt_lanes(max_lanes(radius2 - distance * distance, FloatLanes{}));
        const FloatLanes c0 = min_lanes(max_lanes(t0, -chord), chord);
        const FloatLanes c1 = min_lanes(max_lanes(t1, -chord), chord);
        // On the side itself counts as inside, with the full angle that goes with it.
        const FloatLanes off = distance == 0.0f ? splat(1e-30f) : distance;
        inside &= off > 0.0f;
        triangles += distance * (c1 - c0);
        sectors += atan2_lanes(off * (c1 - c0), off * off + c0 * c1);
    }
    const FloatLanes full = inside ? splat(2 * std::numbers::pi_v<float>) : FloatLanes{};
    return max_lanes(0.5f * (triangles + radius2 * (full - sectors)), FloatLanes{});
}

/// A patch in its own plane, x along its tangent and the origin in its middle: which discs touch it
/// and how much of it they cover.
class PatchOutline {
 public:
    /// @param smallest_radius_mm, largest_radius_mm  of the discs
    PatchOutline(const ObjectSpaceFootprint& patch, float smallest_radius_mm,
                 float largest_radius_mm)
        : tangent(patch.tangent),
          bitangent(cross(patch.normal, patch.tangent)),
          reach_mm(largest_radius_mm) {
        for (int i = 0; i < 2; ++i) {
            edge_[i] = {dot(patch.edge_mm[i], tangent), dot(patch.edge_mm[i], bitangent)};
            size_mm[i] = length(edge_[i]);
        }
        // So small that the rim of a disc runs straight through it.
        constexpr float kPoint = 0.05f;
        is_point_ = size_mm[0] + size_mm[1] < kPoint * smallest_radius_mm;
        // A needle gets some width, so that it has an area.
        const float min_width = 1e-3f * smallest_radius_mm;
        const int longer = size_mm[1] > size_mm[0];
        if (!is_point_ && std::abs(area()) < min_width * size_mm[longer]) {
            const float thin = min_width / size_mm[longer];
            edge_[1 - longer] = {-edge_[longer].y * thin, edge_[longer].x * thin};
            size_mm[1 - longer] = min_width;
        }
        const bool swapped = area() < 0;
        if (swapped) {
            std::swap(edge_[0], edge_[1]);
            std::swap(size_mm[0], size_mm[1]);
        }
        Vec2f along[2] = {{0, -1}, {1, 0}};  // of edges of no length: any
        for (int i = 0; i < 2; ++i) {
            if (size_mm[i] > 0) {
                const float inverse = 1 / size_mm[i];
                along[i] = {edge_[i].x * inverse, edge_[i].y * inverse};
            }
            const Vec2f n = {-along[i].y, along[i].x};
            strip[i] = {n, 0.5f * (std::abs(dot(n, edge_[0])) + std::abs(dot(n, edge_[1]))) +
                               largest_radius_mm};
        }
        for (int i = 0; i < 2; ++i) tilt_[i] = patch.tilt[i];
        if (swapped) std::swap(tilt_[0], tilt_[1]);
        if (!is_point_) {
            shape_.set(edge_[0], size_mm[0], along[0], edge_[1], size_mm[1], along[1]);
        }
    }

    Vec3f tangent, bitangent;
    float size_mm[2];  ///< of the edges
    float reach_mm;    ///< radius of the largest disc

    /// A disc may touch the patch if its middle is within half_width_mm of the middle of both
    /// strips between opposite sides, across them.
    struct Strip {
        Vec2f normal;
        float half_width_mm;
    };
    Strip strip[2];
    /// All bits set in the lanes whose discs may touch the patch: all that do, and few others.
    auto touches(FloatLanes x, FloatLanes y, FloatLanes radius_mm) const {
        const FloatLanes a = x * strip[0].normal.x + y * strip[0].normal.y;
        const FloatLanes b = x * strip[1].normal.x + y * strip[1].normal.y;
        const FloatLanes a_max = strip[0].half_width_mm + radius_mm - reach_mm;
        const FloatLanes b_max = strip[1].half_width_mm + radius_mm - reach_mm;
        return (a * a < a_max * a_max) & (b * b < b_max * b_max);
    }

    /// The fraction of the patch that a disc about (x, y) covers.
    FloatLanes coverage(FloatLanes x, FloatLanes y, FloatLanes radius_mm) const {
        if (is_point_) {
            const FloatLanes distance = sqrt_lanes(x * x + y * y);
            const FloatLanes safe = max_lanes(distance, splat(1e-20f));
            FloatLanes width = splat(1e-20f);  // of the patch towards the disc's middle
            for (const Vec2f& e : edge_) {
                const FloatLanes along = e.x * x + e.y * y;
                width += (along < 0.0f ? -along : along) / safe;
            }
            const FloatLanes fraction = 0.5f + (radius_mm - distance) / width;
            return min_lanes(max_lanes(fraction, FloatLanes{}), splat(1.0f));
        }
        return disc_overlap(x, y, radius_mm, shape_) * (1 / shape_.area);
    }

    /// Weight of what a disc about (x, y) covers, over the mean over the patch: roughly, as taken
    /// at one point, the nearer to the middle the larger the disc.
    FloatLanes relative_weight(FloatLanes x, FloatLanes y, FloatLanes radius_mm) const {
        if (is_point_ || (tilt_[0] == 0 && tilt_[1] == 0)) return splat(1.0f);
        const FloatLanes inverse =
            2.0f / (shape_.area + std::numbers::pi_v<float> * radius_mm * radius_mm);
        const auto at = [&](FloatLanes along, float tilt) {
            return 1.0f + tilt * min_lanes(max_lanes(along, splat(-1.0f)), splat(1.0f));
        };
        // Twice the place along each edge: -1 and 1 at its ends.
        return at(inverse * (x * edge_[1].y - y * edge_[1].x), tilt_[0]) *
               at(inverse * (y * edge_[0].x - x * edge_[0].y), tilt_[1]);
    }

 private:
    float area() const { return edge_[0].x * edge_[1].y - edge_[0].y * edge_[1].x; }

    Vec2f edge_[2];        // anticlockwise
    float tilt_[2];        // ObjectSpaceFootprint::tilt
    Parallelogram shape_;  // unless it is a point
    bool is_point_;
};

}  // namespace nacre::sparkle
