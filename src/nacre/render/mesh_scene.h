#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "nacre/render/scene.h"

namespace nacre::render {

/// What scene_of_mesh() is told besides the file.
struct MeshSceneOptions {
    /// Parts of the mesh that are painted, by the names of their materials. Empty: the mesh itself if
    /// it has one part, else none.
    std::vector<std::string> painted = {};
    /// The name of a glTF's camera; empty: its first, if it has one.
    std::string camera = {};
};

/// A scene to start from: each part of a mesh as a shape of its own, lit by the studio. Of a glTF
/// come a perspective camera and the materials as far as a scene has their like: glass for what
/// transmits or blends, the metal of the nearest colour for what is metallic, plastic of the base
/// colour and roughness (alpha = roughness^2) for the rest; textures are left out. Parts of other
/// files are grey plastic. Without a camera one is placed so that all is seen.
///                                                                   [khronos-gltf-2021]
/// `notes` of the result says what was left out or chosen.
/// @throws InputError naming the file, and the names that exist where one does not
SceneDescription scene_of_mesh(const std::filesystem::path& path, const MeshSceneOptions& options);

}  // namespace nacre::render
