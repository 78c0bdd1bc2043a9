#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/studio/messages/own_files.h"
#include "apps/studio/messages/recipe_tree.h"
#include "nacre/core/error.h"
#include "nacre/render/scene.h"

// What a painted body stands in: a shape and a light, each by its name, as the page offers them. The
// live picture and the path tracer's are made of the same meshes, cameras and lights.

namespace nacre::studio {

/// About the middle of the shape.
struct OrbitCamera {
    double azimuth_deg = -90;   ///< from +x to +y; -90 is in front
    double elevation_deg = 10;  ///< kElevation
    double distance_mm = 600;   ///< kDistance
    double fov_deg = 11;        ///< vertical, kFieldOfView
};
inline constexpr Range kElevation{-89, 89, "deg"}, kDistance{1, 1e5, "mm"},
    kFieldOfView{0.05, 120, "deg"}, kTurn{-3600, 3600, "deg"};

struct Stage {
    std::string shape = "ball";
    std::string light = "studio";
    std::optional<OrbitCamera> camera = {};  ///< none: that of the shape
    double turn_deg = 0;                     ///< of the shape about the vertical, counterclockwise
    double light_turn_deg = 0;               ///< of all lights
    double specimen = 0;                     ///< which panel of the batch
    /// Those that the page brought along, which have names besides the names below.
    std::shared_ptr<const OwnShape> own_shape = {};
    std::shared_ptr<const OwnLight> own_light = {};
};

/// @throws InputError naming shape or light, and those that there are; DomainError naming a number
///         out of range
render::SceneDescription scene_of(const Stage& stage);

/// The illuminant of all lights of a booth; of other lights D65, by which their colours are stated.
/// @throws InputError as scene_of()
spectra::Illuminant lamp_of(const Stage& stage);

/// From linear Rec. 709 to what an eye sees that has adapted to a light, on a display whose white is
/// D65: Bradford's transform (spectra::adapted) from the light of a booth. Other lights are seen as
/// they are.
class Adaptation {
 public:
    /// @param samples  of a picture that has all of its samples, by whose wavelengths the lamp is white
    ///                 in it too; 0: by all wavelengths
    /// @throws InputError as scene_of()
    explicit Adaptation(const Stage& stage, int samples = 0);
    Vec3d operator()(const Vec3d& rgb) const;
    /// Whether colours stay as they are.
    bool is_none() const { return none_; }

 private:
    bool none_ = true;
    Vec3d columns_[3];
};

/// The least width over height of a picture by the shape's camera that shows the whole shape, however it
/// is turned about the vertical; 1 for those that any upright picture shows, and for the camera of a
/// detail.
double aspect_of(const render::SceneDescription& scene);

/// For the schema: name, title, transform from the mesh to the world, camera and the light that
/// suits it.
Tree shapes_json();
Tree shape_json(const OwnShape& shape);
Tree lights_json();

/// GET /api/shape/NAME: the triangles of the shape in its own coordinates (docs/studio-api.md).
/// @throws InputError as scene_of()
std::string shape_bytes(const Stage& stage);

/// GET /api/light/NAME: what shines from all directions as a picture, and the lights beside it.
/// @param width  of the picture, kLightWidth; its height is half of that
/// @throws InputError as scene_of(); DomainError if the width is out of range
std::string light_bytes(const Stage& stage, int width);
inline constexpr Range kLightWidth{16, 4096, "pixels"};
inline constexpr int kUsualLightWidth = 512;

}  // namespace nacre::studio
