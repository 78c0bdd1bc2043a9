#include "nacre/exchange/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "nacre/core/base64.h"
#include "nacre/core/version.h"

namespace nacre::exchange {

namespace {

using Json = nlohmann::ordered_json;

/// Six digits: what single precision, in which renderers take them, can tell.
double rounded(double value) { return std::stod(fmt::format("{:.6g}", value)); }
Json rounded(const Vec3d& v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }

/// A sphere by rings of latitude, the poles along y.
struct Sphere {
    static constexpr int kAround = 96, kRings = 48;
    static constexpr double kRadius_m = 0.1;

    std::vector<float> positions, normals;
    std::vector<std::uint16_t> indices;

    Sphere() {
        for (int ring = 0; ring <= kRings; ++ring) {
            const double theta = std::numbers::pi * ring / kRings;
            for (int k = 0; k <= kAround; ++k) {
                const double phi = 2 * std::numbers::pi * k / kAround;
                const double n[3] = {std::sin(theta) * std::sin(phi), std::cos(theta),
                                     std::sin(theta) * std::cos(phi)};
                for (const double x : n) {
                    normals.push_back(static_cast<float>(x));
                    positions.push_back(static_cast<float>(kRadius_m * x));
                }
            }
        }
        const auto vertex = [](int ring, int k) {
            return static_cast<std::uint16_t>(ring * (kAround + 1) + k);
        };
        for (int ring = 0; ring < kRings; ++ring) {
            for (int k = 0; k < kAround; ++k) {
                const std::uint16_t a = vertex(ring, k), b = vertex(ring + 1, k),
                                    c = vertex(ring + 1, k + 1), d = vertex(ring, k + 1);
                // At the poles one of the two has no area.
                if (ring < kRings - 1) indices.insert(indices.end(), {a, b, c});
                if (ring > 0) indices.insert(indices.end(), {a, c, d});
            }
        }
    }
};

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
    const std::size_t at = bytes.size();
    bytes.resize(at + values.size() * sizeof(T));
    std::memcpy(bytes.data() + at, values.data(), values.size() * sizeof(T));
}

void add_sphere(Json& gltf) {
    const Sphere sphere;
    std::string bytes;
    Json views = Json::array(), accessors = Json::array();
    const auto add = [&](const auto& values, int width, int component, int target) {
        const std::size_t offset = bytes.size();
        append(bytes, values);
        views.push_back({{"buffer", 0},
                         {"byteOffset", offset},
                         {"byteLength", bytes.size() - offset},
                         {"target", target}});
        accessors.push_back({{"bufferView", views.size() - 1},
                             {"componentType", component},
                             {"count", values.size() / width},
                             {"type", width == 1   ? "SCALAR"
                                      : width == 2 ? "VEC2"
                                                   : "VEC3"}});
    };
    constexpr int kFloat = 5126, kShort = 5123, kVertices = 34962, kElements = 34963;
    add(sphere.positions, 3, kFloat, kVertices);
    add(sphere.normals, 3, kFloat, kVertices);
    add(sphere.indices, 1, kShort, kElements);
    Json lo = Json::array(), hi = Json::array();
    for (int axis = 0; axis < 3; ++axis) {
        float least = sphere.positions[axis], most = least;
        for (std::size_t i = axis; i < sphere.positions.size(); i += 3) {
            least = std::min(least, sphere.positions[i]);
            most = std::max(most, sphere.positions[i]);
        }
        lo.push_back(least);
        hi.push_back(most);
    }
    accessors[0]["min"] = lo;
    accessors[0]["max"] = hi;
    gltf["buffers"] = {{{"byteLength", bytes.size()},
                        {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
    gltf["bufferViews"] = views;
    gltf["accessors"] = accessors;
    gltf["meshes"] = {
        {{"name", "sphere"},
         {"primitives",
          {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"indices", 2}, {"material", 0}}}}}};
}

Json material_json(const GltfMaterial& m, const std::string& name) {
    Json extensions = {{"KHR_materials_specular",
                        {{"specularFactor", rounded(m.specular)},
                         {"specularColorFactor", rounded(m.specular_color)}}}};
    if (m.iridescence > 0) {
        extensions["KHR_materials_iridescence"] = {
            {"iridescenceFactor", rounded(m.iridescence)},
            {"iridescenceIor", rounded(m.iridescence_ior)},
            {"iridescenceThicknessMaximum", rounded(m.iridescence_nm)}};
    }
    if (m.clearcoat > 0) {
        extensions["KHR_materials_clearcoat"] = {
            {"clearcoatFactor", rounded(m.clearcoat)},
            {"clearcoatRoughnessFactor", rounded(m.clearcoat_roughness)}};
    }
    return {{"name", name},
            {"pbrMetallicRoughness",
             {{"baseColorFactor",
               {rounded(m.base_color.x), rounded(m.base_color.y), rounded(m.base_color.z), 1.0}},
              {"metallicFactor", rounded(m.metallic)},
              {"roughnessFactor", rounded(m.roughness)}}},
            {"extensions", extensions}};
}

Json differences(const measure::Difference& difference) {
    Json angles = Json::object();
    for (const auto& angle : difference.angles) {
        angles[angle.geometry.name] = rounded(angle.delta_e_2000);
    }
    return {{"mean", rounded(difference.mean_delta_e_2000)},
            {"max", rounded(difference.max_delta_e_2000)},
            {"by_angle", angles}};
}

}  // namespace

std::string gltf_text(const GltfMaterial& material, const std::string& name,
                      const MaterialFit& fit) {
    Json gltf;
    gltf["asset"] = {{"version", "2.0"}, {"generator", fmt::format("Nacre {}", version())}};
    Json shown = material_json(material, name);
    Json used = Json::array();
    for (const auto& extension : shown["extensions"].items()) used.push_back(extension.key());
    shown["extras"] = {{"nacre_delta_e_2000",
                        {{"byk_mac", differences(fit.instrument)},
                         {"fitted", differences(fit.fitted)},
                         {"tested", differences(fit.tested)}}}};
    gltf["extensionsUsed"] = used;
    gltf["materials"] = Json::array({shown});
    add_sphere(gltf);
    gltf["nodes"] = {{{"name", name}, {"mesh", 0}}};
    gltf["scenes"] = {{{"nodes", {0}}}};
    gltf["scene"] = 0;
    return gltf.dump(2) + '\n';
}

}  // namespace nacre::exchange
