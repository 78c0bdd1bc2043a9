#pragma once

#include <filesystem>
#include <vector>

namespace nacre::io {

/// The regular files that a recipe or a scene names, as far as they exist: optical constants,
/// meshes, pictures, recipes and what those name in turn. Any text in it that is the path of a file
/// counts, whatever its key, so that none is missed. Other files, and such as cannot be read, name
/// none.
std::vector<std::filesystem::path> files_named_by(const std::filesystem::path& file);

}  // namespace nacre::io
