#include "nacre/render/turntable.h"

#include <cmath>
#include <map>
#include <variant>

#include "nacre/core/error.h"
#include "nacre/core/math.h"

namespace nacre::render {

namespace {

const std::map<Turning, std::string> kNames{
    {Turning::shape, "shape"}, {Turning::camera, "camera"}, {Turning::light, "light"}};

class Turn {
 public:
    Turn(Vec3f pivot_mm, double angle_deg)
        : pivot_mm_(pivot_mm),
          angle_deg_(angle_deg),
          cos_(static_cast<float>(std::cos(kDegree * angle_deg))),
          sin_(static_cast<float>(std::sin(kDegree * angle_deg))) {}

    Vec3f direction(Vec3f v) const {
        return {cos_ * v.x - sin_ * v.y, sin_ * v.x + cos_ * v.y, v.z};
    }
    Vec3f place(Vec3f p) const { return pivot_mm_ + direction(p - pivot_mm_); }

    void apply(Transform& transform) const {
        transform.translation_mm = place(transform.translation_mm);
        // About z comes last.
        transform.rotation_deg.z = static_cast<float>(turned_angle(transform.rotation_deg.z));
    }
    void apply(Camera& camera) const {
        camera.position_mm = place(camera.position_mm);
        camera.up = direction(camera.up);
    }
    void operator()(RectangleLight& light) const {
        light.center_mm = place(light.center_mm);
        light.target_mm = place(light.target_mm);
        light.up = direction(light.up);
    }
    void operator()(DirectionalLight& light) const { light.to_light = direction(light.to_light); }

    /// @return whether the environment differs by direction
    bool operator()(ConstantEnvironment&) const { return false; }
    bool operator()(StudioEnvironment& studio) const {
        if (studio.boxes.empty()) studio.boxes = studio_soft_boxes();
        for (SoftBox& box : studio.boxes) box.azimuth_deg = turned_angle(box.azimuth_deg);
        return true;
    }
    bool operator()(SkyEnvironment& sky) const {
        sky.sun_azimuth_deg = turned_angle(sky.sun_azimuth_deg);
        return true;
    }
    bool operator()(ImageEnvironment& image) const {
        image.azimuth_deg = turned_angle(image.azimuth_deg);
        return true;
    }

 private:
    /// In [-180, 180], which scenes allow.
    double turned_angle(double angle_deg) const {
        return std::remainder(angle_deg + angle_deg_, 360);
    }

    Vec3f pivot_mm_;
    double angle_deg_;
    float cos_, sin_;
};

}  // namespace

Turning turning_called(const std::string& name) {
    for (const auto& [turning, called] : kNames) {
        if (called == name) return turning;
    }
    throw DomainError("turntable = " + name + ": must be one of shape, camera, light");
}

SceneDescription turned(SceneDescription scene, Turning what, double angle_deg) {
    const Turn turn(scene.camera.target_mm, angle_deg);
    bool any = false;
    switch (what) {
        case Turning::camera:
            turn.apply(scene.camera);
            any = true;
            break;
        case Turning::shape:
            for (Shape& shape : scene.shapes) {
                const auto material = scene.materials.find(shape.material);
                if (material == scene.materials.end() ||
                    !std::holds_alternative<PaintMaterial>(material->second)) {
                    continue;
                }
                turn.apply(shape.transform);
                any = true;
            }
            break;
        case Turning::light:
            any = !scene.lights.empty();
            for (Light& light : scene.lights) std::visit(turn, light);
            if (scene.environment) any = std::visit(turn, *scene.environment) || any;
            break;
    }
    if (!any) {
        throw DomainError(what == Turning::shape
                              ? "the scene has no painted shape that could turn"
                              : "the scene has no light that could turn: no lights, and an "
                                "environment that is the same in all directions");
    }
    scene.turned_deg[kNames.at(what)] += angle_deg;
    return scene;
}

}  // namespace nacre::render
