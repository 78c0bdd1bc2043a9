#pragma once

#include "nacre/core/vec.h"

namespace nacre::render {

/// Where the rays of the neighbouring pixels run, to first order: how origin and direction change
/// from one pixel to the next across and down the picture. It tells how much of a surface one
/// sample of the picture stands for.                                              [igehy-1999]
///
/// It is followed through mirrors as if they were flat. After any other reflection neighbouring
/// paths have nothing in common, and it is gone.
struct RayDifferential {
    Vec3f origin_mm[2], direction[2];

    /// The edges of the pixel's parallelogram on the tangent plane where the ray hits.
    struct Edges {
        Vec3f edge_mm[2];
    };

    /// @param ray_direction  of the ray, a unit vector
    /// @param distance_mm  from its origin to the hit
    /// @param normal      of the surface there, a unit vector not perpendicular to the ray
    Edges at(Vec3f ray_direction, float distance_mm, Vec3f normal) const {
        Edges edges;
        const float cosine = dot(ray_direction, normal);
        for (int i = 0; i < 2; ++i) {
            const Vec3f across = origin_mm[i] + distance_mm * direction[i];
            edges.edge_mm[i] = across - (dot(across, normal) / cosine) * ray_direction;
        }
        return edges;
    }

    /// After a mirror at a hit with these edges.
    RayDifferential mirrored(const Edges& edges, Vec3f normal) const {
        RayDifferential out;
        for (int i = 0; i < 2; ++i) {
            out.origin_mm[i] = edges.edge_mm[i];
            out.direction[i] = direction[i] - 2 * dot(direction[i], normal) * normal;
        }
        return out;
    }
};

}  // namespace nacre::render
