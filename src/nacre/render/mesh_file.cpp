#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <limits>

#include "nacre/core/error.h"
#include "nacre/render/mesh.h"
#include "nacre/render/ply_header.h"

namespace nacre::render {
namespace {

bool is_finite(const aiVector3D& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[noreturn]] void refuse(const MeshFile& file, const std::string& reason) {
    throw InputError(fmt::format("mesh '{}': {}", file.path.string(), reason));
}

/// glTF's vertical is y by its specification.
bool is_y_up(const MeshFile& file) {
    const auto extension = file.path.extension();
    return file.y_up || extension == ".gltf" || extension == ".glb";
}

/// Texture coordinates as the file has them; none for the whole mesh if a part has none.
void append_uv(const aiMesh& part, Mesh& mesh) {
    const bool complete = mesh.uv.size() + part.mNumVertices == mesh.positions_mm.size();
    if (!complete || !part.HasTextureCoords(0)) {
        mesh.uv.clear();
        return;
    }
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D& t = part.mTextureCoords[0][i];
        if (!is_finite(t)) {
            mesh.uv.clear();
            return;
        }
        mesh.uv.push_back({t.x, t.y});
    }
}

void append(const aiMesh& part, const MeshFile& file, Mesh& mesh) {
    const auto first = mesh.positions_mm.size();
    if (first + part.mNumVertices > std::numeric_limits<std::uint32_t>::max()) {
        refuse(file, "has more than 2^32 vertices");
    }
    const auto turn = [y_up = is_y_up(file)](const aiVector3D& v) {
        return y_up ? Vec3f{v.x, -v.z, v.y} : Vec3f{v.x, v.y, v.z};
    };
    const auto scale = static_cast<float>(file.mm_per_unit);
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        if (!is_finite(part.mVertices[i])) {
            refuse(file, fmt::format("vertex {} of '{}' is not finite", i, part.mName.C_Str()));
        }
        mesh.positions_mm.push_back(scale * turn(part.mVertices[i]));
        // A vertex of degenerate triangles alone has no normal; it is never seen, any will do.
        const bool usable =
            part.HasNormals() && is_finite(part.mNormals[i]) && part.mNormals[i].SquareLength() > 0;
        mesh.normals.push_back(usable ? normalize(turn(part.mNormals[i])) : Vec3f{0, 0, 1});
    }
    append_uv(part, mesh);
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        if (face.mNumIndices != 3) continue;  // points and lines have no area
        std::array<std::uint32_t, 3> triangle{};
        for (int k = 0; k < 3; ++k) {
            if (face.mIndices[k] >= part.mNumVertices) {
                refuse(file, fmt::format("face {} names vertex {} of {}", i, face.mIndices[k],
                                         part.mNumVertices));
            }
            triangle[k] = static_cast<std::uint32_t>(first + face.mIndices[k]);
        }
        mesh.triangles.push_back(triangle);
    }
}

}  // namespace

Mesh make_mesh(const MeshFile& file) {
    std::error_code status;
    if (!std::filesystem::is_regular_file(file.path, status)) {
        refuse(file, "there is no such file");
    }
    if (file.path.extension() == ".ply") {
        if (const auto fault = ply_fault(file.path)) refuse(file, *fault);
    }
    Assimp::Importer importer;
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE,
                              static_cast<float>(file.crease_angle_deg));
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(
        file.path.string(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                aiProcess_GenSmoothNormals | aiProcess_PreTransformVertices |
                                aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0) {
        refuse(file, fmt::format("cannot be read: {}", importer.GetErrorString()));
    }
    Mesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], file, mesh);
    if (mesh.triangles.empty()) refuse(file, "has no triangles");
    return mesh;
}

}  // namespace nacre::render
