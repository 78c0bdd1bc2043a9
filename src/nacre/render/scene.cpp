#include "nacre/render/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "nacre/bsdf/model.h"
#include "nacre/core/error.h"
#include "nacre/render/scene_description.h"

namespace nacre::render {
namespace {

/// Ranges of all keys.
class SceneCheck final : public paint::RangeCheck {
 public:
    void number(const paint::Field& field, double& value) override {
        if (allows(field, value)) return;
        throw DomainError(
            fmt::format("{} = {} is outside {}", path_of(field), value, field.range.text()));
    }
    void material(const paint::Field& field, optics::Material& value) override {
        for (const optics::ComplexIndex& index : value.samples()) {
            if (field.range.contains(index.real())) continue;
            throw DomainError(fmt::format("{} = {} is outside {}", path_of(field), index.real(),
                                          field.range.text()));
        }
    }
    /// Only files are limited in size.
    void list(const paint::Field& field, paint::List& list) override {
        PathVisitor::list(field, list);
    }
};

/// Refuses what concerns several keys of one table of the scene, whose name messages carry.
class Table {
 public:
    explicit Table(std::string name) : name_(std::move(name)) {}

    void number(const char* key, double value, const Range& range) const {
        if (range.contains(value)) return;
        refuse(key, fmt::format("= {} is outside {}", value, range.text()));
    }
    void direction(const char* key, Vec3f v) const {
        if (!(dot(v, v) > 1e-12f)) refuse(key, "has no length");
    }
    [[noreturn]] void refuse(const char* key, const std::string& reason) const {
        throw DomainError(fmt::format("{}.{} {}", name_, key, reason));
    }
    /// `up` must not point along the line from one point to another, and the two must differ.
    void looks_from_to(const char* from_key, Vec3f from, Vec3f to, Vec3f up) const {
        direction("up", up);
        const Vec3f line = to - from;
        if (!(length(line) > 1e-6f * (1 + length(from))))
            refuse("target_mm", fmt::format("is the same point as {}.{}", name_, from_key));
        const Vec3f side = cross(normalize(line), normalize(up));
        if (!(length(side) > 1e-4f)) refuse("up", "is parallel to the direction of the target");
    }

 private:
    std::string name_;
};

/// What has no keys that depend on each other.
template <class T>
void check(const Table&, const T&) {}

void check(const Table& at, const Camera& c) {
    at.looks_from_to("position_mm", c.position_mm, c.target_mm, c.up);
}
void check(const Table& at, const MeshFile& m) {
    if (m.path.empty()) at.refuse("path", "is empty");
}
void check(const Table& at, const CurvedPanel& p) {
    at.number("bend_radius_mm", p.bend_radius_mm,
              {p.width_mm / (2 * std::numbers::pi), kFar_mm, "mm"});
}
void check(const Table& at, const Backdrop& b) {
    at.number("fillet_radius_mm", b.fillet_radius_mm,
              {0, std::min(b.depth_mm, b.height_mm), "mm", true});
}
void check(const Table& at, const RectangleLight& l) {
    at.looks_from_to("center_mm", l.center_mm, l.target_mm, l.up);
}
void check(const Table& at, const DirectionalLight& l) { at.direction("to_light", l.to_light); }
/// A picture's values, which readers of files fill.
void check_pixels(const Table& at, int width, int height, const std::vector<float>& rgb,
                  float largest, const char* allowed) {
    at.number("width", width, {1, 65536, "pixels"});
    at.number("height", height, {1, 65536, "pixels"});
    if (rgb.size() != std::size_t{3} * width * height) {
        at.refuse("rgb", fmt::format("has {} values, not 3 x {} x {}", rgb.size(), width, height));
    }
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        if (!(rgb[i] >= 0 && rgb[i] <= largest)) {
            at.refuse("rgb", fmt::format("is {} at column {}, row {}: not {}", rgb[i],
                                         i / 3 % width, i / 3 / width, allowed));
        }
    }
}

void check(const Table& at, const ImageEnvironment& e) {
    check_pixels(at, e.width, e.height, e.rgb, std::numeric_limits<float>::max(),
                 "a finite number >= 0");
}
void check(const Table& at, const DiffusePictureMaterial& m) {
    check_pixels(at, m.width, m.height, m.rgb, 1, "a reflectance in [0, 1]");
}
void check(const Table& at, const GlassMaterial& m) {
    if (m.pane_mm > 0 && m.roughness > 0) {
        at.refuse("roughness",
                  fmt::format("= {}: a pane (pane_mm = {}) is smooth", m.roughness, m.pane_mm));
    }
}

void check(const Table& at, const Shape& shape, const SceneDescription& scene) {
    std::visit([&](const auto& geometry) { check(at, geometry); }, shape.geometry);
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

std::vector<bsdf::PaintedShape> painted_shapes(const SceneDescription& scene,
                                               const std::string& material) {
    using Kind = bsdf::PaintedShape::Kind;
    std::vector<bsdf::PaintedShape> shapes;
    for (const Shape& shape : scene.shapes) {
        if (shape.material != material) continue;
        const double scale = shape.transform.scale;
        if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
            shapes.push_back({.kind = Kind::sphere, .radius_mm = sphere->radius_mm * scale});
        } else if (const auto* panel = std::get_if<FlatPanel>(&shape.geometry)) {
            shapes.push_back({.kind = Kind::panel,
                              .width_mm = scale * panel->width_mm,
                              .height_mm = scale * panel->height_mm});
        } else {
            shapes.push_back({});
        }
    }
    return shapes;
}

void validate(const SceneDescription& scene) {
    SceneCheck ranges;
    paint::Described::to_inspect(scene).accept(ranges);
    if (scene.specimen != std::floor(scene.specimen)) {
        throw DomainError(fmt::format("specimen = {} is no whole number", scene.specimen));
    }
    check(Table("camera"), scene.camera);
    for (const auto& [name, material] : scene.materials) {
        const Table at("materials." + name);
        std::visit([&at](const auto& m) { check(at, m); }, material);
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        check(Table(fmt::format("shapes[{}]", i)), scene.shapes[i], scene);
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        std::visit([&](const auto& light) { check(Table(fmt::format("lights[{}]", i)), light); },
                   scene.lights[i]);
    }
    if (scene.environment) {
        std::visit([](const auto& e) { check(Table("environment"), e); }, *scene.environment);
    }
}

}  // namespace nacre::render
