#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/render/polygon_mesh.h"

// The readers of polygons (gltf.h has that of glTF), and what readers of meshes share.

namespace nacre::render {

/// What is wrong with a mesh's file. The caller, who knows the file's name, prepends it.
class MeshError : public Error {
 public:
    using Error::Error;
};

/// Vertices, faces and names of materials of a Wavefront OBJ [wavefront-1995]. Lines, points, curves,
/// groups and libraries of materials are passed over.
/// @throws MeshError naming the line, and nothing of what stands in it
PolygonMesh parse_obj(std::string_view text);

/// Vertices and faces of a PLY [turk-1994], text or binary of either order: positions, normals (nx, ny, nz),
/// texture coordinates of vertices (s, t; u, v; texture_u, texture_v) or corners (texcoord), faces and strips
/// of triangles. All else is passed over.
/// @throws MeshError
PolygonMesh parse_ply(std::string_view bytes);

/// Facets of an STL, text or binary, with their normals.                        [burns-1993]
/// @throws MeshError
PolygonMesh parse_stl(std::string_view bytes);

/// A message of a library without what it quotes of the file. A scene may name any file as a mesh,
/// one that the reader of the message may not be allowed to see among them.
inline std::string without_quotes(std::string message) {
    message.resize(std::min(message.size(), message.find("; last read: ")));  // nlohmann's
    const std::size_t first = message.find('"'), last = message.rfind('"');
    if (first != std::string::npos) message.replace(first, last - first + 1, "...");
    return excerpt(message, 200);
}

/// Four bytes, the lowest first.
inline std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

/// The next word of a text from `position`, which is left behind it; empty at the end.
inline std::string_view take_word(std::string_view text, std::size_t& position) {
    constexpr std::string_view kSpace = " \t\r\n\f\v";
    const std::size_t begin =
        std::min(text.find_first_not_of(kSpace, std::min(position, text.size())), text.size());
    position = std::min(text.find_first_of(kSpace, begin), text.size());
    return text.substr(begin, position - begin);
}

}  // namespace nacre::render
