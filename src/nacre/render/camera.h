#pragma once

#include <array>
#include <cmath>

#include "nacre/core/vec.h"
#include "nacre/render/scene.h"

namespace nacre::render {

/// Where the rays of the neighbouring pixels run, to first order: how origin and direction change
/// from one pixel to the next across and down the picture. It gives the piece of a surface over
/// which one sample of the picture averages.                                      [igehy-1999]
///
/// It is followed through specular reflections. After any other reflection neighbouring paths have
/// nothing in common, and it is gone.
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

    /// After specular reflection at a hit with these edges.             [igehy-1999, eq. 15]
    /// @param ray_direction  before it
    /// @param normal_change  of the unit normal, from end to end of each edge
    RayDifferential reflected(Vec3f ray_direction, const Edges& edges, Vec3f normal,
                              const std::array<Vec3f, 2>& normal_change) const {
        RayDifferential out;
        const float cosine = dot(ray_direction, normal);
        for (int i = 0; i < 2; ++i) {
            const float change = dot(direction[i], normal) + dot(ray_direction, normal_change[i]);
            out.origin_mm[i] = edges.edge_mm[i];
            out.direction[i] = direction[i] - 2 * (cosine * normal_change[i] + change * normal);
        }
        return out;
    }

    /// Of the directions that a pixel's rays take.
    float solid_angle() const { return length(cross(direction[0], direction[1])); }
};

struct CameraRay {
    Vec3f origin_mm, direction;
    RayDifferential differential;  ///< from pixel to pixel
    float lens_radius_mm = 0;
    Vec2f lens_mm{};     ///< where it leaves the lens, from the middle to the right and down
    float focus_mm = 1;  ///< along the ray, to the plane of focus

    /// Side of the square as large as the disc that the lens spreads a point of the picture over,
    /// at a distance along the ray and across it.
    float blur_mm(float distance_mm) const {
        constexpr float kSideOfDisc = 1.7724539f;  // sqrt(pi)
        return kSideOfDisc * lens_radius_mm * std::abs(distance_mm - focus_mm) / focus_mm;
    }
    /// From the ray through the middle of the lens to this one there, to the right and down.
    Vec2f lens_shift_mm(float distance_mm) const {
        const float fraction = 1 - distance_mm / focus_mm;
        return {fraction * lens_mm.x, fraction * lens_mm.y};
    }
};

/// Rays of a perspective camera for a picture of a given size.
class CameraRays {
 public:
    CameraRays(const Camera& camera, int width, int height);

    /// The ray through (x, y) in pixels from the top left, from the point of the lens that `lens`
    /// in [0, 1)^2 picks. All rays to one point of the plane of focus meet there.
    CameraRay operator()(float x, float y, Vec2f lens) const;

 private:
    Vec3f position_mm_;
    Vec3f corner_, per_x_, per_y_;  // a point of the picture on the plane at distance 1
    Vec3f right_, up_;
    float aperture_radius_mm_, focus_distance_mm_;
};

}  // namespace nacre::render
