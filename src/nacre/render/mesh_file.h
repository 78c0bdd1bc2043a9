#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "nacre/render/mesh.h"

// Meshes from files: OBJ, PLY, STL, glTF 2.0. assimp parses the last, after a look at what it would
// trust: it was not made for files that mean harm, and writes beyond its memory for some of the others.

namespace nacre::render {

// Limits of a mesh's file.
inline constexpr std::size_t kMaxMeshBytes = std::size_t{1} << 30;  ///< with all buffers of a glTF
inline constexpr std::size_t kMaxMeshNodes = 100'000;               ///< of a glTF
inline constexpr int kMaxMeshNodeDepth = 256;
inline constexpr std::size_t kMaxMeshMaterials = 10'000;
inline constexpr unsigned kMaxFaceCorners =
    2000;  ///< the time of cutting a face into triangles goes with
           ///< their square
/// Vertices and indices of a glTF, those of a mesh counted once for each node that shows it.
inline constexpr double kMaxMeshElements = 1 << 26;

/// The mesh from the contents of its file.
/// @param file  its path is for messages, its extension names the format; buffers of a glTF are read
///              from its folder and below, and from nowhere else
/// @throws InputError as make_mesh(const MeshFile&)
/// @param parts  not null: for the names of all parts that the file has (MeshFile::part)
Mesh parse_mesh(std::string_view bytes, const MeshFile& file,
                std::set<std::string>* parts = nullptr);

/// The same from the bytes alone, for a file that came from elsewhere: nothing else is opened, and
/// buffers of a glTF stand in it.
/// @param max_elements  as kMaxMeshElements
Mesh parse_lone_mesh(std::string_view bytes, const MeshFile& file, double max_elements);

}  // namespace nacre::render
