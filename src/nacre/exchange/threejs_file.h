#pragma once

#include <string>
#include <vector>

#include "nacre/exchange/webgl_shader.h"
#include "nacre/measure/difference.h"
#include "nacre/measure/geometry.h"

// A paint as a material of three.js: an ES module with the shader and its textures inside.

namespace nacre::exchange {

/// At which a shader says how far it is from its paint: byk-mac's six angles, and lamps at 15, 30, 60
/// and 75 deg.
const std::vector<measure::Geometry>& shader_geometries();

/// How far the shader's colours are from a paint's, as a display in linear Rec. 709 shows them.
/// @param standard  the paint, read under D65 for the 2 degree observer
measure::Difference shader_difference(const WebglShader& shader,
                                      const measure::Measurement& standard);

/// The module. Its `about` holds name, SHA-256 and differences.
/// @param name  of the paint @param recipe_sha256  of its recipe
/// @param difference  of shader_difference() @param standard  the model by which the paint was read for it
std::string threejs_text(const WebglShader& shader, const std::string& name,
                         const std::string& recipe_sha256, const measure::Difference& difference,
                         const std::string& standard);

}  // namespace nacre::exchange
