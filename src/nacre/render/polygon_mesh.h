#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/render/mesh.h"

// What a file of a mesh says, whatever its format, and how triangles with normals are made of it.

namespace nacre::render {

/// Polygons of any number of corners, in the units and axes of a file.
struct PolygonMesh {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    /// Numbers of a position, a texture coordinate and a normal; the last two may be kNone.
    struct Corner {
        std::uint32_t position = kNone, uv = kNone, normal = kNone;
    };

    std::vector<Vec3f> positions, normals;
    std::vector<Vec2f> uv;
    std::vector<Corner> corners;          ///< of all faces, one after the other, counter-clockwise
    std::vector<std::uint32_t> end;       ///< of each face, the corner after its last
    std::vector<std::uint32_t> material;  ///< of each face
    std::map<std::string, std::uint32_t> materials;  ///< numbers by name

    /// Corners since the last face become one, unless they are fewer than three, which have no area.
    /// @throws MeshError for more than kMaxFaceCorners
    void end_face(std::uint32_t of_material);
    /// The number of this name, which is added if it is new.
    /// @throws MeshError for more than kMaxMeshMaterials
    std::uint32_t material_of(const std::string& name);
};

/// Of faces without a material.
inline constexpr const char* kUnnamedMaterial = "DefaultMaterial";

/// Triangles of the faces; of one material alone if the file's description names it.
///
/// Vertices that are equal to the last digit become one. Texture coordinates are kept if every corner has
/// one, normals wherever they have a length; others are made: smooth_normals() of each material.
/// @param parts  not null: for the names of the materials that faces have
/// @throws MeshError
Mesh triangles_of(const PolygonMesh& polygons, const MeshFile& file, float mm_per_unit, bool y_up,
                  std::set<std::string>* parts);

/// Cuts a polygon into triangles by clipping ears [meisters-1975]: corners whose triangle holds no other
/// corner, seen along the polygon's mean normal. Of a polygon that has none, as it crosses itself, corners
/// are cut off in their order.
/// @param steps  corners that may still be looked at, of all polygons of a file; counted down
/// @return for each of the n - 2 triangles three numbers of corners
/// @throws MeshError if the steps do not suffice
std::vector<std::array<std::uint32_t, 3>> cut_into_triangles(std::span<const Vec3f> polygon,
                                                             double& steps);

/// Normals for meshes that have none: at each corner of a triangle the mean over the triangles that meet
/// in its position, weighted by their angles there [thurmer-1998], of those whose planes lie within the
/// crease angle of its own. Where more than 1024 meet, of all: the time goes with the square of that.
///
/// Positions are the same where they are equal to the last digit, as in a file that says a vertex once or
/// writes it anew for each triangle.
///
/// @param corners  positions of triangles, three each, counter-clockwise seen from outside
/// @return one a corner, of length 1; {0, 0, 1} where a triangle without area meets no other
std::vector<Vec3f> smooth_normals(std::span<const Vec3f> corners, double crease_angle_deg);

/// Makes one vertex of those that are equal to the last digit, in the order in which they are met.
void join_equal_vertices(Mesh& mesh);

}  // namespace nacre::render
