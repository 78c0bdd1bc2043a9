#pragma once

#include <filesystem>
#include <vector>

#include "nacre/core/references.h"

namespace nacre::io {

/// The regular files that a mesh names, as far as they exist: the buffers and pictures of a glTF, and the
/// materials of an OBJ with their pictures, though these are not read. Other files, and such as cannot
/// be read, name none. What recipes and scenes name shows as they are read: References::checked_by().
/// @param references  the files that an OBJ may name; others are left out
std::vector<std::filesystem::path> files_named_by(const std::filesystem::path& file,
                                                  const References& references);

}  // namespace nacre::io
