#include "nacre/render/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "nacre/core/error.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/camera.h"
#include "nacre/testing/errors.h"

namespace nacre::render {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

std::string refusal(const std::function<void(SceneDescription&)>& spoil) {
    SceneDescription scene = builtin_scene("panel");
    spoil(scene);
    return message_of<DomainError>([&] { validate(scene); });
}

TEST(SceneDescription, BuiltinScenesAreValidAndListed) {
    ASSERT_EQ(builtin_scene_names().size(), 6u);
    for (const auto& name : builtin_scene_names()) {
        const SceneDescription scene = builtin_scene(name);
        EXPECT_NO_THROW(validate(scene));
        EXPECT_TRUE(std::holds_alternative<PaintMaterial>(scene.materials.at("paint")));
        EXPECT_EQ(scene.name, name);
    }
    EXPECT_THAT(message_of<InputError>([&] { builtin_scene("sphree"); }),
                HasSubstr("did you mean 'sphere'"));
}

TEST(SceneDescription, ErrorsNameKeyValueAndRange) {
    EXPECT_THAT(refusal([](auto& s) { s.camera.vertical_fov_deg = 180; }),
                HasSubstr("camera.vertical_fov_deg = 180 is outside [0.01, 179] deg"));
    EXPECT_THAT(refusal([](auto& s) { s.camera.target_mm = s.camera.position_mm; }),
                HasSubstr("camera.target_mm is the same point as camera.position_mm"));
    EXPECT_THAT(refusal([](auto& s) { s.camera.up = s.camera.target_mm - s.camera.position_mm; }),
                HasSubstr("camera.up is parallel"));
    EXPECT_THAT(
        refusal([](auto& s) { s.shapes[1].material = "pant"; }),
        HasSubstr("shapes[1].material = 'pant' is not among the materials: backdrop, paint"));
    EXPECT_THAT(refusal([](auto& s) { s.shapes[0].geometry = Sphere{0}; }),
                HasSubstr("shapes[0].radius_mm = 0 is outside (0"));
    EXPECT_THAT(refusal([](auto& s) {
                    s.shapes[0].geometry = CurvedPanel{200, 100, 30};
                }),
                HasSubstr("shapes[0].bend_radius_mm = 30"));
    EXPECT_THAT(refusal([](auto& s) {
                    s.shapes[0].geometry = Backdrop{100, 50, 80, 60};
                }),
                HasSubstr("shapes[0].fillet_radius_mm = 60 is outside (0, 50] mm"));
    EXPECT_THAT(refusal([](auto& s) { s.materials["backdrop"] = DiffuseMaterial{1.2}; }),
                HasSubstr("materials.backdrop.reflectance = 1.2"));
    EXPECT_THAT(refusal([](auto& s) {
                    s.shapes[0].transform.translation_mm.y =
                        std::numeric_limits<float>::quiet_NaN();
                }),
                HasSubstr("shapes[0].translation_mm = nan"));
    EXPECT_THAT(refusal([](auto& s) { s.lights = {RectangleLight{.width_mm = -1}}; }),
                HasSubstr("lights[0].width_mm = -1"));
    EXPECT_THAT(refusal([](auto& s) {
                    s.lights = {DirectionalLight{.to_light = {0, 0, 0}}};
                }),
                HasSubstr("lights[0].to_light has no length"));
    EXPECT_THAT(refusal([](auto& s) { s.environment = SkyEnvironment{.turbidity = 1}; }),
                HasSubstr("environment.turbidity = 1 is outside [1.7, 10]"));
    EXPECT_THAT(refusal([](auto& s) {
                    s.environment = ImageEnvironment{2, 1, {0, 0, 0}};
                }),
                HasSubstr("environment.rgb has 3 values, not 3 x 2 x 1"));
    EXPECT_THAT(refusal([](auto& s) {
                    s.environment = ImageEnvironment{2, 1, {0, 0, 0, 0, -1, 0}};
                }),
                HasSubstr("column 1, row 0"));
    EXPECT_THAT(
        refusal([](auto& s) { s.environment = StudioEnvironment{.boxes = {{.softness = 2}}}; }),
        HasSubstr("environment.boxes[0].softness = 2 is outside [0, 1]"));
}

TEST(SceneDescription, PaintWithoutASurfaceIsRefused) {
    EXPECT_THAT(message_of<DomainError>([&] { Scene(builtin_scene("sphere"), {}); }),
                HasSubstr("materials.paint"));
}

TEST(CameraRays, PictureMiddleIsTheTargetAndTopIsUp) {
    const Camera camera{
        .position_mm = {10, -100, 20}, .target_mm = {10, 0, 20}, .vertical_fov_deg = 90};
    const CameraRays rays(camera, 40, 20);
    const CameraRay middle = rays(20, 10, {0.5f, 0.5f});
    EXPECT_NEAR(middle.direction.y, 1, 1e-6);
    const CameraRay top = rays(20, 0, {0.5f, 0.5f});
    EXPECT_NEAR(top.direction.z, std::sqrt(0.5), 1e-6);
    EXPECT_GT(rays(40, 10, {0.5f, 0.5f}).direction.x, 0.5f);  // right is right
}

TEST(CameraRays, ThinLensRaysMeetInThePlaneOfFocus) {
    const Camera camera{.position_mm = {0, -100, 0},
                        .target_mm = {0, 0, 0},
                        .aperture_radius_mm = 8,
                        .focus_distance_mm = 60};
    const CameraRays rays(camera, 10, 10);
    const auto in_focus = [&](Vec2f lens) {
        const CameraRay r = rays(7, 2, lens);
        return r.origin_mm + ((-40 - r.origin_mm.y) / r.direction.y) * r.direction;
    };
    const Vec3f a = in_focus({0.05f, 0.4f}), b = in_focus({0.9f, 0.8f});
    EXPECT_NEAR(length(a - b), 0, 1e-4);
    EXPECT_GT(length(rays(7, 2, {0.05f, 0.4f}).origin_mm - rays(7, 2, {0.9f, 0.8f}).origin_mm), 5);
}

}  // namespace
}  // namespace nacre::render
