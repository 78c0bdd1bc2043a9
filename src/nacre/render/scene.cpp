#include "nacre/render/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/core/error.h"

namespace nacre::render {
namespace {

constexpr double kFar = 1e7;  // mm: 10 km, beyond which float coordinates are coarser than 1 mm

constexpr Range kLength{0, kFar, "mm", true, false};
constexpr Range kLengthOrZero{0, kFar, "mm"};
constexpr Range kCoordinate{-kFar, kFar, "mm"};
constexpr Range kScale{0, 1e9};
constexpr Range kAnyAngle{-3600, 3600, "deg"};
constexpr Range kElevation{-90, 90, "deg"};

/// Checks the keys below one table of the scene, whose name they carry in messages.
class Checker {
 public:
    explicit Checker(std::string table) : table_(std::move(table)) {}

    void number(const char* key, double value, const Range& range) const {
        if (!range.contains(value)) {
            throw DomainError(
                fmt::format("{}.{} = {} is outside {}", table_, key, value, range.text()));
        }
    }
    void vector(const char* key, Vec3f v, const Range& range) const {
        for (float c : {v.x, v.y, v.z}) number(key, c, range);
    }
    /// A direction: finite and not zero.
    void direction(const char* key, Vec3f v) const {
        vector(key, v, {-1e6, 1e6});
        if (!(dot(v, v) > 1e-12f)) refuse(key, "has no length");
    }
    [[noreturn]] void refuse(const char* key, const std::string& reason) const {
        throw DomainError(fmt::format("{}.{} {}", table_, key, reason));
    }
    /// `up` must not point along the line from one point to another, and the two must differ.
    void looks_from_to(const char* from_key, Vec3f from, Vec3f to, Vec3f up) const {
        const Vec3f line = to - from;
        if (!(length(line) > 1e-6f * (1 + length(from))))
            refuse("target_mm", fmt::format("is the same point as {}.{}", table_, from_key));
        const Vec3f side = cross(normalize(line), normalize(up));
        if (!(length(side) > 1e-4f)) refuse("up", "is parallel to the direction of the target");
    }
    const std::string& table() const { return table_; }

 private:
    std::string table_;
};

void check(const Checker& at, const Camera& c) {
    at.vector("position_mm", c.position_mm, kCoordinate);
    at.vector("target_mm", c.target_mm, kCoordinate);
    at.direction("up", c.up);
    at.looks_from_to("position_mm", c.position_mm, c.target_mm, c.up);
    at.number("vertical_fov_deg", c.vertical_fov_deg, {0.01, 179, "deg"});
    at.number("aperture_radius_mm", c.aperture_radius_mm, kLengthOrZero);
    at.number("focus_distance_mm", c.focus_distance_mm, kLengthOrZero);
}

void check(const Checker& at, const Sphere& s) { at.number("radius_mm", s.radius_mm, kLength); }
void check(const Checker& at, const MeshFile& m) {
    if (m.path.empty()) at.refuse("path", "is empty");
    at.number("mm_per_unit", m.mm_per_unit, {0, 1e9, "mm", true, false});
    at.number("crease_angle_deg", m.crease_angle_deg, {0, 180, "deg"});
}
void check(const Checker& at, const FlatPanel& p) {
    at.number("width_mm", p.width_mm, kLength);
    at.number("height_mm", p.height_mm, kLength);
}
void check(const Checker& at, const CurvedPanel& p) {
    at.number("width_mm", p.width_mm, kLength);
    at.number("height_mm", p.height_mm, kLength);
    at.number("bend_radius_mm", p.bend_radius_mm,
              {p.width_mm / (2 * std::numbers::pi), kFar, "mm"});
}
void check(const Checker& at, const SpeedShape& s) { at.number("length_mm", s.length_mm, kLength); }
void check(const Checker& at, const Backdrop& b) {
    at.number("width_mm", b.width_mm, kLength);
    at.number("depth_mm", b.depth_mm, kLength);
    at.number("height_mm", b.height_mm, kLength);
    at.number("fillet_radius_mm", b.fillet_radius_mm,
              {0, std::min(b.depth_mm, b.height_mm), "mm", true, false});
}
void check(const Checker& at, const GroundPlane& p) { at.number("size_mm", p.size_mm, kLength); }

void check(const Checker& at, const RectangleLight& l) {
    at.vector("center_mm", l.center_mm, kCoordinate);
    at.vector("target_mm", l.target_mm, kCoordinate);
    at.direction("up", l.up);
    at.looks_from_to("center_mm", l.center_mm, l.target_mm, l.up);
    at.number("width_mm", l.width_mm, kLength);
    at.number("height_mm", l.height_mm, kLength);
    at.number("scale", l.radiance.scale, kScale);
}
void check(const Checker& at, const DirectionalLight& l) {
    at.direction("to_light", l.to_light);
    at.number("scale", l.irradiance.scale, kScale);
}

void check(const Checker& at, const ConstantEnvironment& e) {
    at.number("scale", e.radiance.scale, kScale);
}
void check(const Checker& at, const StudioEnvironment& e) {
    at.number("scale", e.radiance.scale, kScale);
    at.number("horizon", e.horizon, kScale);
    at.number("zenith", e.zenith, kScale);
    for (std::size_t i = 0; i < e.boxes.size(); ++i) {
        const SoftBox& b = e.boxes[i];
        const Checker box(fmt::format("{}.boxes[{}]", at.table(), i));
        box.number("azimuth_deg", b.azimuth_deg, kAnyAngle);
        box.number("elevation_deg", b.elevation_deg, kElevation);
        box.number("width_deg", b.width_deg, {0, 170, "deg", true, false});
        box.number("height_deg", b.height_deg, {0, 170, "deg", true, false});
        box.number("softness", b.softness, {0, 1});
        box.number("scale", b.scale, kScale);
    }
}
void check(const Checker& at, const SkyEnvironment& e) {
    at.number("sun_azimuth_deg", e.sun_azimuth_deg, kAnyAngle);
    at.number("sun_elevation_deg", e.sun_elevation_deg, {0, 90, "deg"});
    at.number("turbidity", e.turbidity, {1.7, 10});
    at.number("scale", e.scale, kScale);
}
void check(const Checker& at, const ImageEnvironment& e) {
    at.number("width", e.width, {1, 65536, "pixels"});
    at.number("height", e.height, {1, 65536, "pixels"});
    at.number("azimuth_deg", e.azimuth_deg, kAnyAngle);
    at.number("scale", e.scale, kScale);
    if (e.rgb.size() != std::size_t{3} * e.width * e.height) {
        at.refuse("rgb",
                  fmt::format("has {} values, not 3 x {} x {}", e.rgb.size(), e.width, e.height));
    }
    for (std::size_t i = 0; i < e.rgb.size(); ++i) {
        if (!(e.rgb[i] >= 0 && e.rgb[i] <= std::numeric_limits<float>::max())) {
            at.refuse("rgb", fmt::format("is {} at column {}, row {}: not a finite number >= 0",
                                         e.rgb[i], i / 3 % e.width, i / 3 / e.width));
        }
    }
}

void check(const Checker& at, const Shape& shape, const SceneDescription& scene) {
    std::visit([&](const auto& geometry) { check(at, geometry); }, shape.geometry);
    at.number("scale", shape.transform.scale, {0, 1e6, "", true, false});
    at.vector("rotation_deg", shape.transform.rotation_deg, kAnyAngle);
    at.vector("translation_mm", shape.transform.translation_mm, kCoordinate);
    if (!scene.materials.contains(shape.material)) {
        std::string names;
        for (const auto& [name, material] : scene.materials) {
            names += (names.empty() ? "" : ", ") + name;
        }
        at.refuse("material", fmt::format("= '{}' is not among the materials: {}", shape.material,
                                          names.empty() ? "there are none" : names));
    }
}

}  // namespace

void validate(const SceneDescription& scene) {
    check(Checker("camera"), scene.camera);
    for (const auto& [name, material] : scene.materials) {
        if (const auto* diffuse = std::get_if<DiffuseMaterial>(&material)) {
            const Checker at("materials." + name);
            at.number("reflectance", diffuse->reflectance.min(), {0, 1});
            at.number("reflectance", diffuse->reflectance.max(), {0, 1});
        }
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        check(Checker(fmt::format("shapes[{}]", i)), scene.shapes[i], scene);
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        std::visit([&](const auto& light) { check(Checker(fmt::format("lights[{}]", i)), light); },
                   scene.lights[i]);
    }
    if (scene.environment) {
        std::visit([](const auto& e) { check(Checker("environment"), e); }, *scene.environment);
    }
}

}  // namespace nacre::render
