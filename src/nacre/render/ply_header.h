#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace nacre::render {

/// What is wrong with a PLY file's header, or with its size given that header; empty if nothing.
/// assimp trusts the header's counts and may read on without end where a file is cut short, so a
/// file is looked at before assimp is.                                            [turk-1994]
std::optional<std::string> ply_fault(const std::filesystem::path& path);

}  // namespace nacre::render
