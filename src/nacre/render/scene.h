#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/references.h"
#include "nacre/core/vec.h"
#include "nacre/optics/material.h"
#include "nacre/spectra/colour.h"
#include "nacre/spectra/spectrum.h"

// What a picture is taken of, as plain values: independent of any file format
// (render/scene_file.h reads one) and of how it is rendered (render/compiled_scene.h).
//
// World: right-handed, z up, lengths in mm. Angles in degrees. Azimuth turns from +x to +y;
// elevation rises from the horizon to +z. Light: a scale of 1 is a luminance of 1 in the picture
// (linear Rec. 709 white), so a perfect diffuser in a constant environment of scale 1 is white.

namespace nacre::bsdf {
struct PaintedShape;
}

namespace nacre::render {

struct Mesh;

/// Relative spectral power times a scale. As a radiance, `scale` is the luminance Y with which
/// the emitter itself appears in the picture; as an irradiance (directional light), a perfect
/// diffuser facing the light appears with luminance scale / pi.
struct Emitter {
    spectra::Illuminant illuminant = spectra::Illuminant::D65;
    double scale = 1;  ///< >= 0

    friend bool operator==(const Emitter&, const Emitter&) = default;
};

// ---------------------------------------------------------------------------------- camera

/// A perspective camera: a pinhole, or a thin lens where the aperture has a radius.
struct Camera {
    Vec3f position_mm{0, -1000, 0};
    Vec3f target_mm{0, 0, 0};
    Vec3f up{0, 0, 1};              ///< not parallel to the line of sight
    double vertical_fov_deg = 30;   ///< full angle from bottom to top, (0, 180)
    double aperture_radius_mm = 0;  ///< 0: pinhole
    double focus_distance_mm = 0;   ///< along the line of sight; 0: the distance of the target

    friend bool operator==(const Camera&, const Camera&) = default;
};

// ---------------------------------------------------------------------------------- shapes

/// Applied in this order: scale, rotate about x, then y, then z (world axes), translate.
struct Transform {
    double scale = 1;  ///< > 0
    Vec3f rotation_deg{0, 0, 0};
    Vec3f translation_mm{0, 0, 0};

    friend bool operator==(const Transform&, const Transform&) = default;
};

struct Sphere {
    double radius_mm = 50;  ///< about the origin

    friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// Where the text of a scene names a file, for messages about that file: "ball.toml:5:8: shapes[0].path: ".
/// Empty of what was not read from a text. It makes no difference between scenes.
struct NamedAt {
    std::string place = {};

    friend bool operator==(const NamedAt&, const NamedAt&) { return true; }
};

/// A triangle mesh from a file: OBJ, PLY, glTF, STL (mesh_file.h). Normals of the file are used;
/// where it has none, they are made smooth below the crease angle.
struct MeshFile {
    std::filesystem::path path;
    double mm_per_unit = 0;        ///< 0: 1000 for glTF, which counts in metres, else 1
    bool y_up = false;             ///< the file's vertical is y (glTF always): turned to z
    double crease_angle_deg = 40;  ///< [0, 180]
    /// The name of a material in the file (usemtl of OBJ, a glTF's materials), whose triangles alone
    /// are the shape; empty: all.
    std::string part = {};
    /// What was read of it, where it was not read from a disk: then `path` is a name for messages.
    std::shared_ptr<const Mesh> read = {};
    NamedAt named_at = {};

    friend bool operator==(const MeshFile&, const MeshFile&) = default;
};

/// A rectangle in the xy plane about the origin, facing +z.
struct FlatPanel {
    double width_mm = 150;   ///< along x
    double height_mm = 100;  ///< along y

    friend bool operator==(const FlatPanel&, const FlatPanel&) = default;
};

/// A panel bent about an axis parallel to y, its crest at the origin, facing +z: the curved test
/// panel on which paint makers judge the flop. Arc length along x is width_mm.
struct CurvedPanel {
    double width_mm = 150;
    double height_mm = 100;
    double bend_radius_mm = 75;  ///< at least width_mm / (2 pi)

    friend bool operator==(const CurvedPanel&, const CurvedPanel&) = default;
};

/// The free-form body on which paint makers show colour: a smooth section of a car-like body with
/// a convex roof, a concave flank and soft edges that catch highlights. Its length runs along x,
/// the nose at +x; it stands on z = 0.
struct SpeedShape {
    double length_mm = 400;

    friend bool operator==(const SpeedShape&, const SpeedShape&) = default;
};

/// Floor z = 0 that sweeps up into a wall through a fillet, the photographer's cyclorama. The
/// floor reaches to y = +depth_mm, the wall beyond it to z = +height_mm; x within +- width_mm / 2,
/// y from -depth_mm.
struct Backdrop {
    double width_mm = 4000;
    double depth_mm = 1000;
    double height_mm = 2000;
    double fillet_radius_mm = 400;  ///< <= depth_mm and height_mm

    friend bool operator==(const Backdrop&, const Backdrop&) = default;
};

/// A square in z = 0 about the origin, facing +z.
struct GroundPlane {
    double size_mm = 100000;

    friend bool operator==(const GroundPlane&, const GroundPlane&) = default;
};

using Geometry =
    std::variant<Sphere, MeshFile, FlatPanel, CurvedPanel, SpeedShape, Backdrop, GroundPlane>;

struct Shape {
    Geometry geometry;
    std::string material;  ///< a key of SceneDescription::materials
    Transform transform;

    friend bool operator==(const Shape&, const Shape&) = default;
};

// ------------------------------------------------------------------------------- materials

/// A Lambertian surface.
struct DiffuseMaterial {
    spectra::Spectrum reflectance = 0.5;  ///< [0, 1]

    friend bool operator==(const DiffuseMaterial&, const DiffuseMaterial&) = default;
};

/// A Lambertian surface whose reflectance is read from a picture, laid over the shape by its texture
/// coordinates.
struct DiffusePictureMaterial {
    int width = 0, height = 0;
    std::vector<float> rgb;  ///< 3 x width x height in linear Rec. 709, each in [0, 1]

    friend bool operator==(const DiffusePictureMaterial&, const DiffusePictureMaterial&) = default;
};

/// A bare metal (bsdf/materials/conductor.h).
struct ConductorMaterial {
    optics::Material metal;
    double roughness = 0;  ///< alpha of GGX, or 0

    friend bool operator==(const ConductorMaterial&, const ConductorMaterial&) = default;
};

/// Glass: the face of a solid, or a pane (bsdf/materials/glass.h).
struct GlassMaterial {
    optics::Material index = optics::Material(1.5);
    double roughness = 0;                       ///< alpha of GGX, or 0; of a solid only
    double pane_mm = 0;                         ///< 0: the shape encloses a solid
    spectra::Spectrum absorption_per_mm = 0.0;  ///< >= 0

    friend bool operator==(const GlassMaterial&, const GlassMaterial&) = default;
};

/// Solid colour under the face of its binder (bsdf/materials/plastic.h).
struct PlasticMaterial {
    spectra::Spectrum reflectance = 0.5;  ///< of the body, [0, 1]
    optics::Material index = optics::Material(1.5);
    double roughness = 0;  ///< alpha of GGX, or 0

    friend bool operator==(const PlasticMaterial&, const PlasticMaterial&) = default;
};

/// A paint: whoever compiles the scene supplies its Bsdf. An empty recipe is the slot for the
/// paint that the user names (`nacre render --paint`).
struct PaintMaterial {
    std::filesystem::path recipe;
    NamedAt named_at = {};

    friend bool operator==(const PaintMaterial&, const PaintMaterial&) = default;
};

using MaterialDescription = std::variant<DiffuseMaterial, PaintMaterial, DiffusePictureMaterial,
                                         ConductorMaterial, GlassMaterial, PlasticMaterial>;

// ---------------------------------------------------------------------------------- lights

/// A rectangle that shines from the side facing `target_mm`, with the same radiance everywhere.
/// Seen from behind it is black.
struct RectangleLight {
    Vec3f center_mm{0, 0, 1000};
    Vec3f target_mm{0, 0, 0};
    Vec3f up{0, 1, 0};  ///< the direction of height_mm, as far as perpendicular; not to the target
    double width_mm = 500;
    double height_mm = 500;
    Emitter radiance{};
    bool visible = true;  ///< to the camera and in the specular reflection of a clearcoat

    friend bool operator==(const RectangleLight&, const RectangleLight&) = default;
};

/// Light from one direction.
struct DirectionalLight {
    Vec3f to_light{0, 0, 1};
    Emitter irradiance{};

    friend bool operator==(const DirectionalLight&, const DirectionalLight&) = default;
};

using Light = std::variant<RectangleLight, DirectionalLight>;

// ------------------------------------------------------------------------------ environment

struct ConstantEnvironment {
    Emitter radiance{};

    friend bool operator==(const ConstantEnvironment&, const ConstantEnvironment&) = default;
};

/// A soft box at infinity: a rectangle on the tangent plane of its direction, upright.
struct SoftBox {
    double azimuth_deg = 0;
    double elevation_deg = 45;
    double width_deg = 40;   ///< (0, 170)
    double height_deg = 40;  ///< (0, 170)
    double softness = 0.15;  ///< fraction of the half width over which the edge fades, [0, 1]
    double scale = 5;        ///< luminance at its middle, times StudioEnvironment::radiance.scale

    friend bool operator==(const SoftBox&, const SoftBox&) = default;
};

/// Soft boxes on a dim gradient: `horizon` at and below the horizon, `zenith` above (luminances
/// times radiance.scale). An empty list of boxes means the built-in four (studio_soft_boxes()).
struct StudioEnvironment {
    Emitter radiance{};
    double horizon = 0.12;
    double zenith = 0.03;
    std::vector<SoftBox> boxes;

    friend bool operator==(const StudioEnvironment&, const StudioEnvironment&) = default;
};

/// Daylight with a sun of 0.53 deg, and ground of reflectance 0.2 below the horizon.
struct SkyEnvironment {
    double sun_azimuth_deg = 0;
    double sun_elevation_deg = 40;  ///< [0, 90]
    double turbidity = 3;           ///< [1.7, 10]: clear mountain air to haze
    double scale = 1;               ///< luminance 1 is 10 000 cd/m^2 at scale 1

    friend bool operator==(const SkyEnvironment&, const SkyEnvironment&) = default;
};

/// A latitude-longitude picture in linear Rec. 709, row-major from the zenith down. Its columns
/// run over azimuth_deg + 180 ... azimuth_deg - 180, so that seen from inside the picture is not
/// mirrored and its middle is at azimuth_deg.
struct ImageEnvironment {
    int width = 0, height = 0;
    std::vector<float> rgb;  ///< 3 x width x height, finite, >= 0
    double azimuth_deg = 90;
    double scale = 1;

    friend bool operator==(const ImageEnvironment&, const ImageEnvironment&) = default;
};

using Environment =
    std::variant<ConstantEnvironment, StudioEnvironment, SkyEnvironment, ImageEnvironment>;

// ----------------------------------------------------------------------------------- scene

struct SceneDescription {
    std::string name;
    /// Which panel of the batch its paints show; 0: that of the models. A whole number.
    double specimen = 0;
    Camera camera;
    std::map<std::string, MaterialDescription> materials;
    std::vector<Shape> shapes;
    std::vector<Light> lights;
    std::optional<Environment> environment;
    /// What its reader changed, for people, naming the file.
    std::vector<std::string> notes = {};
    /// The files that its recipes may name in their turn: as a scene's file could.
    References references = References::anywhere({});
    /// By how much turned() turned what, by its name, for people: shapes, camera and lights stand
    /// as they do then.
    std::map<std::string, double> turned_deg = {};

    friend bool operator==(const SceneDescription&, const SceneDescription&) = default;
};

/// The shapes that a material lies on, in the order of the scene, for models that must know them.
std::vector<bsdf::PaintedShape> painted_shapes(const SceneDescription& scene,
                                               const std::string& material);

/// The soft boxes of the built-in studio.
std::vector<SoftBox> studio_soft_boxes();

/// Checks every range and that each shape's material exists.
/// @throws DomainError naming the key as a scene file spells it ("camera.vertical_fov_deg",
///         "shapes[2].radius_mm"), its value and the allowed range
void validate(const SceneDescription& scene);

/// The Bsdf of each paint, by the name of its material in the description.
using PaintTable = std::map<std::string, std::shared_ptr<const bsdf::Bsdf>>;

struct CompiledScene;

/// A scene ready to be rendered: geometry in a ray-tracing structure, tables for light sampling.
/// Immutable after construction and cheap to copy (copies share the structure).
class Scene {
 public:
    /// @param paints  one entry for each PaintMaterial; other materials need none
    /// @throws DomainError from validate(), or naming a paint material without a Bsdf
    /// @throws InputError  naming the mesh file that cannot be read, and why
    Scene(const SceneDescription& description, const PaintTable& paints);

    const CompiledScene& compiled() const { return *compiled_; }

 private:
    std::shared_ptr<const CompiledScene> compiled_;
};

}  // namespace nacre::render
