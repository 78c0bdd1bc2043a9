#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/render/emission.h"
#include "nacre/render/lights.h"
#include "nacre/render/mesh.h"
#include "nacre/render/scene.h"

// Embree's handles, named here so that its headers stay out of ours.
struct RTCDeviceTy;
struct RTCSceneTy;

namespace nacre::render {

struct Ray {
    Vec3f origin_mm, direction;  ///< direction is a unit vector
};

struct Hit {
    Vec3f position_mm;
    float distance_mm = 0;
    Vec3f geometric_normal;  ///< unit, on the side from which the ray came
    Vec3f shading_normal;    ///< unit, likewise; never turned away from the ray
    int material = -1;       ///< index into CompiledScene::materials; -1: a light
    int rectangle = -1;      ///< index of the rectangle light that was hit; -1: a surface
    bool lit_side = false;   ///< of a rectangle: whether the ray met the side that shines
    int surface = -1;        ///< which shape was hit, for CompiledScene::patch()
    std::uint32_t triangle = 0;
    Vec2f barycentric;  ///< weights of the triangle's second and third corner

    /// Where a ray that leaves the surface starts: off the surface by more than the rounding of
    /// the hit point, so that it does not meet it again.
    Vec3f origin() const;
    /// The same for a ray that goes on behind the surface.
    Vec3f origin_behind() const;
};

/// The materials of a scene at eight wavelengths, by their numbers.
using BoundMaterials = std::vector<std::unique_ptr<const bsdf::BoundBsdf>>;

/// What Scene holds: everything that stays the same over a render.
struct CompiledScene {
    CompiledScene(const SceneDescription& description, const PaintTable& paints);
    ~CompiledScene();
    CompiledScene(const CompiledScene&) = delete;
    CompiledScene& operator=(const CompiledScene&) = delete;

    /// The first surface along the ray. `coherent`: neighbouring calls trace similar rays.
    std::optional<Hit> intersect(const Ray& ray, bool coherent) const;
    /// Whether anything stands within `distance_mm` along the ray.
    bool occluded(const Ray& ray, float distance_mm) const;
    /// What is left of light along a stretch, which panes weaken and all else stops.
    FloatLanes transmittance(Ray ray, float distance_mm, const BoundMaterials& bound) const;
    /// Where a ray starts that leaves the surface `exit_mm` away from the hit, as light does that
    /// has gone through a volume (BsdfSample::exit_mm): off the surface, as Hit::origin().
    Vec3f origin(const Hit& hit, Vec3f exit_mm) const;
    /// The parallelogram with the given edges, tangent to the surface at the hit, in the terms that
    /// its material asks for (Bsdf::surface_coordinates).
    /// @param offset_mm  of its middle from the hit, likewise; in object space alone
    ///
    /// In the unit square over which the shape is laid out: meshes linearly on the triangle that
    /// was hit; spheres by the equal-area map octahedral_square() with its pole towards -y,
    /// where edges that cross a fold of that map are taken from the side that does not.
    /// In object space: surface_patch.h.
    bsdf::Patch patch(const Hit& hit, Vec3f offset_mm, Vec3f edge_1_mm, Vec3f edge_2_mm) const;

    /// How the shading normal changes from end to end of an edge, tangent to the surface at the hit.
    Vec3f normal_change(const Hit& hit, Vec3f edge_mm) const;

    /// The slope of the coat's waves there (Bsdf::coat_waves), along x and y of the frame around the
    /// shading normal; none where it is flat.
    std::optional<Vec2f> coat_slope(const Hit& hit) const;
    /// The tangents of the mean normal of its flakes (Bsdf::flake_lean), along x and y of the frame around
    /// the shading normal; none where they lie flat. In object space they are along the projection of x
    /// on the surface and, to its left, seen from above, y; where the surface faces along x none is.
    std::optional<Vec2f> flake_lean(const Hit& hit) const;
    /// How thick the coat is there (Bsdf::coat_thickness), in standard deviations above its mean; none
    /// where it is even.
    std::optional<float> coat_deviation(const Hit& hit) const;

    Camera camera;
    std::vector<std::shared_ptr<const bsdf::Bsdf>> materials;
    EmissionBasis emission;
    std::optional<LightSet> lights;

 private:
    struct Surface {  // by Embree's geometry number
        int material = -1;
        int rectangle = -1;
        AffineMap map{Transform{}};
        Vec3f sphere_center_mm;
        float sphere_radius_mm = 0;  // 0: a mesh
        Mesh mesh;
    };

    void add_sphere(Surface surface);
    void add_mesh(Surface surface);

    std::unique_ptr<RTCDeviceTy, void (*)(RTCDeviceTy*)> device_;
    std::unique_ptr<RTCSceneTy, void (*)(RTCSceneTy*)> scene_;
    std::vector<Surface> surfaces_;
    bool has_panes_ = false;
};

}  // namespace nacre::render
