#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "nacre/sparkle/disc_overlap.h"
#include "nacre/sparkle/rest_patch.h"

namespace nacre::sparkle {

/// A patch in its own plane, x along its tangent and the origin in its middle: which discs touch it
/// and how much of it they cover.
class PatchOutline {
 public:
    /// @param smallest_radius_mm, largest_radius_mm  of the discs
    PatchOutline(const RestPatch& patch, float smallest_radius_mm, float largest_radius_mm)
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
        const float least_width = 1e-3f * smallest_radius_mm;
        const int longer = size_mm[1] > size_mm[0];
        if (!is_point_ && std::abs(area()) < least_width * size_mm[longer]) {
            const float thin = least_width / size_mm[longer];
            edge_[1 - longer] = {-edge_[longer].y * thin, edge_[longer].x * thin};
            size_mm[1 - longer] = least_width;
        }
        if (area() < 0) {
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
        const FloatLanes a_most = strip[0].half_width_mm + radius_mm - reach_mm;
        const FloatLanes b_most = strip[1].half_width_mm + radius_mm - reach_mm;
        return (a * a < a_most * a_most) & (b * b < b_most * b_most);
    }

    /// The share of the patch that a disc about (x, y) covers.
    FloatLanes coverage(FloatLanes x, FloatLanes y, FloatLanes radius_mm) const {
        if (is_point_) {
            const FloatLanes distance = sqrt_lanes(x * x + y * y);
            const FloatLanes safe = max_lanes(distance, splat(1e-20f));
            FloatLanes width = splat(1e-20f);  // of the patch towards the disc's middle
            for (const Vec2f& e : edge_) {
                const FloatLanes along = e.x * x + e.y * y;
                width += (along < 0.0f ? -along : along) / safe;
            }
            const FloatLanes share = 0.5f + (radius_mm - distance) / width;
            return min_lanes(max_lanes(share, FloatLanes{}), splat(1.0f));
        }
        return disc_overlap(x, y, radius_mm, shape_) * (1 / shape_.area);
    }

 private:
    static float dot(Vec2f a, Vec2f b) { return a.x * b.x + a.y * b.y; }
    static float dot(Vec3f a, Vec3f b) { return nacre::dot(a, b); }
    static float length(Vec2f a) { return std::sqrt(dot(a, a)); }
    float area() const { return edge_[0].x * edge_[1].y - edge_[0].y * edge_[1].x; }

    Vec2f edge_[2];        // anticlockwise
    Parallelogram shape_;  // unless it is a point
    bool is_point_;
};

}  // namespace nacre::sparkle
