#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "nacre/core/vec.h"
#include "nacre/sparkle/patch_outline.h"

// The planes of cells onto which a surface is projected to find the flakes on it.

namespace nacre::sparkle {

/// One of the six sides of the object space's axes, and the fraction of the flakes that it gives.
struct Projection {
    int side;        ///< 2 axis + (1 if the surface faces the negative side)
    float fraction;  ///< of the flakes of the surface; the fractions of a normal add up to 1
};

struct Projections {
    std::array<Projection, 3> list;
    int count = 0;
};

/// Squares of the components of a normal that differ by less divide the flakes between them.
inline constexpr float kProjectionBlend = 0.1f;
/// The largest of (fraction / |component of the normal|): flakes per area of the plane over flakes
/// per area of the surface. It is reached where one side alone serves and two others are about to.
inline constexpr float kMaxStretch = 1.5811388f;  // 1 / sqrt((1 + 2 kProjectionBlend) / 3)

/// The sides that the unit vector n faces. Where it turns from one to the next the fractions change
/// continuously, so that flakes come and go one by one and no border shows.
inline Projections projections_of(Vec3f n) {
    const std::array<float, 3> component = {n.x, n.y, n.z};
    std::array<float, 3> weight;
    float largest = 0, sum = 0;
    for (float c : component) largest = std::max(largest, c * c);
    for (int axis = 0; axis < 3; ++axis) {
        weight[axis] =
            std::max(0.0f, component[axis] * component[axis] - largest + kProjectionBlend);
        sum += weight[axis];
    }
    Projections out;
    for (int axis = 0; axis < 3; ++axis) {
        if (weight[axis] > 0) {
            out.list[out.count++] = {2 * axis + (component[axis] < 0), weight[axis] / sum};
        }
    }
    return out;
}

/// The first and the last cell along an axis that a patch touches.
struct CellRange {
    std::int64_t first, last;
};

/// A plane of cells as a patch sees it.
struct FlakePlane {
    struct Axis {
        double at_mm;   ///< where the middle of the patch is
        float half_mm;  ///< half the extent of the patch with the discs that touch it
        Vec2f step;     ///< what a step along the axis is in the plane of the patch

        CellRange cells(double cells_per_mm) const {
            return {static_cast<std::int64_t>(std::floor((at_mm - half_mm) * cells_per_mm)),
                    static_cast<std::int64_t>(std::floor((at_mm + half_mm) * cells_per_mm))};
        }
    };

    int side;    ///< Projection::side
    float kept;  ///< flakes of the plane whose rank, of 65536, is smaller lie on the surface
    Axis u, v;
    Vec2f turn;  ///< cosine and sine of the angle from the patch's tangent to u
    /// PatchOutline::Strip for places in the plane: |u place_u + v place_v| < half width.
    struct Strip {
        float u, v, half_width2_mm2;
    };
    Strip strip[2];

    FlakePlane(const ObjectSpaceFootprint& patch, const PatchOutline& outline,
               const Projection& projection)
        : side(projection.side) {
        const auto component = [](Vec3f w, int i) { return i == 0 ? w.x : i == 1 ? w.y : w.z; };
        const int axis = side / 2;
        const float across = component(patch.normal, axis), per_across = 1 / across;
        kept = projection.fraction * std::abs(per_across) * (65536 / kMaxStretch);
        const auto make = [&](int i) {
            const float slant = component(patch.normal, i), shear = slant * per_across;
            const Vec3f t = outline.tangent, b = outline.bitangent;
            Axis out;
            out.at_mm = component(patch.position_mm, i);
            out.half_mm = 0.5f * (std::abs(component(patch.edge_mm[0], i)) +
                                  std::abs(component(patch.edge_mm[1], i))) +
                          outline.reach_mm * std::sqrt(std::max(0.0f, 1 - slant * slant));
            out.step = {component(t, i) - shear * component(t, axis),
                        component(b, i) - shear * component(b, axis)};
            return out;
        };
        const int first = (axis + 1) % 3;
        u = make(first);
        v = make((axis + 2) % 3);
        const float x = component(outline.tangent, first), y = component(outline.bitangent, first);
        const float inverse = 1 / std::sqrt(x * x + y * y);
        turn = {x * inverse, y * inverse};
        for (int i = 0; i < 2; ++i) {
            const auto& [n, half_width_mm] = outline.strip[i];
            strip[i] = {n.x * u.step.x + n.y * u.step.y, n.x * v.step.x + n.y * v.step.y,
                        half_width_mm * half_width_mm};
        }
    }
};

}  // namespace nacre::sparkle
