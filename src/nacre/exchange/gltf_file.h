#pragma once

#include <string>

#include "nacre/exchange/gltf_material.h"

namespace nacre::exchange {

/// A glTF 2.0 file in one piece that shows a material on a sphere of 0.1 m: JSON with the mesh in a
/// data URI, without textures.                                          [khronos-gltf-2021]
/// @param fit  what `extras` of the material says of its distance from the paint
std::string gltf_text(const GltfMaterial& material, const std::string& name,
                      const MaterialFit& fit);

}  // namespace nacre::exchange
