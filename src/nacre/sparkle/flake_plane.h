#pragma once

#include <cmath>
#include <cstdint>

#include "nacre/sparkle/patch_outline.h"
#include "nacre/sparkle/projection.h"

namespace nacre::sparkle {

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

    FlakePlane(const RestPatch& patch, const PatchOutline& outline, const Projection& projection)
        : side(projection.side) {
        const auto component = [](Vec3f w, int i) { return i == 0 ? w.x : i == 1 ? w.y : w.z; };
        const int axis = side / 2;
        const float across = component(patch.normal, axis), per_across = 1 / across;
        kept = projection.share * std::abs(per_across) * (65536 / kMostStretch);
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
