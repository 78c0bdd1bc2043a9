#pragma once

#include <string_view>

#include "nacre/render/polygon_mesh.h"

namespace nacre::render {

/// Facets of an STL, text or binary, with their normals.                        [burns-1993]
/// @throws MeshFault
PolygonMesh parse_stl(std::string_view bytes);

}  // namespace nacre::render
