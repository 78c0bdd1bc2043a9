#pragma once

#include <string_view>

namespace nacre::render {

/// Checks a PLY file's header, and its size given that header: assimp trusts the counts, and may
/// read on without end where a file is cut short.                                  [turk-1994]
/// @throws MeshFault
void check_ply(std::string_view bytes);

}  // namespace nacre::render
