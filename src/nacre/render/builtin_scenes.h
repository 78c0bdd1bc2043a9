#pragma once

#include <string>
#include <vector>

#include "nacre/render/scene_description.h"

namespace nacre::render {

/// The scenes that come with Nacre: "sphere", "panel", "curved-panel", "speed-shape". Each shows
/// one paint, in the material slot "paint", in the built-in studio.
std::vector<std::string> builtin_scene_names();

/// @throws InputError naming the text and the scenes that exist
SceneDescription builtin_scene(const std::string& name);

}  // namespace nacre::render
