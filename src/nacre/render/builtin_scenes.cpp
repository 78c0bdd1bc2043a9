#include "nacre/render/builtin_scenes.h"

#include <fmt/format.h>

#include <functional>
#include <map>

#include "nacre/core/error.h"
#include "nacre/core/suggest.h"

namespace nacre::render {
namespace {

SceneDescription with_paint() {
    SceneDescription scene;
    scene.materials["paint"] = PaintMaterial{};
    scene.environment = StudioEnvironment{};
    return scene;
}

/// A ball of paint against the studio's gradient. A long lens: the ball covers 65 % of a square
/// picture, and all angles from face on to grazing lie side by side on it.
SceneDescription sphere_scene() {
    SceneDescription scene = with_paint();
    scene.shapes.push_back({Sphere{.radius_mm = 50}, "paint", {}});
    scene.camera = {
        .position_mm = {0, -588, 118}, .target_mm = {0, 0, 0}, .vertical_fov_deg = 10.5};
    return scene;
}

void add_backdrop(SceneDescription& scene) {
    scene.materials["backdrop"] = DiffuseMaterial{0.35};
    scene.shapes.push_back({Backdrop{}, "backdrop", {}});
}

/// A test panel leaning back on the studio floor.
SceneDescription panel_scene() {
    SceneDescription scene = with_paint();
    add_backdrop(scene);
    scene.shapes.push_back({FlatPanel{.width_mm = 150, .height_mm = 105},
                            "paint",
                            {.rotation_deg = {60, 0, 0}, .translation_mm = {0, 0, 47}}});
    scene.camera = {
        .position_mm = {0, -640, 190}, .target_mm = {0, 0, 47}, .vertical_fov_deg = 15.5};
    return scene;
}

/// A panel bent about the vertical, standing on the floor.
SceneDescription curved_panel_scene() {
    SceneDescription scene = with_paint();
    add_backdrop(scene);
    scene.shapes.push_back({CurvedPanel{.width_mm = 170, .height_mm = 110, .bend_radius_mm = 62},
                            "paint",
                            {.rotation_deg = {90, 0, 0}, .translation_mm = {0, -20, 55}}});
    scene.camera = {.position_mm = {0, -640, 160}, .target_mm = {0, 0, 52}, .vertical_fov_deg = 13};
    return scene;
}

SceneDescription speed_shape_scene() {
    SceneDescription scene = with_paint();
    add_backdrop(scene);
    scene.shapes.push_back({SpeedShape{}, "paint", {.rotation_deg = {0, 0, -38}}});
    scene.camera = {
        .position_mm = {0, -1250, 420}, .target_mm = {0, 0, 40}, .vertical_fov_deg = 17};
    return scene;
}

const std::map<std::string, SceneDescription (*)()>& builders() {
    static const std::map<std::string, SceneDescription (*)()> kBuilders{
        {"sphere", sphere_scene},
        {"panel", panel_scene},
        {"curved-panel", curved_panel_scene},
        {"speed-shape", speed_shape_scene}};
    return kBuilders;
}

}  // namespace

std::vector<std::string> builtin_scene_names() {
    std::vector<std::string> names;
    for (const auto& [name, build] : builders()) names.push_back(name);
    return names;
}

SceneDescription builtin_scene(const std::string& name) {
    const auto found = builders().find(name);
    if (found == builders().end()) {
        std::string all;
        for (const auto& known : builtin_scene_names()) all += (all.empty() ? "" : ", ") + known;
        throw InputError(fmt::format("there is no built-in scene '{}'{}; there are: {}", name,
                                     did_you_mean(name, builtin_scene_names()), all));
    }
    SceneDescription scene = found->second();
    scene.name = name;
    return scene;
}

}  // namespace nacre::render
