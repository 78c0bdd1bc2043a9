#pragma once

#include <string>

#include "nacre/render/scene.h"

// A colour is judged in motion: the same scene with its paint, camera or light turned a little
// further from frame to frame.

namespace nacre::render {

enum class Turning {
    shape,   ///< everything painted; a backdrop stays
    camera,  ///< about its target
    light    ///< lights and environment
};

/// By its name: "shape", "camera" or "light".
/// @throws DomainError "turntable = ..."
Turning turning_called(const std::string& name);

/// The scene after a turn about the vertical through the camera's target, counterclockwise as seen
/// from above.
/// @throws DomainError if nothing in the scene can turn: no painted shape, or neither lights nor an
///         environment that differs by direction
SceneDescription turned(SceneDescription scene, Turning what, double angle_deg);

}  // namespace nacre::render
