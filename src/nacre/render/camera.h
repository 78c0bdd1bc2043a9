#pragma once

#include "nacre/core/vec.h"
#include "nacre/render/ray_differential.h"
#include "nacre/render/scene_description.h"

namespace nacre::render {

struct CameraRay {
    Vec3f origin_mm, direction;
    RayDifferential differential;  ///< from pixel to pixel
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
