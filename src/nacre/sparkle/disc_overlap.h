#pragma once

#include <array>
#include <numbers>

#include "nacre/core/lane_math.h"
#include "nacre/core/vec.h"

// How much of eight discs lies in a parallelogram.

namespace nacre::sparkle {

inline constexpr double kArctangentLanesError = 3e-7;

/// Arctangent of any number, to kArctangentLanesError.       [abramowitz-stegun-1964, eq. 4.4.49]
inline FloatLanes arctangent_lanes(FloatLanes x) {
    const FloatLanes size = x < 0.0f ? -x : x;
    const FloatLanes t = size > 1.0f ? 1.0f / size : size, t2 = t * t;
    FloatLanes p = splat(0.0028662257f);
    p = p * t2 - 0.0161657367f;
    p = p * t2 + 0.0429096138f;
    p = p * t2 - 0.0752896400f;
    p = p * t2 + 0.1065626393f;
    p = p * t2 - 0.1420889944f;
    p = p * t2 + 0.1999355085f;
    p = p * t2 - 0.3333314528f;
    const FloatLanes inner = t + t * t2 * p;
    const FloatLanes angle = size > 1.0f ? 0.5f * std::numbers::pi_v<float> - inner : inner;
    return x < 0.0f ? -angle : angle;
}

/// Error of disc_overlap(), in areas of the disc.
inline constexpr double kDiscOverlapError = 2e-6;

/// Area that a disc about (x, y) shares with the parallelogram about the origin that two edges of
/// non-zero area span, anticlockwise from edge_1 to edge_2.
///
/// By the angles under which the centre sees the sides: a side at the signed distance d, seen from
/// t_0 to t_1 along it, bounds the area  Int min(r^2, d^2 + t^2)/2 d(angle). The angles add up to
/// a full turn if the centre is inside and to none outside, so only the chords need arctangents.
inline FloatLanes disc_overlap(FloatLanes x, FloatLanes y, FloatLanes radius, Vec2f edge_1,
                               Vec2f edge_2) {
    const float ax = 0.5f * (edge_1.x + edge_2.x), ay = 0.5f * (edge_1.y + edge_2.y);
    const float bx = 0.5f * (edge_2.x - edge_1.x), by = 0.5f * (edge_2.y - edge_1.y);
    const std::array<Vec2f, 4> corners = {Vec2f{-ax, -ay}, Vec2f{-bx, -by}, Vec2f{ax, ay},
                                          Vec2f{bx, by}};
    const FloatLanes radius2 = radius * radius;
    FloatLanes triangles{}, sectors{};
    auto inside = x == x;  // all lanes
    for (int side = 0; side < 4; ++side) {
        const Vec2f from = corners[side], to = corners[(side + 1) & 3];
        const float ux = to.x - from.x, uy = to.y - from.y;
        const float size = std::sqrt(ux * ux + uy * uy), inverse = 1 / size;
        const float cosine = ux * inverse, sine = uy * inverse;
        const FloatLanes px = from.x - x, py = from.y - y;
        const FloatLanes distance = px * sine - py * cosine;
        const FloatLanes t0 = px * cosine + py * sine, t1 = t0 + size;
        const FloatLanes chord = sqrt_lanes(max_lanes(radius2 - distance * distance, FloatLanes{}));
        const FloatLanes c0 = min_lanes(max_lanes(t0, -chord), chord);
        const FloatLanes c1 = min_lanes(max_lanes(t1, -chord), chord);
        // On the side itself counts as inside, with the full angle that goes with it.
        const FloatLanes off = distance == 0.0f ? splat(1e-30f) : distance;
        inside &= off > 0.0f;
        triangles += distance * (c1 - c0);
        sectors += arctangent_lanes(c1 / off) - arctangent_lanes(c0 / off);
    }
    const FloatLanes full = inside ? splat(2 * std::numbers::pi_v<float>) : FloatLanes{};
    return max_lanes(0.5f * (triangles + radius2 * (full - sectors)), FloatLanes{});
}

}  // namespace nacre::sparkle
