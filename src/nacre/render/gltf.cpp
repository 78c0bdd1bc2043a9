#include "nacre/render/gltf.h"

#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <vector>

#include "nacre/core/text.h"
#include "nacre/render/mesh_file.h"
#include "nacre/render/mesh_formats.h"

namespace nacre::render {
namespace {

using nlohmann::json;

constexpr std::string_view kGlbMagic = "glTF";
constexpr std::uint32_t kGlbVersion = 2, kJsonChunk = 0x4E4F534A, kBufferChunk = 0x004E4942;
constexpr std::size_t kGlbHeader = 12, kGlbChunkHeader = 8;

json parse_json(std::string_view text) {
    constexpr std::size_t kMaxTextBytes = std::size_t{1} << 28;
    constexpr int kDeepest = 64;
    if (text.size() > kMaxTextBytes) {
        throw MeshError(fmt::format("has more than {} bytes of JSON", kMaxTextBytes));
    }
    // The parser does not recurse, but copying what it makes does.
    if (json_nesting(text) > kDeepest) {
        throw MeshError(fmt::format("is nested more than {} deep", kDeepest));
    }
    return json::parse(text);
}

}  // namespace

Glb open_glb(std::string_view bytes) {
    if (!bytes.starts_with(kGlbMagic) || bytes.size() < kGlbHeader) {
        throw MeshError("is no binary glTF: does not begin with 'glTF'");
    }
    const std::uint32_t version = little_endian(bytes, 4), length = little_endian(bytes, 8);
    if (version != kGlbVersion) throw MeshError(fmt::format("is glTF {}; 2 is read", version));
    if (length > bytes.size()) {
        throw MeshError(fmt::format("is cut short: it says that it has {} bytes, there are {}",
                                    length, bytes.size()));
    }
    Glb glb;
    for (std::size_t at = kGlbHeader; at + kGlbChunkHeader <= length;) {
        const std::size_t size = little_endian(bytes, at);
        const std::uint32_t type = little_endian(bytes, at + 4);
        at += kGlbChunkHeader;
        if (size > length - at) throw MeshError("is cut short: a chunk is longer than the file");
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

Gltf::Gltf(std::string_view text) : whole_(parse_json(text)) {
    if (!whole_.is_object()) throw MeshError("is no glTF: a table in braces is expected");
    const std::string version = whole_.at("asset").at("version");
    if (!version.starts_with("2.")) {
        throw MeshError(fmt::format("is glTF {}; 2 is read", excerpt(version)));
    }
    for (const json& name : list(whole_, "extensionsRequired")) {
        throw MeshError(fmt::format("needs the extension {}, which is not read",
                                    excerpt(name.get<std::string>())));
    }
}

const json& Gltf::list(const json& object, const char* key) {
    static const json none = json::array();
    const auto found = object.find(key);
    if (found == object.end()) return none;
    if (!found->is_array()) throw MeshError(fmt::format("{} is no list", key));
    return *found;
}

std::size_t Gltf::index(const json& number, std::size_t size, const char* what) {
    if (!number.is_number_unsigned() || number.get<std::size_t>() >= size) {
        throw MeshError(fmt::format("names a {} that it does not have", what));
    }
    return number.get<std::size_t>();
}

namespace {

class GltfGeometry {
 public:
    GltfGeometry(std::string_view text, double max_elements)
        : gltf_(text), whole_(gltf_.whole()), max_elements_(max_elements) {
        copy_meshes();
        copy_nodes();
        check_trees();
    }

    std::string text() const { return out_.dump(-1, ' ', false, json::error_handler_t::replace); }

 private:
    /// These keys of each entry of a list.
    static json entries(const json& object, const char* key,
                        std::initializer_list<const char*> kept) {
        json copies = json::array();
        for (const json& entry : Gltf::list(object, key)) copies.push_back(only(entry, kept));
        return copies;
    }
    static json only(const json& object, std::initializer_list<const char*> kept) {
        json copy = json::object();
        for (const char* key : kept) {
            if (object.contains(key)) copy[key] = object.at(key);
        }
        return copy;
    }

    double accessor_count(const json& number) const {
        const json& accessors = Gltf::list(whole_, "accessors");
        return accessors[Gltf::index(number, accessors.size(), "accessor")]
            .at("count")
            .get<double>();
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
        for (const json& accessor : Gltf::list(whole_, "accessors")) {
            if (accessor.contains("sparse"))
                throw MeshError("has a sparse accessor, which is not read");
            all += accessor.at("count").get<double>();
            if (!(all <= max_elements_)) refuse_size();
        }
        const std::size_t materials = copy_material_names();
        out_["meshes"] = json::array();
        for (const json& mesh : Gltf::list(whole_, "meshes")) {
            json primitives = json::array();
            double elements = 0;
            for (const json& primitive : Gltf::list(mesh, "primitives")) {
                json copy = only(primitive, {"indices", "mode"});
                const json& attributes = primitive.at("attributes");
                copy["attributes"] = only(attributes, {"POSITION", "NORMAL", "TEXCOORD_0"});
                for (const json& accessor : copy["attributes"]) {
                    elements += accessor_count(accessor);
                }
                if (primitive.contains("material")) {
                    copy["material"] = Gltf::index(primitive["material"], materials, "material");
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
        for (const json& material : Gltf::list(whole_, "materials")) {
            const auto name = material.find("name");
            const bool named = name != material.end() && name->is_string();
            out_["materials"].push_back({{"name", named ? *name : json("")}});
        }
        if (out_["materials"].size() > kMaxMeshMaterials) {
            throw MeshError(fmt::format("has more than {} materials", kMaxMeshMaterials));
        }
        return out_["materials"].size();
    }

    void copy_nodes() {
        out_["nodes"] = entries(whole_, "nodes",
                                {"children", "mesh", "matrix", "translation", "rotation", "scale"});
        out_["scenes"] = entries(whole_, "scenes", {"nodes"});
        if (whole_.contains("scene")) out_["scene"] = whole_["scene"];
        if (out_["nodes"].size() > kMaxMeshNodes) {
            throw MeshError(fmt::format("has {} nodes; at most {} are read", out_["nodes"].size(),
                                        kMaxMeshNodes));
        }
    }

    [[noreturn]] void refuse_size() const {
        throw MeshError(
            fmt::format("has more than {:.0f} vertices and indices, counted for each node "
                        "that shows them",
                        max_elements_));
    }

    /// Each node must have one parent at most, and none be its own descendant.
    void check_trees() const {
        const json& nodes = Gltf::list(out_, "nodes");
        std::vector<bool> has_parent(nodes.size(), false);
        for (const json& node : nodes) {
            for (const json& child : Gltf::list(node, "children")) {
                const std::size_t i = Gltf::index(child, nodes.size(), "node");
                if (has_parent[i]) throw MeshError(fmt::format("node {} has two parents", i));
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
                throw MeshError(fmt::format("has nodes more than {} deep", kMaxMeshNodeDepth));
            }
            for (const std::size_t i : level) {
                ++reached;
                if (nodes[i].contains("mesh")) {
                    elements += mesh_elements_[Gltf::index(nodes[i]["mesh"], mesh_elements_.size(),
                                                           "mesh")];
                }
                if (!(elements <= max_elements_)) refuse_size();
                for (const json& child : Gltf::list(nodes[i], "children")) next.push_back(child);
            }
        }
        if (reached != nodes.size()) throw MeshError("has a node that is its own descendant");
        for (const json& scene : Gltf::list(out_, "scenes")) {
            std::set<std::size_t> roots;
            for (const json& root : Gltf::list(scene, "nodes")) {
                const std::size_t i = Gltf::index(root, nodes.size(), "node");
                if (has_parent[i] || !roots.insert(i).second) {
                    throw MeshError(fmt::format("node {} is shown twice in a scene", i));
                }
            }
        }
    }

    Gltf gltf_;
    const json& whole_;
    double max_elements_;
    json out_;
    std::vector<double> mesh_elements_;
};

}  // namespace

std::string gltf_geometry(std::string_view text, double max_elements) {
    return GltfGeometry(text, max_elements).text();
}

}  // namespace nacre::render
