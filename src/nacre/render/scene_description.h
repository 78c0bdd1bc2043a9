#pragma once

#include "nacre/paint/description.h"
#include "nacre/render/scene.h"

// Every key of a scene, once (paint/description.h). To add a key, add a member to its struct
// (render/scene.h) and a line to its description; the reader and the checks follow, and a test
// fails until docs/scene.md has the key.

namespace nacre::render {

inline constexpr std::size_t kMaxShapes = 10'000;
/// 10 km, beyond which float coordinates are coarser than 1 mm.
inline constexpr double kFar_mm = 1e7;

void describe(paint::Visitor& visit, SceneDescription& scene);
void describe(paint::Visitor& visit, Camera& camera);
void describe(paint::Visitor& visit, MaterialDescription& material);
void describe(paint::Visitor& visit, DiffuseMaterial& material);
void describe(paint::Visitor& visit, PaintMaterial& material);
void describe(paint::Visitor& visit, DiffusePictureMaterial& material);
void describe(paint::Visitor& visit, ConductorMaterial& material);
void describe(paint::Visitor& visit, GlassMaterial& material);
void describe(paint::Visitor& visit, PlasticMaterial& material);
void describe(paint::Visitor& visit, Shape& shape);
void describe(paint::Visitor& visit, Sphere& sphere);
void describe(paint::Visitor& visit, MeshFile& mesh);
void describe(paint::Visitor& visit, FlatPanel& panel);
void describe(paint::Visitor& visit, CurvedPanel& panel);
void describe(paint::Visitor& visit, SpeedShape& shape);
void describe(paint::Visitor& visit, Backdrop& backdrop);
void describe(paint::Visitor& visit, GroundPlane& ground);
void describe(paint::Visitor& visit, Light& light);
void describe(paint::Visitor& visit, RectangleLight& light);
void describe(paint::Visitor& visit, DirectionalLight& light);
void describe(paint::Visitor& visit, Environment& environment);
void describe(paint::Visitor& visit, ConstantEnvironment& environment);
void describe(paint::Visitor& visit, StudioEnvironment& environment);
void describe(paint::Visitor& visit, SoftBox& box);
void describe(paint::Visitor& visit, SkyEnvironment& environment);
void describe(paint::Visitor& visit, ImageEnvironment& environment);

}  // namespace nacre::render
