#pragma once

#include <string_view>

#include "nacre/render/polygon_mesh.h"

namespace nacre::render {

/// Vertices, faces and names of materials of a Wavefront OBJ [wavefront-1995]. Lines, points, curves,
/// groups and libraries of materials are passed over.
/// @throws MeshFault naming the line, and nothing of what stands in it
PolygonMesh parse_obj(std::string_view text);

}  // namespace nacre::render
