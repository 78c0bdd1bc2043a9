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
#include <string>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/references.h"
#include "nacre/core/text.h"

namespace nacre::render {

namespace {

using nlohmann::json;

/// What is wrong with a file; its name is put in front.
class Fault : public Error {
 public:
    using Error::Error;
};

/// A message of a library without what it quotes of the file. A scene may name any file as a mesh,
/// and what stands in it is not for the eyes of whoever sees the message.
std::string without_quotes(std::string message) {
    message.resize(std::min(message.size(), message.find("; last read: ")));  // nlohmann's
    const std::size_t first = message.find('"'), last = message.rfind('"');
    if (first != std::string::npos) message.replace(first, last - first + 1, "...");
    return excerpt(message, 200);
}

// -------------------------------------------------------------------------------------- PLY

/// Checks a PLY file's header, and its size given that header: assimp trusts the counts, and may
/// read on without end where a file is cut short.                                  [turk-1994]
class PlyCheck {
 public:
    explicit PlyCheck(std::string_view bytes) : bytes_(bytes) {}

    void run() {
        read_header();
        binary_ ? check_binary() : check_text();
    }

 private:
    struct Property {
        bool list = false;
        int length_size = 0;  ///< bytes of a list's length
        int size = 0;         ///< bytes of a value
    };
    struct Element {
        double count = 0;  // a double: counts may overflow integers
        std::vector<Property> properties;
    };

    /// Bytes of a scalar in a binary file.
    static int scalar_size(std::string_view type, int line) {
        static const std::map<std::string_view, int> kSizes{
            {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
            {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
            {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
        const auto found = kSizes.find(type);
        if (found == kSizes.end()) {
            throw Fault(fmt::format("line {}: unknown type '{}'", line, excerpt(type)));
        }
        return found->second;
    }

    void read_header() {
        constexpr int kMaxHeaderLines = 1000;
        for (int line = 1; line <= kMaxHeaderLines && position_ < bytes_.size(); ++line) {
            const std::string_view rest = bytes_.substr(position_);
            const std::string_view text = rest.substr(0, rest.find('\n'));
            position_ += std::min(text.size() + 1, rest.size());
            const std::vector<std::string_view> word = words(text);
            if (line == 1 && (word.empty() || word[0] != "ply")) {
                throw Fault("line 1: does not begin with 'ply'");
            }
            if (word.empty()) continue;
            if (word[0] == "end_header") return;
            if (word[0] == "format" && word.size() > 1) {
                binary_ = word[1] != "ascii";
                big_endian_ = word[1] == "binary_big_endian";
            }
            if (word[0] == "element") {
                const auto count = word.size() > 2 ? parse_number(word[2]) : std::nullopt;
                if (!count || *count < 0) {
                    throw Fault(fmt::format("line {}: '{}' is not 'element NAME COUNT'", line,
                                            excerpt(text)));
                }
                elements_.push_back({*count, {}});
            }
            if (word[0] == "property" && !elements_.empty()) {
                elements_.back().properties.push_back(property_of(word, line));
            }
        }
        throw Fault("has no end_header");
    }

    static Property property_of(const std::vector<std::string_view>& word, int line) {
        const auto type = [&](std::size_t i) {
            return scalar_size(i < word.size() ? word[i] : std::string_view(), line);
        };
        if (word.size() > 1 && word[1] == "list") return {true, type(2), type(3)};
        return {false, 0, type(1)};
    }

    [[noreturn]] static void refuse_short(double wanted, std::size_t there) {
        throw Fault(
            fmt::format("is cut short: its header asks for at least {:.0f} bytes of data, "
                        "there are {}",
                        wanted, there));
    }

    /// The least bytes of all elements, a value taking `text_size` where the file is text.
    double least_bytes(int text_size) const {
        double least = 0;
        for (const Element& element : elements_) {
            double one = 0;
            for (const Property& p : element.properties) {
                one += binary_ ? (p.list ? p.length_size : p.size) : text_size;
            }
            if (one == 0 && element.count > 0) throw Fault("has an element without properties");
            least += element.count * one;
        }
        return least;
    }

    void check_text() const {
        // One digit and one space a value; the last may do without its space.
        const double least = least_bytes(2);
        const std::size_t there = bytes_.size() - position_;
        if (least > static_cast<double>(there) + 1) refuse_short(least, there);
    }

    /// Goes from list to list.
    void check_binary() {
        const std::size_t there = bytes_.size() - position_;
        const double least = least_bytes(0);
        if (least > static_cast<double>(there)) refuse_short(least, there);
        for (const Element& element : elements_) {
            for (double i = 0; i < element.count; ++i) {
                for (const Property& p : element.properties) {
                    const std::size_t size =
                        p.list ? list_bytes(p) : static_cast<std::size_t>(p.size);
                    if (size > bytes_.size() - position_) throw Fault("is cut short");
                    position_ += size;
                }
            }
        }
    }

    /// Of the list that starts here.
    std::size_t list_bytes(const Property& list) const {
        const auto length_size = static_cast<std::size_t>(list.length_size);
        if (length_size > bytes_.size() - position_) throw Fault("is cut short");
        if (length_size > 4) throw Fault("has a list whose length is no integer");
        std::size_t length = 0;
        for (std::size_t i = 0; i < length_size; ++i) {
            const std::size_t at = big_endian_ ? i : length_size - 1 - i;
            length = length << 8 | static_cast<unsigned char>(bytes_[position_ + at]);
        }
        return length_size + length * static_cast<std::size_t>(list.size);
    }

    std::string_view bytes_;
    std::size_t position_ = 0;
    bool binary_ = false, big_endian_ = false;
    std::vector<Element> elements_;
};

// ------------------------------------------------------------------------------------- glTF

/// The parts of a GLB container.
struct Glb {
    std::string_view json, buffer;
};

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

constexpr std::string_view kGlbMagic = "glTF";
constexpr std::uint32_t kGlbVersion = 2, kJsonChunk = 0x4E4F534A, kBufferChunk = 0x004E4942;
constexpr std::size_t kGlbHeader = 12, kGlbChunkHeader = 8;

Glb open_glb(std::string_view bytes) {
    if (!bytes.starts_with(kGlbMagic) || bytes.size() < kGlbHeader) {
        throw Fault("is no binary glTF: does not begin with 'glTF'");
    }
    const std::uint32_t version = little_endian(bytes, 4), length = little_endian(bytes, 8);
    if (version != kGlbVersion) throw Fault(fmt::format("is glTF {}; 2 is read", version));
    if (length > bytes.size()) {
        throw Fault(fmt::format("is cut short: it says that it has {} bytes, there are {}", length,
                                bytes.size()));
    }
    Glb glb;
    for (std::size_t at = kGlbHeader; at + kGlbChunkHeader <= length;) {
        const std::size_t size = little_endian(bytes, at);
        const std::uint32_t type = little_endian(bytes, at + 4);
        at += kGlbChunkHeader;
        if (size > length - at) throw Fault("is cut short: a chunk is longer than the file");
        if (type == kJsonChunk) glb.json = bytes.substr(at, size);
        if (type == kBufferChunk) glb.buffer = bytes.substr(at, size);
        at += size;
    }
    return glb;
}

std::string glb_bytes(std::string json, std::string_view buffer) {
    std::string out(kGlbMagic);
    const auto add = [&](std::size_t number) {
        for (int i = 0; i < 4; ++i) out += static_cast<char>(number >> (8 * i) & 0xff);
    };
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t padded = (buffer.size() + 3) / 4 * 4;
    add(kGlbVersion);
    add(kGlbHeader + kGlbChunkHeader + json.size() +
        (buffer.empty() ? 0 : kGlbChunkHeader + padded));
    add(json.size());
    add(kJsonChunk);
    out += json;
    if (buffer.empty()) return out;
    add(padded);
    add(kBufferChunk);
    out += buffer;
    out.resize(out.size() + padded - buffer.size(), '\0');
    return out;
}

/// The geometry of a glTF and nothing else, so that what a mesh does not need is never looked at:
/// materials but for their names, textures, skins, animations, extensions. Nodes must be trees, as the format has it,
/// and small enough.                                                           [khronos-gltf-2021]
class GltfGeometry {
 public:
    /// @throws Fault, json::exception
    explicit GltfGeometry(std::string_view text) : whole_(parse(text)) {
        if (!whole_.is_object()) throw Fault("is no glTF: a table in braces is expected");
        const std::string version = whole_.at("asset").at("version");
        if (!version.starts_with("2.")) {
            throw Fault(fmt::format("is glTF {}; 2 is read", excerpt(version)));
        }
        for (const json& name : list(whole_, "extensionsRequired")) {
            throw Fault(fmt::format("needs the extension {}, which is not read",
                                    excerpt(name.get<std::string>())));
        }
        copy_meshes();
        copy_nodes();
        check_trees();
    }

    std::string text() const { return out_.dump(-1, ' ', false, json::error_handler_t::replace); }

 private:
    static json parse(std::string_view text) {
        constexpr std::size_t kMaxTextBytes = std::size_t{1} << 28;
        static constexpr int kDeepest = 64;
        if (text.size() > kMaxTextBytes) {
            throw Fault(fmt::format("has more than {} bytes of JSON", kMaxTextBytes));
        }
        // The parser itself does not recurse.
        return json::parse(text.begin(), text.end(), [](int depth, json::parse_event_t, json&) {
            if (depth > kDeepest) throw Fault(fmt::format("is nested more than {} deep", kDeepest));
            return true;
        });
    }

    /// An array; empty where there is none.
    static const json& list(const json& object, const char* key) {
        static const json none = json::array();
        const auto found = object.find(key);
        if (found == object.end()) return none;
        if (!found->is_array()) throw Fault(fmt::format("{} is no list", key));
        return *found;
    }

    /// These keys of each entry of a list.
    static json entries(const json& object, const char* key,
                        std::initializer_list<const char*> kept) {
        json copies = json::array();
        for (const json& entry : list(object, key)) copies.push_back(only(entry, kept));
        return copies;
    }
    static json only(const json& object, std::initializer_list<const char*> kept) {
        json copy = json::object();
        for (const char* key : kept) {
            if (object.contains(key)) copy[key] = object.at(key);
        }
        return copy;
    }

    static std::size_t index(const json& number, std::size_t size, const char* what) {
        if (!number.is_number_unsigned() || number.get<std::size_t>() >= size) {
            throw Fault(fmt::format("names a {} that it does not have", what));
        }
        return number.get<std::size_t>();
    }

    double accessor_count(const json& number) const {
        const json& accessors = list(whole_, "accessors");
        return accessors[index(number, accessors.size(), "accessor")].at("count").get<double>();
    }

    void copy_meshes() {
        out_["asset"] = {{"version", "2.0"}};
        out_["buffers"] = entries(whole_, "buffers", {"byteLength", "uri"});
        out_["bufferViews"] = entries(
            whole_, "bufferViews", {"buffer", "byteOffset", "byteLength", "byteStride", "target"});
        out_["accessors"] = entries(whole_, "accessors",
                                    {"bufferView", "byteOffset", "componentType", "normalized",
                                     "count", "type", "min", "max"});
        double all = 0;
        for (const json& accessor : list(whole_, "accessors")) {
            if (accessor.contains("sparse"))
                throw Fault("has a sparse accessor, which is not read");
            all += accessor.at("count").get<double>();
            if (!(all <= kMaxMeshElements)) refuse_size();
        }
        const std::size_t materials = copy_material_names();
        out_["meshes"] = json::array();
        for (const json& mesh : list(whole_, "meshes")) {
            json primitives = json::array();
            double elements = 0;
            for (const json& primitive : list(mesh, "primitives")) {
                json copy = only(primitive, {"indices", "mode"});
                const json& attributes = primitive.at("attributes");
                copy["attributes"] = only(attributes, {"POSITION", "NORMAL", "TEXCOORD_0"});
                for (const json& accessor : copy["attributes"]) {
                    elements += accessor_count(accessor);
                }
                if (primitive.contains("material")) {
                    copy["material"] = index(primitive["material"], materials, "material");
                }
                if (copy.contains("indices")) elements += accessor_count(copy["indices"]);
                primitives.push_back(std::move(copy));
            }
            out_["meshes"].push_back({{"primitives", std::move(primitives)}});
            mesh_elements_.push_back(elements);
        }
    }

    /// @return how many there are
    std::size_t copy_material_names() {
        out_["materials"] = json::array();
        for (const json& material : list(whole_, "materials")) {
            const auto name = material.find("name");
            const bool named = name != material.end() && name->is_string();
            out_["materials"].push_back({{"name", named ? *name : json("")}});
        }
        return out_["materials"].size();
    }

    void copy_nodes() {
        out_["nodes"] = entries(whole_, "nodes",
                                {"children", "mesh", "matrix", "translation", "rotation", "scale"});
        out_["scenes"] = entries(whole_, "scenes", {"nodes"});
        if (whole_.contains("scene")) out_["scene"] = whole_["scene"];
        if (out_["nodes"].size() > kMaxMeshNodes) {
            throw Fault(fmt::format("has {} nodes; at most {} are read", out_["nodes"].size(),
                                    kMaxMeshNodes));
        }
    }

    [[noreturn]] static void refuse_size() {
        throw Fault(
            fmt::format("has more than {:.0f} vertices and indices, counted for each node "
                        "that shows them",
                        kMaxMeshElements));
    }

    /// Each node must have one parent at most, and none be its own descendant.
    void check_trees() const {
        const json& nodes = list(out_, "nodes");
        std::vector<bool> has_parent(nodes.size(), false);
        for (const json& node : nodes) {
            for (const json& child : list(node, "children")) {
                const std::size_t i = index(child, nodes.size(), "node");
                if (has_parent[i]) throw Fault(fmt::format("node {} has two parents", i));
                has_parent[i] = true;
            }
        }
        double elements = 0;
        std::size_t reached = 0;
        std::vector<std::size_t> level, next;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!has_parent[i]) level.push_back(i);
        }
        for (int depth = 1; !level.empty(); ++depth, level.swap(next), next.clear()) {
            if (depth > kMaxMeshNodeDepth) {
                throw Fault(fmt::format("has nodes more than {} deep", kMaxMeshNodeDepth));
            }
            for (const std::size_t i : level) {
                ++reached;
                if (nodes[i].contains("mesh")) {
                    elements +=
                        mesh_elements_[index(nodes[i]["mesh"], mesh_elements_.size(), "mesh")];
                }
                if (!(elements <= kMaxMeshElements)) refuse_size();
                for (const json& child : list(nodes[i], "children")) next.push_back(child);
            }
        }
        if (reached != nodes.size()) throw Fault("has a node that is its own descendant");
        for (const json& scene : list(out_, "scenes")) {
            std::set<std::size_t> roots;
            for (const json& root : list(scene, "nodes")) {
                const std::size_t i = index(root, nodes.size(), "node");
                if (has_parent[i] || !roots.insert(i).second) {
                    throw Fault(fmt::format("node {} is shown twice in a scene", i));
                }
            }
        }
    }

    json whole_, out_;
    std::vector<double> mesh_elements_;
};

// ----------------------------------------------------------------------------------- assimp

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

/// Post-processing asserts that faces have vertices, which ends the program.
void require_vertices(const aiScene& scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices == 0) throw Fault(fmt::format("face {} has no vertices", f));
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                if (face.mIndices[k] >= mesh.mNumVertices) {
                    throw Fault(fmt::format("face {} names vertex {} of {}", f, face.mIndices[k],
                                            mesh.mNumVertices));
                }
            }
        }
    }
}

bool is_finite(const aiVector3D& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
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

void append(const aiMesh& part, float mm_per_unit, bool y_up, Mesh& mesh) {
    const auto first = mesh.positions_mm.size();
    if (first + part.mNumVertices > std::numeric_limits<std::uint32_t>::max()) {
        throw Fault("has more than 2^32 vertices");
    }
    const auto turn = [y_up](const aiVector3D& v) {
        return y_up ? Vec3f{v.x, -v.z, v.y} : Vec3f{v.x, v.y, v.z};
    };
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        if (!is_finite(part.mVertices[i])) {
            throw Fault(
                fmt::format("vertex {} of '{}' is not finite", i, excerpt(part.mName.C_Str())));
        }
        mesh.positions_mm.push_back(mm_per_unit * turn(part.mVertices[i]));
        // A vertex of degenerate triangles alone has no normal; it is never seen.
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
            triangle[k] = static_cast<std::uint32_t>(first + face.mIndices[k]);
        }
        mesh.triangles.push_back(triangle);
    }
}

std::string material_name(const aiScene& scene, const aiMesh& part) {
    if (part.mMaterialIndex >= scene.mNumMaterials) return {};
    return scene.mMaterials[part.mMaterialIndex]->GetName().C_Str();
}

[[noreturn]] void refuse_part(const std::string& part, const std::set<std::string>& names) {
    std::vector<std::string> shown;
    for (const std::string& name : names) shown.push_back(excerpt(name));
    throw Fault(fmt::format("has no material '{}'{}; its materials are '{}'", excerpt(part),
                            did_you_mean(excerpt(part), shown), fmt::join(shown, "', '")));
}

Mesh read_with_assimp(std::string_view bytes, const std::string& extension,
                      const char* importer_name, const References& references,
                      const MeshFile& file) {
    Assimp::Importer importer;
    keep_only(importer, importer_name);
    if (importer.GetImporterCount() != 1) {
        throw Error(fmt::format("this assimp has no '{}'", importer_name));
    }
    const std::string name = "mesh" + extension;
    importer.SetIOHandler(new MeshFiles(name, bytes, references));  // which deletes it
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE,
                              static_cast<float>(file.crease_angle_deg));
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(name, 0);
    if (scene) {
        require_vertices(*scene);
        scene = importer.ApplyPostProcessing(
            aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_GenSmoothNormals |
            aiProcess_PreTransformVertices | aiProcess_SortByPType |
            aiProcess_ValidateDataStructure);
    }
    if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0) {
        throw Fault(fmt::format("cannot be read: {}", without_quotes(importer.GetErrorString())));
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
        append(part, static_cast<float>(mm_per_unit), file.y_up || gltf, mesh);
    }
    if (!file.part.empty() && !names.contains(file.part)) refuse_part(file.part, names);
    if (mesh.triangles.empty()) throw Fault("has no triangles");
    return mesh;
}

constexpr const char* kGltfImporter = "glTF2 Importer";

Mesh parse(std::string_view bytes, const MeshFile& file) {
    const std::string extension = lowercase(file.path.extension().string());
    if (extension == ".obj") {
        if (bytes.find('\0') != std::string_view::npos) throw Fault("is no OBJ: is not text");
        return read_with_assimp(bytes, extension, "Wavefront Object Importer", {}, file);
    }
    if (extension == ".ply") {
        PlyCheck(bytes).run();
        return read_with_assimp(bytes, extension, "Stanford Polygon Library (PLY) Importer", {},
                                file);
    }
    if (extension == ".stl") {
        return read_with_assimp(bytes, extension, "Stereolithography (STL) Importer", {}, file);
    }
    const References beside = References::within(file.path.parent_path());
    if (extension == ".gltf") {
        return read_with_assimp(GltfGeometry(bytes).text(), extension, kGltfImporter, beside, file);
    }
    if (extension == ".glb") {
        const Glb glb = open_glb(bytes);
        return read_with_assimp(glb_bytes(GltfGeometry(glb.json).text(), glb.buffer), extension,
                                kGltfImporter, beside, file);
    }
    throw Fault("is none of .obj, .ply, .stl, .gltf and .glb");
}

}  // namespace

Mesh parse_mesh(std::string_view bytes, const MeshFile& file) {
    const auto refuse = [&](const char* why) {
        throw InputError(fmt::format("mesh '{}': {}", file.path.string(), why));
    };
    try {
        return parse(bytes, file);
    } catch (const Fault& fault) {
        refuse(fault.what());
    } catch (const json::exception& fault) {
        refuse(fmt::format("is no glTF 2.0: {}", without_quotes(fault.what())).c_str());
    }
    throw std::logic_error("a mesh is read or refused");
}

Mesh make_mesh(const MeshFile& file) {
    return parse_mesh(read_file(file.path, kMaxMeshBytes), file);
}

}  // namespace nacre::render
