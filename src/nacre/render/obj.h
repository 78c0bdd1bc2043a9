#pragma once

#include <string>
#include <string_view>

namespace nacre::render {

/// The vertices, faces and names of materials of a Wavefront OBJ, checked and written anew in their
/// plainest form, which is all that assimp gets to read: it trusts a file's indices and the shape of its
/// lines, and writes beyond its memory where they are wrong. Faces are grouped by material. Lines, points,
/// curves, groups and comments are left out.                                        [wavefront-1995]
/// @throws MeshFault naming the line, and nothing of what stands in it
std::string plain_obj(std::string_view text);

}  // namespace nacre::render
