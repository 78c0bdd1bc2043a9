#include "nacre/render/mesh_file.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/references.h"
#include "nacre/core/text.h"
#include "nacre/render/gltf.h"
#include "nacre/render/mesh_formats.h"
#include "nacre/render/polygon_mesh.h"

namespace nacre::render {

namespace {

using nlohmann::json;

/// A file in memory.
class MemoryStream final : public Assimp::IOStream {
 public:
    explicit MemoryStream(std::string_view bytes) : bytes_(bytes) {}
    explicit MemoryStream(std::string owned) : owned_(std::move(owned)), bytes_(owned_) {}

    std::size_t Read(void* to, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t read = std::min(count, (bytes_.size() - position_) / size);
        std::memcpy(to, bytes_.data() + position_, read * size);
        position_ += read * size;
        return read;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t from = origin == aiOrigin_SET   ? 0
                                 : origin == aiOrigin_CUR ? position_
                                                          : bytes_.size();
        if (offset > bytes_.size() - from) return aiReturn_FAILURE;
        position_ = from + offset;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return position_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

 private:
    std::string owned_;
    std::string_view bytes_;
    std::size_t position_ = 0;
};

/// What assimp may open: the mesh itself, under a name without a folder, and the files that a mesh
/// may name, with all their bytes bounded.
class MeshFiles final : public Assimp::IOSystem {
 public:
    /// @param bytes_left  of the files that it may name, together
    MeshFiles(std::string name, std::string_view bytes, References references,
              std::size_t bytes_left)
        : name_(std::move(name)),
          bytes_(bytes),
          references_(std::move(references)),
          bytes_left_(bytes_left) {}

    bool Exists(const char* name) const override { return name == name_; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char*) override {
        if (name == name_) return new MemoryStream(bytes_);
        if (references_ == References()) return nullptr;  // its buffers stand in it
        std::string bytes = read_file(references_.resolve(name), bytes_left_);
        bytes_left_ -= bytes.size();
        return new MemoryStream(std::move(bytes));
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
    std::string name_;
    std::string_view bytes_;
    References references_;
    std::size_t bytes_left_;
};

/// Leaves one of assimp's dozens of importers.
void keep_only(Assimp::Importer& importer, const char* name) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        Assimp::BaseImporter* one = importer.GetImporter(i);
        if (std::string_view(importer.GetImporterInfo(i)->mName) == name) continue;
        importer.UnregisterLoader(one);
        delete one;
    }
}

/// Post-processing asserts that faces have vertices, which ends the program.
void require_vertices(const aiScene& scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices == 0) throw MeshError(fmt::format("face {} has no vertices", f));
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                if (face.mIndices[k] >= mesh.mNumVertices) {
                    throw MeshError(fmt::format("face {} names vertex {} of {}", f,
                                                face.mIndices[k], mesh.mNumVertices));
                }
            }
        }
    }
}

std::string material_name(const aiScene& scene, const aiMesh& part) {
    if (part.mMaterialIndex >= scene.mNumMaterials) return {};
    return scene.mMaterials[part.mMaterialIndex]->GetName().C_Str();
}

/// Triangles of a part, after those of the mesh.
void append(const aiMesh& part, const std::string& material, PolygonMesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    if (mesh.positions.size() + part.mNumVertices >= PolygonMesh::kNone) {
        throw MeshError("has more than 2^32 vertices");
    }
    const auto vec = [](const aiVector3D& v) { return Vec3f{v.x, v.y, v.z}; };
    const bool normals = part.HasNormals(), uv = part.HasTextureCoords(0);
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        mesh.positions.push_back(vec(part.mVertices[i]));
        mesh.normals.push_back(normals ? vec(part.mNormals[i]) : Vec3f{0, 0, 0});
        mesh.uv.push_back(uv ? Vec2f{part.mTextureCoords[0][i].x, part.mTextureCoords[0][i].y}
                             : Vec2f{0, 0});
    }
    const std::uint32_t number = mesh.material_of(material);
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
        const aiFace& face = part.mFaces[f];
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            const std::uint32_t i = first + face.mIndices[k];
            mesh.corners.push_back(
                {i, uv ? i : PolygonMesh::kNone, normals ? i : PolygonMesh::kNone});
        }
        mesh.end_face(number);  // points and lines have no area
    }
}

/// @param bytes  of gltf_geometry(), which assimp may trust
PolygonMesh parse_gltf(std::string_view bytes, const std::string& extension,
                       const References& references, std::size_t bytes_left) {
    constexpr const char* kGltfImporter = "glTF2 Importer";
    Assimp::Importer importer;
    keep_only(importer, kGltfImporter);
    if (importer.GetImporterCount() != 1) {
        throw Error(fmt::format("this assimp has no '{}'", kGltfImporter));
    }
    const std::string name = "mesh" + extension;
    importer.SetIOHandler(new MeshFiles(name, bytes, references, bytes_left));  // which deletes it
    const aiScene* scene = importer.ReadFile(name, 0);
    if (scene) {
        require_vertices(*scene);
        scene = importer.ApplyPostProcessing(aiProcess_PreTransformVertices |
                                             aiProcess_ValidateDataStructure);
    }
    if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0) {
        throw MeshError(
            fmt::format("cannot be read: {}", without_quotes(importer.GetErrorString())));
    }
    require_vertices(*scene);
    PolygonMesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        append(*scene->mMeshes[i], material_name(*scene, *scene->mMeshes[i]), mesh);
    }
    return mesh;
}

/// @param beside  the files that a glTF may name
Mesh parse(std::string_view bytes, const MeshFile& file, const References& beside,
           double max_elements, std::set<std::string>* parts) {
    const std::string extension = lowercase(file.path.extension().string());
    const auto made = [&](const PolygonMesh& polygons) {
        // glTF's vertical is y and its unit the metre by its specification.    [khronos-gltf-2021]
        const bool gltf = extension == ".gltf" || extension == ".glb";
        const double mm_per_unit = file.mm_per_unit > 0 ? file.mm_per_unit : gltf ? 1000 : 1;
        return triangles_of(polygons, file, static_cast<float>(mm_per_unit), file.y_up || gltf,
                            parts);
    };
    const std::size_t bytes_left = kMaxMeshBytes - std::min(kMaxMeshBytes, bytes.size());
    if (extension == ".obj") {
        if (bytes.find('\0') != std::string_view::npos) throw MeshError("is no OBJ: is not text");
        return made(parse_obj(bytes));
    }
    if (extension == ".ply") return made(parse_ply(bytes));
    if (extension == ".stl") return made(parse_stl(bytes));
    if (extension == ".gltf") {
        return made(parse_gltf(gltf_geometry(bytes, max_elements), extension, beside, bytes_left));
    }
    if (extension == ".glb") {
        const Glb glb = open_glb(bytes);
        return made(parse_gltf(glb_bytes(gltf_geometry(glb.json, max_elements), glb.buffer),
                               extension, beside, bytes_left));
    }
    throw MeshError("is none of .obj, .ply, .stl, .gltf and .glb");
}

/// Says whose fault it is.
template <class Parse>
Mesh named(const MeshFile& file, const Parse& parse) {
    const auto refuse = [&](const char* why) {
        throw InputError(fmt::format("mesh '{}': {}", file.path.string(), why));
    };
    try {
        return parse();
    } catch (const MeshError& fault) {
        refuse(fault.what());
    } catch (const json::exception& fault) {
        refuse(fmt::format("is no glTF 2.0: {}", without_quotes(fault.what())).c_str());
    }
    throw std::logic_error("a mesh is read or refused");
}

}  // namespace

Mesh parse_mesh(std::string_view bytes, const MeshFile& file, std::set<std::string>* parts) {
    return named(file, [&] {
        return parse(bytes, file, References::within(file.path.parent_path()), kMaxMeshElements,
                     parts);
    });
}

Mesh parse_lone_mesh(std::string_view bytes, const MeshFile& file, double max_elements) {
    return named(file, [&] { return parse(bytes, file, References(), max_elements, nullptr); });
}

Mesh make_mesh(const MeshFile& file) {
    if (file.read) return *file.read;
    try {
        return parse_mesh(read_file(file.path, kMaxMeshBytes), file);
    } catch (const InputError& error) {
        throw InputError(file.named_at.place + error.what());
    }
}

}  // namespace nacre::render
