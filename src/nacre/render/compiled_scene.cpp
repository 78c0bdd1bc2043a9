#include "nacre/render/compiled_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/bsdf/materials/conductor.h"
#include "nacre/bsdf/materials/diffuse_picture.h"
#include "nacre/bsdf/materials/glass.h"
#include "nacre/bsdf/materials/plastic.h"
#include "nacre/bsdf/models/lambertian.h"
#include "nacre/core/embree.h"
#include "nacre/core/error.h"
#include "nacre/render/surface_patch.h"
#include "nacre/sparkle/coat_thickness.h"
#include "nacre/sparkle/coat_waves.h"

namespace nacre::render {
namespace {

using Compiled = std::shared_ptr<const bsdf::Bsdf>;

Compiled compile(const DiffuseMaterial& m) {
    return std::make_shared<bsdf::Lambertian>(m.reflectance);
}
Compiled compile(const DiffusePictureMaterial& m) {
    return std::make_shared<bsdf::DiffusePicture>(
        bsdf::DiffusePicture::Pixels{m.width, m.height, m.rgb});
}
Compiled compile(const ConductorMaterial& m) {
    return std::make_shared<bsdf::Conductor>(m.metal, m.roughness);
}
Compiled compile(const GlassMaterial& m) {
    if (m.pane_mm > 0) {
        return std::make_shared<bsdf::Pane>(m.index, m.absorption_per_mm, m.pane_mm);
    }
    return std::make_shared<bsdf::Glass>(m.index, m.absorption_per_mm, m.roughness);
}
Compiled compile(const PlasticMaterial& m) {
    return std::make_shared<bsdf::Plastic>(m.reflectance, m.index, m.roughness);
}
Compiled compile(const PaintMaterial&) { return nullptr; }  // a paint is given

std::vector<std::shared_ptr<const bsdf::Bsdf>> compile_materials(
    const SceneDescription& description, const PaintTable& paints) {
    std::vector<std::shared_ptr<const bsdf::Bsdf>> compiled;
    for (const auto& [name, material] : description.materials) {
        if (!std::holds_alternative<PaintMaterial>(material)) {
            try {
                compiled.push_back(std::visit([](const auto& m) { return compile(m); }, material));
            } catch (const DomainError& error) {
                throw DomainError(fmt::format("materials.{}.{}", name, error.what()));
            }
            continue;
        }
        const auto paint = paints.find(name);
        if (paint == paints.end() || !paint->second) {
            throw DomainError(
                fmt::format("materials.{} is a paint, and none was given for it", name));
        }
        compiled.push_back(paint->second);
    }
    return compiled;
}

Mesh rectangle_mesh(const CompiledRectangle& r) {
    return mesh_of_surface(1, 1, [&](double u, double v) {
        return SurfacePoint{
            r.corner_mm + static_cast<float>(u) * r.edge_u_mm + static_cast<float>(v) * r.edge_v_mm,
            r.normal};
    });
}

/// Not of unit length.
Vec3f interpolated_normal(const Mesh& mesh, std::uint32_t triangle, Vec2f barycentric) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return (1 - barycentric.x - barycentric.y) * mesh.normals[a] + barycentric.x * mesh.normals[b] +
           barycentric.y * mesh.normals[c];
}

RTCRay make_ray(const Ray& ray, float far) {
    RTCRay r;
    r.org_x = ray.origin_mm.x;
    r.org_y = ray.origin_mm.y;
    r.org_z = ray.origin_mm.z;
    r.dir_x = ray.direction.x;
    r.dir_y = ray.direction.y;
    r.dir_z = ray.direction.z;
    r.tnear = 0;
    r.tfar = far;
    r.time = 0;
    r.mask = ~0u;
    r.id = 0;
    r.flags = 0;
    return r;
}

}  // namespace

CompiledScene::CompiledScene(const SceneDescription& description, const PaintTable& paints)
    : camera(description.camera),
      materials(compile_materials(description, paints)),
      device_(rtcNewDevice(nullptr), [](RTCDeviceTy* d) { rtcReleaseDevice(d); }),
      scene_(nullptr, [](RTCSceneTy* s) { rtcReleaseScene(s); }) {
    embree::check(device_.get(), "starting");
    for (const auto& material : materials) has_panes_ |= material->has_null_transmission();
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    for (const Shape& shape : description.shapes) {
        const auto found = description.materials.find(shape.material);
        const int material = static_cast<int>(std::distance(description.materials.begin(), found));
        Surface surface;
        surface.material = material;
        surface.map = AffineMap(shape.transform);
        if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
            surface.sphere_center_mm = surface.map.point({});
            surface.sphere_radius_mm = surface.map.scale() * static_cast<float>(sphere->radius_mm);
            add_sphere(std::move(surface));
            continue;
        }
        surface.mesh = std::visit(
            [](const auto& geometry) {
                if constexpr (requires { make_mesh(geometry); }) return make_mesh(geometry);
                return Mesh{};  // a sphere: handled above
            },
            shape.geometry);
        using bsdf::SurfaceCoordinates;
        const SurfaceCoordinates by = materials[material]->surface_coordinates();
        if (surface.mesh.uv.empty() && (by == SurfaceCoordinates::unit_square ||
                                        by == SurfaceCoordinates::place_in_unit_square)) {
            const auto& file = std::get<MeshFile>(shape.geometry);
            throw InputError(
                fmt::format("{}mesh '{}': has no texture coordinates; the material '{}' {}",
                            file.named_at.place, file.path.string(), shape.material,
                            by == SurfaceCoordinates::unit_square
                                ? "is a paint that shows single facets, whose places they give"
                                : "is a picture, which they lay over the mesh"));
        }
        apply(surface.map, surface.mesh);
        add_mesh(std::move(surface));
    }

    // Sized before the lights' own rectangles join the scene.
    Vec3f center{};
    float radius = 1;
    rtcCommitScene(scene_.get());
    embree::check(device_.get(), "building the scene");
    if (!surfaces_.empty()) {
        RTCBounds b;
        rtcGetSceneBounds(scene_.get(), &b);
        const Vec3f low{b.lower_x, b.lower_y, b.lower_z}, high{b.upper_x, b.upper_y, b.upper_z};
        center = 0.5f * (low + high);
        radius = 0.5f * length(high - low);
    }
    lights.emplace(description.lights, description.environment, center, radius, emission);
    for (std::size_t i = 0; i < lights->rectangles().size(); ++i) {
        const CompiledRectangle& r = lights->rectangles()[i];
        if (!r.visible) continue;
        Surface surface;
        surface.rectangle = static_cast<int>(i);
        surface.mesh = rectangle_mesh(r);
        add_mesh(std::move(surface));
    }
    rtcCommitScene(scene_.get());
    embree::check(device_.get(), "building the scene");
}

CompiledScene::~CompiledScene() = default;

void CompiledScene::add_sphere(Surface surface) {
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
    embree::check(device_.get(), "making a sphere");
    vertex[0] = surface.sphere_center_mm.x;
    vertex[1] = surface.sphere_center_mm.y;
    vertex[2] = surface.sphere_center_mm.z;
    vertex[3] = surface.sphere_radius_mm;
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_.get(), geometry, static_cast<unsigned>(surfaces_.size()));
    rtcReleaseGeometry(geometry);
    surfaces_.push_back(std::move(surface));
}

void CompiledScene::add_mesh(Surface surface) {
    const Mesh& mesh = surface.mesh;
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Vec3f), mesh.positions_mm.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), mesh.triangles.size());
    embree::check(device_.get(), "making a mesh");
    std::memcpy(vertices, mesh.positions_mm.data(), mesh.positions_mm.size() * sizeof(Vec3f));
    std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_.get(), geometry, static_cast<unsigned>(surfaces_.size()));
    rtcReleaseGeometry(geometry);
    surfaces_.push_back(std::move(surface));
}

std::optional<Hit> CompiledScene::intersect(const Ray& ray, bool coherent) const {
    RTCRayHit query;
    query.ray = make_ray(ray, std::numeric_limits<float>::infinity());
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(scene_.get(), query, coherent);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const Surface& surface = surfaces_[query.hit.geomID];
    Hit hit;
    hit.material = surface.material;
    hit.rectangle = surface.rectangle;
    hit.surface = static_cast<int>(query.hit.geomID);
    hit.triangle = query.hit.primID;
    hit.barycentric = {query.hit.u, query.hit.v};
    hit.distance_mm = query.ray.tfar;
    hit.position_mm = ray.origin_mm + query.ray.tfar * ray.direction;
    if (surface.sphere_radius_mm > 0) {
        hit.geometric_normal = normalize(hit.position_mm - surface.sphere_center_mm);
        // Back onto the sphere: the distance of a far camera has rounded the point off it.
        hit.position_mm =
            surface.sphere_center_mm + surface.sphere_radius_mm * hit.geometric_normal;
        hit.shading_normal = hit.geometric_normal;
    } else {
        hit.geometric_normal = normalize(Vec3f{query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z});
        const Vec3f blend = interpolated_normal(surface.mesh, hit.triangle, hit.barycentric);
        // Opposite normals of a folded mesh can cancel.
        hit.shading_normal = dot(blend, blend) > 0 ? normalize(blend) : hit.geometric_normal;
    }
    const Vec3f back = -ray.direction;
    hit.lit_side = dot(hit.geometric_normal, back) > 0;
    if (!hit.lit_side) hit.geometric_normal = -hit.geometric_normal;
    if (dot(hit.shading_normal, hit.geometric_normal) < 0) hit.shading_normal = -hit.shading_normal;
    // At the outline of a coarse mesh an interpolated normal may face away from the ray, which
    // would be black; it is bent until it is just seen.
    constexpr float kMinCosine = 1e-3f;
    const float facing = dot(hit.shading_normal, back);
    if (facing < kMinCosine) {
        hit.shading_normal = normalize(hit.shading_normal + (kMinCosine - facing) * back);
    }
    return hit;
}

Vec3f CompiledScene::origin(const Hit& hit, Vec3f exit_mm) const {
    Hit exit = hit;
    exit.position_mm = hit.position_mm + exit_mm;
    const Surface& surface = surfaces_[hit.surface];
    if (surface.sphere_radius_mm > 0 && dot(exit_mm, exit_mm) > 0) {
        exit.geometric_normal = normalize(exit.position_mm - surface.sphere_center_mm);
        exit.position_mm =
            surface.sphere_center_mm + surface.sphere_radius_mm * exit.geometric_normal;
    }
    return exit.origin();
}

bsdf::Patch CompiledScene::patch(const Hit& hit, Vec3f offset_mm, Vec3f edge_1_mm,
                                 Vec3f edge_2_mm) const {
    const Surface& surface = surfaces_[hit.surface];
    if (materials[hit.material]->surface_coordinates() == bsdf::SurfaceCoordinates::object_space) {
        bsdf::Patch patch;
        patch.footprint =
            object_space_footprint(surface.map, hit.position_mm + offset_mm, hit.geometric_normal,
                                   hit.shading_normal, edge_1_mm, edge_2_mm);
        return patch;
    }
    if (surface.sphere_radius_mm > 0) {
        return sphere_patch(normalize(hit.position_mm - surface.sphere_center_mm),
                            (1 / surface.sphere_radius_mm) * edge_1_mm,
                            (1 / surface.sphere_radius_mm) * edge_2_mm);
    }
    return triangle_patch(surface.mesh, hit.triangle, hit.barycentric, edge_1_mm, edge_2_mm);
}

Vec3f CompiledScene::normal_change(const Hit& hit, Vec3f edge_mm) const {
    const Surface& surface = surfaces_[hit.surface];
    if (surface.sphere_radius_mm > 0) {
        const float outward =
            dot(hit.geometric_normal, hit.position_mm - surface.sphere_center_mm) > 0 ? 1 : -1;
        return (outward / surface.sphere_radius_mm) * edge_mm;
    }
    const Mesh& mesh = surface.mesh;
    const BarycentricChange weights(mesh, hit.triangle);
    if (!weights.exists()) return {};
    const Vec3f blend = interpolated_normal(mesh, hit.triangle, hit.barycentric);
    const float size = length(blend);
    if (!(size > 0)) return {};
    const auto& [a, b, c] = mesh.triangles[hit.triangle];
    const auto [w1, w2] = weights.along(edge_mm);
    const Vec3f change = static_cast<float>(w1) * (mesh.normals[b] - mesh.normals[a]) +
                         static_cast<float>(w2) * (mesh.normals[c] - mesh.normals[a]);
    const float turned = dot(blend, hit.shading_normal) > 0 ? 1 / size : -1 / size;
    return turned * (change - dot(change, hit.shading_normal) * hit.shading_normal);
}

std::optional<Vec2f> CompiledScene::coat_slope(const Hit& hit) const {
    const sparkle::CoatWaves* const waves = materials[hit.material]->coat_waves();
    if (!waves) return std::nullopt;
    const AffineMap& map = surfaces_[hit.surface].map;
    const Frame frame = Frame::around(hit.shading_normal);
    return waves->slope(map.point_in_object_space_mm(hit.position_mm),
                        map.direction_in_object_space(frame.n),
                        map.direction_in_object_space(frame.s));
}

std::optional<Vec2f> CompiledScene::flake_lean(const Hit& hit) const {
    const auto lean = materials[hit.material]->flake_lean();
    if (!lean) return std::nullopt;
    const AffineMap& map = surfaces_[hit.surface].map;
    const Frame frame = Frame::around(hit.shading_normal);
    const Vec3f n = map.direction_in_object_space(frame.n);
    const Vec3f x = Vec3f{1, 0, 0} - n.x * n;
    constexpr float kNoDirection = 1e-6f;
    if (dot(x, x) < kNoDirection) return std::nullopt;
    const Vec3f along = normalize(x), across = cross(n, along);
    const Vec3f leaning = lean->x * along + lean->y * across;
    return Vec2f{dot(leaning, map.direction_in_object_space(frame.s)),
                 dot(leaning, map.direction_in_object_space(frame.t))};
}

std::optional<float> CompiledScene::coat_deviation(const Hit& hit) const {
    const sparkle::CoatThickness* const thickness = materials[hit.material]->coat_thickness();
    if (!thickness) return std::nullopt;
    return thickness->deviation(
        surfaces_[hit.surface].map.point_in_object_space_mm(hit.position_mm));
}

bool CompiledScene::occluded(const Ray& ray, float distance_mm) const {
    RTCRay query = make_ray(ray, distance_mm);
    embree::occluded(scene_.get(), query);
    return query.tfar < 0;
}

FloatLanes CompiledScene::transmittance(Ray ray, float distance_mm,
                                        const BoundMaterials& bound) const {
    if (!has_panes_) return splat(occluded(ray, distance_mm) ? 0.0f : 1.0f);
    FloatLanes left = splat(1.0f);
    for (;;) {
        const auto hit = intersect(ray, false);
        if (!hit || hit->distance_mm >= distance_mm) return left;
        if (hit->rectangle >= 0) return FloatLanes{};
        const Vec3f wi = Frame::around(hit->shading_normal).to_local(-ray.direction);
        left *= bound[hit->material]->null_transmission(wi);
        if (!(lane_max(left) > 0)) return left;
        distance_mm -= hit->distance_mm;
        ray.origin_mm = hit->origin_behind();
    }
}

Vec3f Hit::origin() const {
    // 64 units in the last place of the largest coordinate that took part.
    const float size = std::max(
        {std::abs(position_mm.x), std::abs(position_mm.y), std::abs(position_mm.z), distance_mm});
    return position_mm + (0x1p-17f * size) * geometric_normal;
}

Vec3f Hit::origin_behind() const { return position_mm - (origin() - position_mm); }

Scene::Scene(const SceneDescription& description, const PaintTable& paints) {
    validate(description);
    compiled_ = std::make_shared<const CompiledScene>(description, paints);
}

}  // namespace nacre::render
