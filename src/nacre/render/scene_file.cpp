#include "nacre/render/scene_file.h"

#include <fmt/format.h>

#include <limits>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/image.h"
#include "nacre/io/table_reader.h"

// The ranges of numbers are those of render::validate(), which is asked at the end; here they are
// only finite.

namespace nacre::render {

namespace {

constexpr std::size_t kMaxShapes = 10'000;
constexpr std::size_t kMaxLights = 1'000;
constexpr std::size_t kMaxMaterials = 1'000;
constexpr std::size_t kMaxSoftBoxes = 100;
constexpr std::size_t kMaxNameLength = 200;
constexpr std::size_t kMaxPathLength = 2'000;
/// 16384 x 8192 pixels: what an environment may have.
constexpr std::size_t kMaxEnvironmentValues = std::size_t{3} << 27;

constexpr Range finite(const char* unit) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {-kInfinity, kInfinity, unit, true, true};
}
constexpr Range kMillimetres = finite("mm"), kDegrees = finite("deg"), kNumber = finite("");

using Keys = io::TableReader::Keys;

Keys operator+(Keys a, const Keys& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Vec3f vector_or(const io::TableReader& table, std::string_view key, Vec3f fallback,
                const Range& range) {
    if (!table.has(key)) return fallback;
    const std::vector<double> v = table.numbers(key, range, 3, 3);
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

std::filesystem::path path_in(const io::TableReader& table, std::string_view key) {
    return table.document().base_directory() / table.text(key, kMaxPathLength);
}

const Keys kEmitterKeys = {"illuminant", "scale"};

render::Emitter read_emitter(const io::TableReader& table) {
    render::Emitter emitter;
    if (table.has("illuminant")) {
        try {
            emitter.illuminant =
                spectra::parse_illuminant(table.text("illuminant", kMaxNameLength));
        } catch (const InputError& error) {
            table.fail("illuminant", error.what());
        }
    }
    emitter.scale = table.number_or("scale", emitter.scale, kNumber);
    return emitter;
}

render::Camera read_camera(const io::TableReader& table) {
    render::Camera c;
    c.position_mm = vector_or(table, "position_mm", c.position_mm, kMillimetres);
    c.target_mm = vector_or(table, "target_mm", c.target_mm, kMillimetres);
    c.up = vector_or(table, "up", c.up, kNumber);
    c.vertical_fov_deg = table.number_or("vertical_fov_deg", c.vertical_fov_deg, kDegrees);
    c.aperture_radius_mm =
        table.number_or("aperture_radius_mm", c.aperture_radius_mm, kMillimetres);
    c.focus_distance_mm = table.number_or("focus_distance_mm", c.focus_distance_mm, kMillimetres);
    return c;
}

// ------------------------------------------------------------------------------- materials

render::MaterialDescription read_material(const io::TableReader& any) {
    if (any.choice("type", {"diffuse", "paint"}) == 0) {
        const io::TableReader table = any.narrowed({"type", "reflectance"});
        return render::DiffuseMaterial{read_reflectance(table, "reflectance")};
    }
    const io::TableReader table = any.narrowed({"type", "recipe"});
    render::PaintMaterial paint;  // without a recipe: the slot for --paint
    if (table.has("recipe")) paint.recipe = path_in(table, "recipe");
    return paint;
}

// ---------------------------------------------------------------------------------- shapes

// Each reads what its kind of geometry has; the keys come first.
const Keys kShapeKeys = {"type", "material", "scale", "rotation_deg", "translation_mm"};

render::Geometry read_sphere(const io::TableReader& any) {
    const io::TableReader table = any.narrowed(kShapeKeys + Keys{"radius_mm"});
    render::Sphere sphere;
    sphere.radius_mm = table.number_or("radius_mm", sphere.radius_mm, kMillimetres);
    return sphere;
}

render::Geometry read_mesh(const io::TableReader& any) {
    const io::TableReader table =
        any.narrowed(kShapeKeys + Keys{"path", "mm_per_unit", "y_up", "crease_angle_deg"});
    render::MeshFile mesh;
    mesh.path = path_in(table, "path");
    mesh.mm_per_unit = table.number_or("mm_per_unit", mesh.mm_per_unit, kMillimetres);
    mesh.y_up = table.flag_or("y_up", mesh.y_up);
    mesh.crease_angle_deg = table.number_or("crease_angle_deg", mesh.crease_angle_deg, kDegrees);
    return mesh;
}

render::Geometry read_flat_panel(const io::TableReader& any) {
    const io::TableReader table = any.narrowed(kShapeKeys + Keys{"width_mm", "height_mm"});
    render::FlatPanel panel;
    panel.width_mm = table.number_or("width_mm", panel.width_mm, kMillimetres);
    panel.height_mm = table.number_or("height_mm", panel.height_mm, kMillimetres);
    return panel;
}

render::Geometry read_curved_panel(const io::TableReader& any) {
    const io::TableReader table =
        any.narrowed(kShapeKeys + Keys{"width_mm", "height_mm", "bend_radius_mm"});
    render::CurvedPanel panel;
    panel.width_mm = table.number_or("width_mm", panel.width_mm, kMillimetres);
    panel.height_mm = table.number_or("height_mm", panel.height_mm, kMillimetres);
    panel.bend_radius_mm = table.number_or("bend_radius_mm", panel.bend_radius_mm, kMillimetres);
    return panel;
}

render::Geometry read_speed_shape(const io::TableReader& any) {
    const io::TableReader table = any.narrowed(kShapeKeys + Keys{"length_mm"});
    render::SpeedShape shape;
    shape.length_mm = table.number_or("length_mm", shape.length_mm, kMillimetres);
    return shape;
}

render::Geometry read_backdrop(const io::TableReader& any) {
    const io::TableReader table =
        any.narrowed(kShapeKeys + Keys{"width_mm", "depth_mm", "height_mm", "fillet_radius_mm"});
    render::Backdrop backdrop;
    backdrop.width_mm = table.number_or("width_mm", backdrop.width_mm, kMillimetres);
    backdrop.depth_mm = table.number_or("depth_mm", backdrop.depth_mm, kMillimetres);
    backdrop.height_mm = table.number_or("height_mm", backdrop.height_mm, kMillimetres);
    backdrop.fillet_radius_mm =
        table.number_or("fillet_radius_mm", backdrop.fillet_radius_mm, kMillimetres);
    return backdrop;
}

render::Geometry read_ground(const io::TableReader& any) {
    const io::TableReader table = any.narrowed(kShapeKeys + Keys{"size_mm"});
    render::GroundPlane ground;
    ground.size_mm = table.number_or("size_mm", ground.size_mm, kMillimetres);
    return ground;
}

render::Shape read_shape(const io::TableReader& table) {
    using Reader = render::Geometry (*)(const io::TableReader&);
    constexpr Reader kReaders[] = {read_sphere,       read_mesh,        read_flat_panel,
                                   read_curved_panel, read_speed_shape, read_backdrop,
                                   read_ground};
    render::Shape shape;
    shape.geometry = kReaders[table.choice("type", {"sphere", "mesh", "flat-panel", "curved-panel",
                                                    "speed-shape", "backdrop", "ground"})](table);
    shape.material = table.text("material", kMaxNameLength);
    shape.transform.scale = table.number_or("scale", 1, kNumber);
    shape.transform.rotation_deg = vector_or(table, "rotation_deg", {}, kDegrees);
    shape.transform.translation_mm = vector_or(table, "translation_mm", {}, kMillimetres);
    return shape;
}

// ---------------------------------------------------------------------------------- lights

render::Light read_light(const io::TableReader& any) {
    if (any.choice("type", {"rectangle", "directional"}) == 1) {
        const io::TableReader table = any.narrowed(Keys{"type", "to_light"} + kEmitterKeys);
        render::DirectionalLight light;
        light.to_light = vector_or(table, "to_light", light.to_light, kNumber);
        light.irradiance = read_emitter(table);
        return light;
    }
    const io::TableReader table = any.narrowed(
        Keys{"type", "center_mm", "target_mm", "up", "width_mm", "height_mm", "visible"} +
        kEmitterKeys);
    render::RectangleLight light;
    light.center_mm = vector_or(table, "center_mm", light.center_mm, kMillimetres);
    light.target_mm = vector_or(table, "target_mm", light.target_mm, kMillimetres);
    light.up = vector_or(table, "up", light.up, kNumber);
    light.width_mm = table.number_or("width_mm", light.width_mm, kMillimetres);
    light.height_mm = table.number_or("height_mm", light.height_mm, kMillimetres);
    light.visible = table.flag_or("visible", light.visible);
    light.radiance = read_emitter(table);
    return light;
}

// ------------------------------------------------------------------------------ environment

render::Environment read_studio(const io::TableReader& any) {
    const io::TableReader table =
        any.narrowed(Keys{"type", "horizon", "zenith", "boxes"} + kEmitterKeys);
    render::StudioEnvironment studio;
    studio.radiance = read_emitter(table);
    studio.horizon = table.number_or("horizon", studio.horizon, kNumber);
    studio.zenith = table.number_or("zenith", studio.zenith, kNumber);
    for (const io::TableReader& entry : table.tables(
             "boxes", kMaxSoftBoxes,
             {"azimuth_deg", "elevation_deg", "width_deg", "height_deg", "softness", "scale"})) {
        render::SoftBox box;
        box.azimuth_deg = entry.number_or("azimuth_deg", box.azimuth_deg, kDegrees);
        box.elevation_deg = entry.number_or("elevation_deg", box.elevation_deg, kDegrees);
        box.width_deg = entry.number_or("width_deg", box.width_deg, kDegrees);
        box.height_deg = entry.number_or("height_deg", box.height_deg, kDegrees);
        box.softness = entry.number_or("softness", box.softness, kNumber);
        box.scale = entry.number_or("scale", box.scale, kNumber);
        studio.boxes.push_back(box);
    }
    return studio;
}

render::Environment read_sky(const io::TableReader& any) {
    const io::TableReader table =
        any.narrowed({"type", "sun_azimuth_deg", "sun_elevation_deg", "turbidity", "scale"});
    render::SkyEnvironment sky;
    sky.sun_azimuth_deg = table.number_or("sun_azimuth_deg", sky.sun_azimuth_deg, kDegrees);
    sky.sun_elevation_deg = table.number_or("sun_elevation_deg", sky.sun_elevation_deg, kDegrees);
    sky.turbidity = table.number_or("turbidity", sky.turbidity, kNumber);
    sky.scale = table.number_or("scale", sky.scale, kNumber);
    return sky;
}

render::Environment read_image_environment(const io::TableReader& any) {
    const io::TableReader table = any.narrowed({"type", "path", "azimuth_deg", "scale"});
    render::ImageEnvironment environment;
    environment.azimuth_deg = table.number_or("azimuth_deg", environment.azimuth_deg, kDegrees);
    environment.scale = table.number_or("scale", environment.scale, kNumber);
    try {
        const std::filesystem::path path = path_in(table, "path");
        const io::Image image = io::read_image(path, kMaxEnvironmentValues);
        environment.width = image.width;
        environment.height = image.height;
        environment.rgb = interleaved_rgb(image, path.string());
    } catch (const Error& error) {
        table.fail("path", error.what());
    }
    return environment;
}

render::Environment read_environment(const io::TableReader& any) {
    switch (any.choice("type", {"constant", "studio", "sky", "image"})) {
        case 0:
            return render::ConstantEnvironment{
                read_emitter(any.narrowed(Keys{"type"} + kEmitterKeys))};
        case 1:
            return read_studio(any);
        case 2:
            return read_sky(any);
        default:
            return read_image_environment(any);
    }
}

// ----------------------------------------------------------------------------------- scene

render::SceneDescription read_scene_table(const io::TableReader& table) {
    render::SceneDescription scene;
    scene.name = table.text_or("name", "", kMaxNameLength);
    if (const auto camera =
            table.table_if_present("camera", {"position_mm", "target_mm", "up", "vertical_fov_deg",
                                              "aperture_radius_mm", "focus_distance_mm"})) {
        scene.camera = read_camera(*camera);
    }
    if (const auto materials = table.table_if_present("materials", {})) {
        const std::vector<std::string> names = materials->keys();
        if (names.size() > kMaxMaterials) {
            table.fail("materials", fmt::format("has {} entries; at most {} are allowed",
                                                names.size(), kMaxMaterials));
        }
        for (const std::string& name : names) {
            scene.materials.emplace(name, read_material(materials->table(name, {})));
        }
    }
    for (const io::TableReader& shape : table.tables("shapes", kMaxShapes, {})) {
        scene.shapes.push_back(read_shape(shape));
    }
    for (const io::TableReader& light : table.tables("lights", kMaxLights, {})) {
        scene.lights.push_back(read_light(light));
    }
    if (const auto environment = table.table_if_present("environment", {})) {
        scene.environment = read_environment(*environment);
    }
    if (scene.shapes.empty()) {
        table.fail("shapes",
                   fmt::format("is missing; a scene needs 1 to {} tables [[shapes]]", kMaxShapes));
    }
    if (scene.lights.empty() && !scene.environment) {
        table.fail("environment",
                   "is missing; a scene needs an [environment] or at least one of [[lights]]");
    }
    return scene;
}

}  // namespace

render::SceneDescription parse_scene(std::string_view text, const std::string& filename,
                                     const std::filesystem::path& base_directory) {
    io::TomlDocument document(text, filename, base_directory);
    const render::SceneDescription scene = read_scene_table(
        {document, {"name", "camera", "materials", "shapes", "lights", "environment"}});
    try {
        render::validate(scene);
    } catch (const DomainError& error) {
        rethrow_with_location(document, error.what());
    }
    return scene;
}

bool looks_like_scene(std::string_view text, const std::string& filename) {
    const io::TomlDocument document(text, filename, {});
    for (std::string_view key : {"camera", "materials", "shapes", "lights", "environment"}) {
        if (document.root().contains(key)) return true;
    }
    return false;
}

render::SceneDescription read_scene(const std::filesystem::path& path) {
    return parse_scene(read_file(path, io::kMaxTextBytes), path.string(), path.parent_path());
}

}  // namespace nacre::render
