#pragma once

#include <string_view>

#include "nacre/render/polygon_mesh.h"

namespace nacre::render {

/// Vertices and faces of a PLY [turk-1994], text or binary of either order: positions, normals (nx, ny, nz),
/// texture coordinates of vertices (s, t; u, v; texture_u, texture_v) or corners (texcoord), faces and strips
/// of triangles. All else is passed over.
/// @throws MeshFault
PolygonMesh parse_ply(std::string_view bytes);

}  // namespace nacre::render
