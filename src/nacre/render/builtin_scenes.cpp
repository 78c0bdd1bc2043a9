#include "nacre/render/builtin_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "nacre/core/error.h"
#include "nacre/core/text.h"

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
        .position_mm = {0, -1250, 420}, .target_mm = {0, 0, 32}, .vertical_fov_deg = 13.5};
    return scene;
}

/// Two millimetres of a panel under a microscope's lamp, 8 deg wide and so placed that flakes
/// tilted by some 4 deg inside the paint send it to the camera: they are seen as discs, 5 pixels
/// across in 512 for 20 um. The others reflect dim surroundings.
SceneDescription macro_scene() {
    SceneDescription scene = with_paint();
    scene.environment = StudioEnvironment{
        .horizon = 0.1,
        .zenith = 0.2,
        .boxes = {{.azimuth_deg = 20, .elevation_deg = 50, .softness = 1, .scale = 0.8}}};
    scene.shapes.push_back({FlatPanel{.width_mm = 100, .height_mm = 100}, "paint", {}});
    scene.camera = {.position_mm = {0, -17, 36}, .target_mm = {0, 0, 0}, .vertical_fov_deg = 2.88};
    scene.lights.push_back(RectangleLight{.center_mm = {-20, 42, 135},
                                          .target_mm = {0, 0, 0},
                                          .width_mm = 20,
                                          .height_mm = 20,
                                          .radiance = {.scale = 4}});
    return scene;
}

/// A panel held at arm's length in the sun, which stands 11 deg from where the clearcoat would
/// reflect it into the camera. In 512 pixels each is an arc minute, what an eye resolves: 0.17 mm.
SceneDescription panel_sun_scene() {
    SceneDescription scene = with_paint();
    scene.environment =
        SkyEnvironment{.sun_azimuth_deg = -120, .sun_elevation_deg = 45, .scale = 0.15};
    scene.shapes.push_back(
        {FlatPanel{.width_mm = 150, .height_mm = 100}, "paint", {.rotation_deg = {58, 0, 0}}});
    scene.camera = {.position_mm = {0, -575, 172}, .target_mm = {0, 0, 0}, .vertical_fov_deg = 8.5};
    return scene;
}

struct Builtin {
    SceneDescription (*build)();
    const char* caption;
};

const std::map<std::string, Builtin>& all_builtins() {
    static const std::map<std::string, Builtin> kAll{
        {"sphere", {sphere_scene, "Ball of 100 mm, lit by soft boxes of daylight"}},
        {"panel",
         {panel_scene,
          "Panel of 150 x 105 mm, leaning back; soft boxes of daylight, a grey backdrop"}},
        {"curved-panel",
         {curved_panel_scene,
          "Bent panel of 170 x 110 mm on a grey floor, whose front edge it mirrors near its rim; "
          "soft boxes of daylight"}},
        {"speed-shape",
         {speed_shape_scene, "Free-form body on a grey backdrop; soft boxes of daylight"}},
        {"macro", {macro_scene, "Two millimetres of a panel under a microscope's lamp"}},
        {"panel-sun", {panel_sun_scene, "Panel of 150 x 100 mm at arm's length, sun and sky"}}};
    return kAll;
}

const Builtin& find_builtin(const std::string& name) {
    const auto found = all_builtins().find(name);
    if (found != all_builtins().end()) return found->second;
    const std::vector<std::string> names = builtin_scene_names();
    throw InputError(fmt::format("there is no built-in scene '{}'{}; there are: {}", name,
                                 did_you_mean(name, names), fmt::join(names, ", ")));
}

}  // namespace

std::vector<std::string> builtin_scene_names() {
    std::vector<std::string> names;
    for (const auto& [name, builtin] : all_builtins()) names.push_back(name);
    return names;
}

SceneDescription builtin_scene(const std::string& name) {
    SceneDescription scene = find_builtin(name).build();
    scene.name = name;
    return scene;
}

std::string builtin_scene_caption(const std::string& name) { return find_builtin(name).caption; }

}  // namespace nacre::render
