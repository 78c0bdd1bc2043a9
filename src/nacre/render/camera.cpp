#include "nacre/render/camera.h"

#include <cmath>
#include <numbers>

#include "nacre/bsdf/warp.h"

namespace nacre::render {

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : position_mm_(camera.position_mm),
      aperture_radius_mm_(static_cast<float>(camera.aperture_radius_mm)),
      focus_distance_mm_(camera.focus_distance_mm > 0
                             ? static_cast<float>(camera.focus_distance_mm)
                             : length(camera.target_mm - camera.position_mm)) {
    const Vec3f forward = normalize(camera.target_mm - camera.position_mm);
    right_ = normalize(cross(forward, camera.up));
    up_ = cross(right_, forward);
    const double half = std::tan(camera.vertical_fov_deg * std::numbers::pi / 360);
    const auto pixel = static_cast<float>(2 * half / height);
    per_x_ = pixel * right_;
    per_y_ = -pixel * up_;
    corner_ = forward - 0.5f * static_cast<float>(width) * per_x_ -
              0.5f * static_cast<float>(height) * per_y_;
}

CameraRay CameraRays::operator()(float x, float y, Vec2f lens) const {
    const Vec3f on_plane = corner_ + x * per_x_ + y * per_y_;
    if (aperture_radius_mm_ <= 0) return {position_mm_, normalize(on_plane)};
    const Vec2f disk = bsdf::concentric_disk(lens);
    const Vec3f offset = aperture_radius_mm_ * (disk.x * right_ + disk.y * up_);
    return {position_mm_ + offset, normalize(focus_distance_mm_ * on_plane - offset)};
}

}  // namespace nacre::render
