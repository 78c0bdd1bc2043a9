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
    // The direction is that of a vector `to` which changes by `per_x` and `per_y` from pixel to
    // pixel.
    const auto ray = [](Vec3f origin, Vec3f to, Vec3f per_x, Vec3f per_y) {
        const float scale = 1 / length(to);
        const Vec3f direction = scale * to;
        const auto turn = [&](Vec3f d) { return scale * (d - dot(d, direction) * direction); };
        return CameraRay{.origin_mm = origin,
                         .direction = direction,
                         .differential = {{}, {turn(per_x), turn(per_y)}}};
    };
    if (aperture_radius_mm_ <= 0) return ray(position_mm_, on_plane, per_x_, per_y_);
    const Vec2f disk = bsdf::concentric_disk(lens);
    const Vec3f offset = aperture_radius_mm_ * (disk.x * right_ + disk.y * up_);
    const Vec3f to_focus = focus_distance_mm_ * on_plane - offset;
    CameraRay result = ray(position_mm_ + offset, to_focus, focus_distance_mm_ * per_x_,
                           focus_distance_mm_ * per_y_);
    result.lens_radius_mm = aperture_radius_mm_;
    result.lens_mm = {aperture_radius_mm_ * disk.x, -aperture_radius_mm_ * disk.y};
    result.focus_mm = length(to_focus);
    return result;
}

}  // namespace nacre::render
