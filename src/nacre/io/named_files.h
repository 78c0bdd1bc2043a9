#pragma once

#include <filesystem>
#include <vector>

#include "nacre/core/references.h"

namespace nacre::io {

/// The regular files that a recipe or a scene names, as far as they exist: optical constants,
/// meshes, pictures, recipes and what those name in turn. Any text in it that is the path of a file
/// counts, whatever its key, so that none is missed; in the same way the buffers and pictures of a
/// glTF count, and the materials of an OBJ with their pictures, though these are not read. Other
/// files, and such as cannot be read, name none.
/// @param references  the files that it may name; others are left out
std::vector<std::filesystem::path> files_named_by(const std::filesystem::path& file,
                                                  const References& references);

}  // namespace nacre::io
