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
#include "nacre/render/mesh_fault.h"
#include "nacre/render/obj.h"
#include "nacre/render/ply.h"
#include "nacre/render/smooth_normals.h"

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
    MeshFiles(std::string name, std::string_view bytes, References references)
        : name_(std::move(name)), bytes_(bytes), references_(std::move(references)) {}

    bool Exists(const char* name) const override { return name == name_; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char*) override {
        if (name == name_) return new MemoryStream(bytes_);
        if (references_ == References()) return nullptr;  // such as the materials of an OBJ
        std::string bytes = read_file(references_.resolve(name), bytes_left_);
        bytes_left_ -= bytes.size();
        return new MemoryStream(std::move(bytes));
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
    std::string name_;
    std::string_view bytes_;
    References references_;
    std::size_t bytes_left_ = kMaxMeshBytes;
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

/// Post-processing asserts that faces have vertices, which ends the program, and takes the longer the more
/// one has.
void require_vertices(const aiScene& scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices == 0) throw MeshFault(fmt::format("face {} has no vertices", f));
            if (face.mNumIndices > kMaxFaceCorners) {
                throw MeshFault(fmt::format("face {} has {} corners; at most {} are read", f,
                                            face.mNumIndices, kMaxFaceCorners));
            }
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                if (face.mIndices[k] >= mesh.mNumVertices) {
                    throw MeshFault(fmt::format("face {} names vertex {} of {}", f,
                                                face.mIndices[k], mesh.mNumVertices));
                }
            }
        }
    }
}

bool is_finite(const aiVector3D& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Triangles of a part, their vertices after those of the mesh.
void append(const aiMesh& part, float mm_per_unit, bool y_up, double crease_angle_deg, Mesh& mesh) {
    const auto turn = [y_up](const aiVector3D& v) {
        return y_up ? Vec3f{v.x, -v.z, v.y} : Vec3f{v.x, v.y, v.z};
    };
    std::vector<unsigned> corners;
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        if (face.mNumIndices != 3) continue;  // points and lines have no area
        corners.insert(corners.end(), face.mIndices, face.mIndices + 3);
    }
    const std::size_t first = mesh.positions_mm.size();
    if (first + corners.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw MeshFault("has more than 2^32 vertices");
    }
    // Texture coordinates as the file has them; none for the whole mesh if a part has none.
    bool laid_out = mesh.uv.size() == first && part.HasTextureCoords(0);
    for (const unsigned i : corners) {
        if (!is_finite(part.mVertices[i])) {
            throw MeshFault(
                fmt::format("vertex {} of '{}' is not finite", i, excerpt(part.mName.C_Str())));
        }
        mesh.positions_mm.push_back(mm_per_unit * turn(part.mVertices[i]));
        laid_out = laid_out && is_finite(part.mTextureCoords[0][i]);
        if (laid_out) mesh.uv.push_back({part.mTextureCoords[0][i].x, part.mTextureCoords[0][i].y});
    }
    if (!laid_out) mesh.uv.clear();

    const auto normal_of_file = [&](unsigned i) {
        const aiVector3D n = part.HasNormals() ? part.mNormals[i] : aiVector3D();
        return is_finite(n) && n.SquareLength() > 0 ? normalize(turn(n)) : Vec3f{0, 0, 0};
    };
    std::vector<Vec3f> made;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        Vec3f normal = normal_of_file(corners[k]);
        if (normal == Vec3f{0, 0, 0}) {
            if (made.empty()) {
                made = smooth_normals(std::span(mesh.positions_mm).subspan(first), crease_angle_deg);
            }
            normal = made[k];
        }
        mesh.normals.push_back(normal);
    }
    for (std::size_t k = first; k < mesh.positions_mm.size(); k += 3) {
        const auto i = static_cast<std::uint32_t>(k);
        mesh.triangles.push_back({i, i + 1, i + 2});
    }
}

std::string material_name(const aiScene& scene, const aiMesh& part) {
    if (part.mMaterialIndex >= scene.mNumMaterials) return {};
    return scene.mMaterials[part.mMaterialIndex]->GetName().C_Str();
}

[[noreturn]] void refuse_part(const std::string& part, const std::set<std::string>& names) {
    std::vector<std::string> shown;
    for (const std::string& name : names) shown.push_back(excerpt(name));
    throw MeshFault(fmt::format("has no material '{}'{}; its materials are '{}'", excerpt(part),
                                did_you_mean(excerpt(part), shown), fmt::join(shown, "', '")));
}

Mesh read_with_assimp(std::string_view bytes, const std::string& extension,
                      const char* importer_name, const References& references, const MeshFile& file,
                      std::set<std::string>* parts) {
    Assimp::Importer importer;
    keep_only(importer, importer_name);
    if (importer.GetImporterCount() != 1) {
        throw Error(fmt::format("this assimp has no '{}'", importer_name));
    }
    const std::string name = "mesh" + extension;
    importer.SetIOHandler(new MeshFiles(name, bytes, references));  // which deletes it
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(name, 0);
    if (scene) {
        require_vertices(*scene);
        scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_PreTransformVertices |
                                             aiProcess_SortByPType |
                                             aiProcess_ValidateDataStructure);
    }
    if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0) {
        throw MeshFault(
            fmt::format("cannot be read: {}", without_quotes(importer.GetErrorString())));
    }
    require_vertices(*scene);
    Mesh mesh;
    // glTF's vertical is y and its unit the metre by its specification.        [khronos-gltf-2021]
    const bool gltf = extension == ".gltf" || extension == ".glb";
    const double mm_per_unit = file.mm_per_unit > 0 ? file.mm_per_unit : gltf ? 1000 : 1;
    std::set<std::string> names;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        const aiMesh& part = *scene->mMeshes[i];
        const std::string name = material_name(*scene, part);
        names.insert(name);
        if (!file.part.empty() && name != file.part) continue;
        append(part, static_cast<float>(mm_per_unit), file.y_up || gltf, file.crease_angle_deg, mesh);
    }
    if (!file.part.empty() && !names.contains(file.part)) refuse_part(file.part, names);
    if (mesh.triangles.empty()) throw MeshFault("has no triangles");
    join_equal_vertices(mesh);
    if (parts) *parts = std::move(names);
    return mesh;
}

constexpr const char* kGltfImporter = "glTF2 Importer";

/// @param beside  the files that a glTF may name
Mesh parse(std::string_view bytes, const MeshFile& file, const References& beside,
           double max_elements, std::set<std::string>* parts) {
    const std::string extension = lowercase(file.path.extension().string());
    if (extension == ".obj") {
        if (bytes.find('\0') != std::string_view::npos) throw MeshFault("is no OBJ: is not text");
        return read_with_assimp(plain_obj(bytes), extension, "Wavefront Object Importer", {}, file,
                                parts);
    }
    if (extension == ".ply") {
        check_ply(bytes);
        return read_with_assimp(bytes, extension, "Stanford Polygon Library (PLY) Importer", {},
                                file, parts);
    }
    if (extension == ".stl") {
        return read_with_assimp(bytes, extension, "Stereolithography (STL) Importer", {}, file,
                                parts);
    }
    if (extension == ".gltf") {
        return read_with_assimp(gltf_geometry(bytes, max_elements), extension, kGltfImporter,
                                beside, file, parts);
    }
    if (extension == ".glb") {
        const Glb glb = open_glb(bytes);
        return read_with_assimp(glb_bytes(gltf_geometry(glb.json, max_elements), glb.buffer),
                                extension, kGltfImporter, beside, file, parts);
    }
    throw MeshFault("is none of .obj, .ply, .stl, .gltf and .glb");
}

/// Says whose fault it is.
template <class Parse>
Mesh named(const MeshFile& file, const Parse& parse) {
    const auto refuse = [&](const char* why) {
        throw InputError(fmt::format("mesh '{}': {}", file.path.string(), why));
    };
    try {
        return parse();
    } catch (const MeshFault& fault) {
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
    return parse_mesh(read_file(file.path, kMaxMeshBytes), file);
}

}  // namespace nacre::render
