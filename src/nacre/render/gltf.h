#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

// glTF 2.0 as JSON: what a file may have before anything of it is trusted.     [khronos-gltf-2021]

namespace nacre::render {

/// The parts of a GLB container.
struct Glb {
    std::string_view json, buffer;
};

/// @throws MeshError
Glb open_glb(std::string_view bytes);
std::string glb_bytes(std::string json, std::string_view buffer);

/// A glTF that is one, of version 2 and without extensions that it requires.
class Gltf {
 public:
    /// @throws MeshError, nlohmann::json::exception
    explicit Gltf(std::string_view text);

    const nlohmann::json& whole() const { return whole_; }

    /// An array; empty where there is none.
    static const nlohmann::json& list(const nlohmann::json& object, const char* key);
    /// A number that is one of `size`.
    static std::size_t index(const nlohmann::json& number, std::size_t size, const char* what);

 private:
    nlohmann::json whole_;
};

/// The text of a glTF with its geometry and nothing else, so that what a mesh does not need is never
/// looked at: materials but for their names, textures, skins, animations, extensions. Nodes must be
/// trees, as the format has it, and small enough (render/mesh_file.h).
/// @throws MeshError, nlohmann::json::exception
/// @param max_elements  as kMaxMeshElements
std::string gltf_geometry(std::string_view text, double max_elements);

}  // namespace nacre::render
