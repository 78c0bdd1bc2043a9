#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/references.h"
#include "nacre/io/file_kind.h"
#include "nacre/render/scene.h"

// Scenes as TOML. Every key with its unit and range: docs/scene.md.

namespace nacre::render {

/// Reads a scene. Paths of meshes, recipes and pictures start from its folder; pictures, of the
/// environment and of materials, are read along with it, meshes and recipes are not. A scene that
/// came from elsewhere may be kept to its folder: `references` is then References::within(path's
/// folder).
///
/// @throws InputError naming file, line, column, key, value and what is allowed for the first
///         thing that is wrong
SceneDescription read_scene(const std::filesystem::path& path);
SceneDescription read_scene(const std::filesystem::path& path, const References& references);

/// The same from a text. `filename` is for messages; `references` are the files that it may name.
SceneDescription parse_scene(std::string_view text, const std::string& filename,
                             const References& references);
/// The same of a file that has been told apart, whatever it was found to be.
SceneDescription parse_scene(const io::TypedFile& file);

/// Sets negative values of a picture of light to 0 and says so; leaves them where they are too much.
/// @param name  for the message
/// @return what there is to say; empty: nothing
std::string without_negative_light(std::vector<float>& rgb, const std::string& name);

}  // namespace nacre::render
