#pragma once

#include <string>
#include <vector>

#include "nacre/render/scene.h"

namespace nacre::render {

/// The scenes that come with Nacre. Each shows one paint, in the material slot "paint": "sphere",
/// "panel", "curved-panel" and "speed-shape" in the built-in studio; for single flakes "macro", two
/// millimetres of a panel, and "panel-sun", a panel at arm's length in the sun.
std::vector<std::string> builtin_scene_names();

/// @throws InputError naming the text and the scenes that exist
SceneDescription builtin_scene(const std::string& name);

/// What it shows, for below a picture: "Ball of 100 mm, lit by soft boxes of daylight".
/// @throws InputError as builtin_scene()
std::string builtin_scene_caption(const std::string& name);

}  // namespace nacre::render
