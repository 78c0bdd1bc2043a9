#include "apps/studio/messages/stage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "nacre/core/text.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/environment.h"
#include "nacre/render/turntable.h"

namespace nacre::studio {

namespace {

using render::Emitter;
using render::SceneDescription;
using spectra::Illuminant;

struct ShapeEntry {
    const char* name;
    const char* title;
    const char* scene;  ///< the built-in scene whose painted shape and camera it has
    const char* light;  ///< that suits it
};
constexpr ShapeEntry kShapes[] = {
    {"ball", "Ball of 100 mm", "sphere", "studio"},
    {"panel", "Flat panel of 150 x 105 mm", "panel", "studio"},
    {"curved-panel", "Bent panel of 170 x 110 mm", "curved-panel", "studio"},
    {"speed-shape", "Free-form body of 400 mm", "speed-shape", "studio"},
    {"macro", "Two millimetres of a panel", "macro", "microscope"}};

void light_studio(SceneDescription& scene) { scene.environment = render::StudioEnvironment{}; }

/// A white panel that faces the sun is about white.
void light_sun(SceneDescription& scene) {
    scene.environment =
        render::SkyEnvironment{.sun_azimuth_deg = -120, .sun_elevation_deg = 45, .scale = 0.3};
}

/// Three times as bright in the zenith as at the horizon, as overcast skies are, by the power of D65.
void light_overcast(SceneDescription& scene) {
    scene.environment = render::StudioEnvironment{
        .horizon = 0.45, .zenith = 1.35, .boxes = {{.width_deg = 1, .height_deg = 1, .scale = 0}}};
}

/// A lamp of 800 x 600 mm above the paint, and grey walls that send back a fifth of its light.
void light_booth(SceneDescription& scene, Illuminant illuminant) {
    scene.environment = render::ConstantEnvironment{Emitter{illuminant, 0.2}};
    scene.lights.push_back(render::RectangleLight{.center_mm = {0, -100, 700},
                                                  .target_mm = {0, 0, 0},
                                                  .width_mm = 800,
                                                  .height_mm = 600,
                                                  .radiance = {illuminant, 2.5}});
}
void light_booth_d65(SceneDescription& scene) { light_booth(scene, Illuminant::D65); }
void light_booth_a(SceneDescription& scene) { light_booth(scene, Illuminant::A); }
void light_booth_fl11(SceneDescription& scene) { light_booth(scene, Illuminant::FL11); }

void light_microscope(SceneDescription& scene) {
    const SceneDescription macro = render::builtin_scene("macro");
    scene.environment = macro.environment;
    scene.lights = macro.lights;
}

struct LightEntry {
    const char* name;
    const char* title;
    void (*add)(SceneDescription& scene);
};
constexpr LightEntry kLights[] = {{"studio", "Studio, soft boxes of daylight", light_studio},
                                  {"sun", "Sun and clear sky", light_sun},
                                  {"overcast", "Overcast sky", light_overcast},
                                  {"booth-d65", "Light booth, D65", light_booth_d65},
                                  {"booth-a", "Light booth, A", light_booth_a},
                                  {"booth-fl11", "Light booth, FL11", light_booth_fl11},
                                  {"microscope", "Microscope's lamp", light_microscope}};

template <class Entry, std::size_t n>
std::vector<std::string> names_of(const Entry (&entries)[n]) {
    std::vector<std::string> names;
    for (const Entry& entry : entries) names.emplace_back(entry.name);
    return names;
}

template <class Entry, std::size_t n>
const Entry& find_entry(const Entry (&entries)[n], const char* what, const std::string& name) {
    for (const Entry& entry : entries) {
        if (name == entry.name) return entry;
    }
    const std::vector<std::string> names = names_of(entries);
    throw InputError(fmt::format("{} = \"{}\": there is none of that name{}; there are: {}", what,
                                 excerpt(name), did_you_mean(name, names), fmt::join(names, ", ")));
}

/// The shape alone, and its camera.
SceneDescription bare_scene(const Stage& stage) {
    if (const auto& own = stage.own_shape; own && own->name == stage.shape) {
        SceneDescription scene;
        scene.name = own->name;
        scene.camera = own->camera;
        scene.materials["paint"] = render::PaintMaterial{};
        scene.shapes = {own->shape};
        return scene;
    }
    const std::string& shape = stage.shape;
    SceneDescription scene = render::builtin_scene(find_entry(kShapes, "shape", shape).scene);
    std::erase_if(scene.shapes, [](const render::Shape& s) { return s.material != "paint"; });
    std::erase_if(scene.materials, [](const auto& entry) { return entry.first != "paint"; });
    scene.lights.clear();
    scene.environment.reset();
    scene.name = shape;
    return scene;
}

void require(const char* name, double value, const Range& range) {
    if (range.contains(value)) return;
    throw DomainError(fmt::format("{} = {}: must be in {}", name, value, range.text()));
}

Tree vector_json(Vec3f v) { return {v.x, v.y, v.z}; }

Tree json_of_shape(const SceneDescription& scene, const std::string& name, const std::string& title,
                   const std::string& light) {
    const render::Transform& transform = scene.shapes.at(0).transform;
    const render::Camera& camera = scene.camera;
    Tree shape = {{"name", name},
                  {"title", title},
                  {"light", light},
                  {"transform",
                   {{"scale", transform.scale},
                    {"rotation_deg", vector_json(transform.rotation_deg)},
                    {"translation_mm", vector_json(transform.translation_mm)}}},
                  {"camera",
                   {{"position_mm", vector_json(camera.position_mm)},
                    {"target_mm", vector_json(camera.target_mm)},
                    {"up", vector_json(camera.up)},
                    {"fov_deg", camera.vertical_fov_deg},
                    {"aspect", aspect_of(scene)}}}};
    if (const auto* ball = std::get_if<render::Sphere>(&scene.shapes[0].geometry)) {
        shape["radius_mm"] = ball->radius_mm;
    }
    return shape;
}

}  // namespace

SceneDescription scene_of(const Stage& stage) {
    SceneDescription scene = bare_scene(stage);
    if (const auto& own = stage.own_light; own && own->name == stage.light) {
        scene.environment = own->picture;
    } else {
        find_entry(kLights, "light", stage.light).add(scene);
    }
    scene.name = stage.shape + " in " + stage.light;
    require("turn_deg", stage.turn_deg, kTurn);
    require("light_turn_deg", stage.light_turn_deg, kTurn);
    if (const auto& camera = stage.camera) {
        require("camera.azimuth_deg", camera->azimuth_deg, kTurn);
        require("camera.elevation_deg", camera->elevation_deg, kElevation);
        require("camera.distance_mm", camera->distance_mm, kDistance);
        require("camera.fov_deg", camera->fov_deg, kFieldOfView);
        scene.camera.position_mm =
            scene.camera.target_mm +
            static_cast<float>(camera->distance_mm) *
                render::direction_from_angles(camera->azimuth_deg, camera->elevation_deg);
        scene.camera.vertical_fov_deg = camera->fov_deg;
    }
    scene.specimen = stage.specimen;
    if (stage.turn_deg != 0) {
        scene = render::turned(std::move(scene), render::Turning::shape, stage.turn_deg);
    }
    if (stage.light_turn_deg != 0) {
        scene = render::turned(std::move(scene), render::Turning::light, stage.light_turn_deg);
    }
    return scene;
}

Tree shapes_json() {
    Tree shapes = Tree::array();
    for (const ShapeEntry& entry : kShapes) {
        shapes.push_back(
            json_of_shape(bare_scene({.shape = entry.name}), entry.name, entry.title, entry.light));
    }
    return shapes;
}

Tree shape_json(const OwnShape& own) {
    const Stage stage{.shape = own.name,
                      .own_shape = std::shared_ptr<const OwnShape>(std::shared_ptr<void>(), &own)};
    return json_of_shape(bare_scene(stage), own.name, own.title, "studio");
}

Tree lights_json() {
    Tree lights = Tree::array();
    for (const LightEntry& entry : kLights) {
        lights.push_back({{"name", entry.name},
                          {"title", entry.title},
                          {"illuminant", spectra::name(lamp_of({.light = entry.name}))}});
    }
    return lights;
}

}  // namespace nacre::studio
