#include "nacre/render/scene_description.h"

#include "nacre/bsdf/model.h"
#include "nacre/paint/limits.h"

namespace nacre::render {

namespace {

using paint::Field;
using paint::kMaxNameLength;
using paint::kMaxPathLength;
using paint::Visitor;

constexpr Range kLength{0, kFar_mm, "mm", true};
constexpr Range kLengthOrZero{0, kFar_mm, "mm"};
constexpr Range kCoordinate{-kFar_mm, kFar_mm, "mm"};
constexpr Range kScale{0, 1e9};
constexpr Range kAnyAngle{-3600, 3600, "deg"};
constexpr Range kDirection{-1e6, 1e6};
constexpr Range kBoxAngle{0, 170, "deg", true};

/// The word that chooses an alternative.
constexpr Field kType{.key = "type", .required = true};

}  // namespace

void describe(Visitor& visit, SceneDescription& scene) {
    visit({.key = "name", .max_size = kMaxNameLength}, scene.name);
    visit(
        {.key = "specimen",
         .range = {0, static_cast<double>(bsdf::kMaxSpecimen)},
         .meaning = "which panel of the batch is seen: models that show single flakes or waves of "
                    "a coat show those of this one, whatever the seed; 0: that of `--specimen`",
         .also = "a whole number"},
        scene.specimen);
    visit.table({.key = "camera", .otherwise = "its defaults"}, paint::Described(scene.camera));
    visit({.key = "materials", .meaning = "by names of your own", .max_size = 1'000},
          scene.materials);
    visit({.key = "shapes", .meaning = "at least one", .max_size = kMaxShapes}, scene.shapes);
    visit({.key = "lights", .meaning = "at least one, or an `environment`", .max_size = 1'000},
          scene.lights);
    visit({.key = "environment", .meaning = "what shines from infinity"}, scene.environment);
}

void describe(Visitor& visit, Camera& camera) {
    visit({.key = "position_mm", .range = kCoordinate}, camera.position_mm);
    visit({.key = "target_mm", .range = kCoordinate, .meaning = "what the camera looks at"},
          camera.target_mm);
    visit({.key = "up", .range = kDirection, .meaning = "not along the line of sight"}, camera.up);
    visit({.key = "vertical_fov_deg",
           .range = {0.01, 179, "deg"},
           .meaning = "full angle from bottom to top"},
          camera.vertical_fov_deg);
    visit({.key = "aperture_radius_mm",
           .range = kLengthOrZero,
           .meaning = "0: a pinhole; above, a thin lens"},
          camera.aperture_radius_mm);
    visit({.key = "focus_distance_mm",
           .range = kLengthOrZero,
           .meaning = "along the line of sight; 0: the target's distance"},
          camera.focus_distance_mm);
}

// ------------------------------------------------------------------------------- materials

void describe(Visitor& visit, MaterialDescription& material) {
    visit(kType, {"diffuse", "paint", "diffuse-picture", "conductor", "glass", "plastic"},
          material);
    visit.held(material);
}

void describe(Visitor& visit, DiffuseMaterial& material) {
    visit({.key = "reflectance",
           .range = {0, 1},
           .meaning = "a number, a colour or a spectrum, as in a recipe",
           .required = true,
           .colour = true},
          material.reflectance);
}

void describe(Visitor& visit, PaintMaterial& material) {
    visit({.key = "recipe",
           .meaning = "of a recipe, a solved paint or a [measured BRDF](measured.md); without it, "
                      "the paint that `--paint` names",
           .max_size = kMaxPathLength},
          material.recipe);
}

void describe(Visitor& visit, DiffusePictureMaterial&) {
    std::filesystem::path path;  // the material has the picture, not its path
    visit({.key = "path",
           .meaning = "a picture of reflectances: PNG, EXR or HDR, values up to 1",
           .required = true,
           .max_size = kMaxPathLength},
          path);
}

namespace {

constexpr Range kAbsorption{0, 1e6, "1/mm"};
constexpr Range kRealIndex{1, 3};

void describe_roughness(Visitor& visit, double& roughness) {
    visit({.key = "roughness",
           .range = paint::limits::kMicrofacetAlpha,
           .meaning = "alpha of GGX; 0: a smooth face",
           .zero = "a smooth face"},
          roughness);
}

void describe_index(Visitor& visit, optics::Material& index) {
    visit({.key = "index",
           .range = kRealIndex,
           .meaning = "a number, a material that ships or a file of one; that at 550 nm counts",
           .real = true},
          index);
}

}  // namespace

void describe(Visitor& visit, ConductorMaterial& material) {
    visit({.key = "metal",
           .range = optics::kRefractiveIndexRange,
           .meaning = "a metal that ships (`nacre materials`): `Cr`, `Al`, `Au`, `Ag`, `Cu`, "
                      "`brass_Cu70Zn30`; an index such as `\"1.2+7i\"`; a file of one",
           .required = true},
          material.metal);
    describe_roughness(visit, material.roughness);
}

void describe(Visitor& visit, GlassMaterial& material) {
    describe_index(visit, material.index);
    describe_roughness(visit, material.roughness);
    visit({.key = "pane_mm",
           .range = {0, 1e6, "mm", true},
           .meaning = "0: the shape encloses a solid of glass; above: the shape is a pane of this "
                      "thickness, as of a window, which is smooth",
           .zero = "the shape encloses a solid"},
          material.pane_mm);
    visit({.key = "absorption_per_mm", .range = kAbsorption}, material.absorption_per_mm);
}

void describe(Visitor& visit, PlasticMaterial& material) {
    visit({.key = "reflectance",
           .range = {0, 1},
           .meaning = "of the body in its binder, without the face: a number, a colour or a "
                      "spectrum",
           .required = true,
           .colour = true},
          material.reflectance);
    describe_index(visit, material.index);
    describe_roughness(visit, material.roughness);
}

// ---------------------------------------------------------------------------------- shapes

void describe(Visitor& visit, Shape& shape) {
    visit(kType,
          {"sphere", "mesh", "flat-panel", "curved-panel", "speed-shape", "backdrop", "ground"},
          shape.geometry);
    visit({.key = "material",
           .meaning = "one of `[materials]`",
           .required = true,
           .max_size = kMaxNameLength},
          shape.material);
    visit({.key = "scale", .range = {0, 1e6, "", true}}, shape.transform.scale);
    visit({.key = "rotation_deg", .range = kAnyAngle, .meaning = "about x, then y, then z"},
          shape.transform.rotation_deg);
    visit({.key = "translation_mm", .range = kCoordinate, .meaning = "after scale and rotation"},
          shape.transform.translation_mm);
    visit.held(shape.geometry);
}

void describe(Visitor& visit, Sphere& sphere) {
    visit({.key = "radius_mm", .range = kLength}, sphere.radius_mm);
}

void describe(Visitor& visit, MeshFile& mesh) {
    visit({.key = "path",
           .meaning = "OBJ, PLY, glTF or STL",
           .required = true,
           .max_size = kMaxPathLength},
          mesh.path);
    visit({.key = "mm_per_unit",
           .range = {0, 1e9, "mm", true},
           .meaning = "0: 1000 for glTF, which counts in metres, and 1 for the others",
           .zero = "1000 for glTF and 1 for the others"},
          mesh.mm_per_unit);
    visit({.key = "y_up", .meaning = "the file's vertical is y, as in glTF"}, mesh.y_up);
    visit({.key = "crease_angle_deg",
           .range = {0, 180, "deg"},
           .meaning = "where the file has no normals, they are made smooth below it"},
          mesh.crease_angle_deg);
    visit({.key = "part",
           .meaning = "only the triangles of the file's material of this name (`usemtl`, or a "
                      "glTF's materials); empty: all",
           .max_size = kMaxNameLength},
          mesh.part);
}

void describe(Visitor& visit, FlatPanel& panel) {
    visit({.key = "width_mm", .range = kLength, .meaning = "along x"}, panel.width_mm);
    visit({.key = "height_mm", .range = kLength, .meaning = "along y"}, panel.height_mm);
}

void describe(Visitor& visit, CurvedPanel& panel) {
    visit({.key = "width_mm", .range = kLength, .meaning = "length of the arc along x"},
          panel.width_mm);
    visit({.key = "height_mm", .range = kLength, .meaning = "along y"}, panel.height_mm);
    visit({.key = "bend_radius_mm", .range = kLength, .also = "at least width / (2 pi)"},
          panel.bend_radius_mm);
}

void describe(Visitor& visit, SpeedShape& shape) {
    visit({.key = "length_mm", .range = kLength, .meaning = "along x"}, shape.length_mm);
}

void describe(Visitor& visit, Backdrop& backdrop) {
    visit({.key = "width_mm", .range = kLength, .meaning = "along x"}, backdrop.width_mm);
    visit({.key = "depth_mm", .range = kLength, .meaning = "of the floor, before and behind"},
          backdrop.depth_mm);
    visit({.key = "height_mm", .range = kLength, .meaning = "of the wall"}, backdrop.height_mm);
    visit(
        {.key = "fillet_radius_mm", .range = kLength, .also = "at most `depth_mm` and `height_mm`"},
        backdrop.fillet_radius_mm);
}

void describe(Visitor& visit, GroundPlane& ground) {
    visit({.key = "size_mm", .range = kLength}, ground.size_mm);
}

// ---------------------------------------------------------------------------------- lights

namespace {

void describe(Visitor& visit, Emitter& emitter, const char* meaning) {
    static const paint::Choices illuminants = {
        name(spectra::Illuminant::A),    name(spectra::Illuminant::D50),
        name(spectra::Illuminant::D65),  name(spectra::Illuminant::FL2),
        name(spectra::Illuminant::FL11), name(spectra::Illuminant::E)};
    visit({.key = "illuminant"}, illuminants, emitter.illuminant);
    visit({.key = "scale", .range = kScale, .meaning = meaning}, emitter.scale);
}

}  // namespace

void describe(Visitor& visit, Light& light) {
    visit(kType, {"rectangle", "directional"}, light);
    visit.held(light);
}

void describe(Visitor& visit, RectangleLight& light) {
    visit({.key = "center_mm", .range = kCoordinate}, light.center_mm);
    visit({.key = "target_mm", .range = kCoordinate, .meaning = "it shines towards it"},
          light.target_mm);
    visit({.key = "up",
           .range = kDirection,
           .meaning = "the direction of `height_mm`; not towards the target"},
          light.up);
    visit({.key = "width_mm", .range = kLength}, light.width_mm);
    visit({.key = "height_mm", .range = kLength}, light.height_mm);
    visit({.key = "visible",
           .meaning = "to the camera and in the specular reflection of a clearcoat"},
          light.visible);
    describe(visit, light.radiance, "luminance of the light itself");
}

void describe(Visitor& visit, DirectionalLight& light) {
    visit({.key = "to_light", .range = kDirection}, light.to_light);
    describe(visit, light.irradiance,
             "a perfect diffuser that faces the light has luminance `scale` / pi");
}

// ------------------------------------------------------------------------------ environment

void describe(Visitor& visit, Environment& environment) {
    visit(kType, {"constant", "studio", "sky", "image"}, environment);
    visit.held(environment);
}

void describe(Visitor& visit, ConstantEnvironment& environment) {
    describe(visit, environment.radiance, "luminance, the same from everywhere");
}

void describe(Visitor& visit, StudioEnvironment& environment) {
    visit({.key = "horizon",
           .range = kScale,
           .meaning = "luminance at and below the horizon, times `scale`"},
          environment.horizon);
    visit({.key = "zenith", .range = kScale, .meaning = "luminance above, times `scale`"},
          environment.zenith);
    visit({.key = "boxes",
           .meaning = "soft boxes at infinity",
           .otherwise = "four built-in ones",
           .max_size = 100},
          environment.boxes);
    describe(visit, environment.radiance, "of all luminances");
}

void describe(Visitor& visit, SoftBox& box) {
    visit({.key = "azimuth_deg", .range = kAnyAngle}, box.azimuth_deg);
    visit({.key = "elevation_deg", .range = {-90, 90, "deg"}}, box.elevation_deg);
    visit({.key = "width_deg", .range = kBoxAngle}, box.width_deg);
    visit({.key = "height_deg", .range = kBoxAngle}, box.height_deg);
    visit({.key = "softness",
           .range = {0, 1},
           .meaning = "fraction of the half width over which the edge fades"},
          box.softness);
    visit({.key = "scale",
           .range = kScale,
           .meaning = "luminance at its middle, times `scale` of the environment"},
          box.scale);
}

void describe(Visitor& visit, SkyEnvironment& environment) {
    visit({.key = "sun_azimuth_deg", .range = kAnyAngle}, environment.sun_azimuth_deg);
    visit({.key = "sun_elevation_deg", .range = {0, 90, "deg"}}, environment.sun_elevation_deg);
    visit({.key = "turbidity", .range = {1.7, 10}, .meaning = "clear mountain air to haze"},
          environment.turbidity);
    visit({.key = "scale", .range = kScale, .meaning = "1: luminance 1 is 10 000 cd/m^2"},
          environment.scale);
}

void describe(Visitor& visit, ImageEnvironment& environment) {
    std::filesystem::path path;  // the environment has the picture, not its path
    visit({.key = "path",
           .meaning = "a latitude-longitude picture: EXR, HDR or PNG",
           .required = true,
           .max_size = kMaxPathLength},
          path);
    visit({.key = "azimuth_deg", .range = kAnyAngle, .meaning = "of the picture's middle"},
          environment.azimuth_deg);
    visit({.key = "scale", .range = kScale}, environment.scale);
}

}  // namespace nacre::render
