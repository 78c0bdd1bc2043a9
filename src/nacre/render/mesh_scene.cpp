#include "nacre/render/mesh_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "nacre/core/file.h"
#include "nacre/core/math.h"
#include "nacre/core/text.h"
#include "nacre/render/gltf.h"
#include "nacre/render/mesh_file.h"
#include "nacre/render/mesh_formats.h"
#include "nacre/spectra/upsampling.h"

namespace nacre::render {
namespace {

using nlohmann::json;
using Colour = std::array<double, 3>;  // linear Rec. 709

/// A glTF's numbers, which may be anything in JSON.
template <std::size_t kCount>
std::array<double, kCount> numbers(const json& object, const char* key,
                                   std::array<double, kCount> otherwise) {
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    const auto values = found->get<std::vector<double>>();
    if (values.size() != kCount) {
        throw MeshError(fmt::format("{} has {} numbers, not {}", key, values.size(), kCount));
    }
    std::copy(values.begin(), values.end(), otherwise.begin());
    return otherwise;
}
double number(const json& object, const char* key, double otherwise) {
    const auto found = object.find(key);
    return found == object.end() ? otherwise : found->get<double>();
}
json table(const json& object, const char* key) {
    return object.contains(key) ? object.at(key) : json::object();
}
std::string name_of(const json& object) {
    const auto found = object.find("name");
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

// ------------------------------------------------------------------------------- materials

/// The metal that ships whose colour in even light is nearest.
std::string nearest_metal(const Colour& colour) {
    // Linear Rec. 709 under D65 at normal incidence, by `nacre materials` data: for choosing only.
    struct Metal {
        const char* name;
        Colour colour;
    };
    static constexpr Metal kMetals[] = {{"Ag", {0.96, 0.95, 0.92}},
                                        {"Al", {0.91, 0.92, 0.92}},
                                        {"Cr", {0.55, 0.56, 0.55}},
                                        {"Au", {1.00, 0.77, 0.34}},
                                        {"Cu", {0.96, 0.64, 0.54}}};
    const auto distance = [&](const Metal& m) {
        double sum = 0;
        for (int c = 0; c < 3; ++c) sum += std::pow(m.colour[c] - colour[c], 2);
        return sum;
    };
    return std::min_element(
               std::begin(kMetals), std::end(kMetals),
               [&](const Metal& a, const Metal& b) { return distance(a) < distance(b); })
        ->name;
}

/// Alpha of GGX from glTF's roughness; below what facets can have, a smooth face.
double facet_alpha(double roughness) {
    const double alpha = std::clamp(roughness * roughness, 0.0, 1.0);
    return alpha < 1e-3 ? 0 : alpha;
}

MaterialDescription plastic(const Colour& colour, double roughness) {
    const auto inside = [&](int c) { return std::clamp(colour[c], 0.0, 1.0); };
    return PlasticMaterial{
        .reflectance = spectra::reflectance_from_rec709({inside(0), inside(1), inside(2)}),
        .roughness = facet_alpha(roughness)};
}

MaterialDescription material_of(const json& material) {
    const json metallic_roughness = table(material, "pbrMetallicRoughness");
    const auto base =
        numbers<4>(metallic_roughness, "baseColorFactor", std::array<double, 4>{1, 1, 1, 1});
    const Colour colour{base[0], base[1], base[2]};
    const double roughness = number(metallic_roughness, "roughnessFactor", 1);
    const json transmission = table(table(material, "extensions"), "KHR_materials_transmission");
    const bool blends = material.value("alphaMode", std::string()) == "BLEND" && base[3] < 0.9;
    if (blends || number(transmission, "transmissionFactor", 0) > 0.5) {
        GlassMaterial pane;
        pane.pane_mm = 4;
        return pane;
    }
    if (number(metallic_roughness, "metallicFactor", 1) > 0.5) {
        return ConductorMaterial{optics::find_material(nearest_metal(colour)),
                                 facet_alpha(roughness)};
    }
    return plastic(colour, roughness);
}

// ---------------------------------------------------------------------------------- camera

using Matrix = Eigen::Affine3d;

Matrix matrix_of(const json& node) {
    Matrix m = Matrix::Identity();
    if (node.contains("matrix")) {
        const auto values = numbers<16>(node, "matrix", {});
        for (int i = 0; i < 16; ++i) m.matrix()(i % 4, i / 4) = values[i];  // by columns
        return m;
    }
    const auto t = numbers<3>(node, "translation", std::array<double, 3>{0, 0, 0});
    const auto q = numbers<4>(node, "rotation", std::array<double, 4>{0, 0, 0, 1});
    const auto s = numbers<3>(node, "scale", std::array<double, 3>{1, 1, 1});
    m.translate(Eigen::Vector3d(t[0], t[1], t[2]));
    m.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
    m.scale(Eigen::Vector3d(s[0], s[1], s[2]));
    return m;
}

/// From metres with y up to millimetres with z up.
Vec3f to_world(const Eigen::Vector3d& v, double scale) {
    return {static_cast<float>(scale * v.x()), static_cast<float>(-scale * v.z()),
            static_cast<float>(scale * v.y())};
}

struct FoundCamera {
    std::string name;
    Camera camera;
};

/// A camera at each node that has one; orthographic ones are left out.
void collect_cameras(const json& gltf, std::size_t i, const Matrix& parent, float distance_mm,
                     std::vector<FoundCamera>& found) {
    const json& node = Gltf::list(gltf, "nodes").at(i);
    const Matrix here = parent * matrix_of(node);
    if (node.contains("camera")) {
        const json& cameras = Gltf::list(gltf, "cameras");
        const json& camera = cameras[Gltf::index(node["camera"], cameras.size(), "camera")];
        if (camera.contains("perspective")) {
            constexpr double kMmPerMetre = 1000;
            const Vec3f position = to_world(here.translation(), kMmPerMetre);
            // It looks along its -z with its y upwards.
            const Vec3f ahead = normalize(to_world(here.linear() * -Eigen::Vector3d::UnitZ(), 1));
            FoundCamera one;
            one.name = name_of(camera).empty() ? name_of(node) : name_of(camera);
            one.camera.position_mm = position;
            one.camera.target_mm = position + distance_mm * ahead;
            one.camera.up = normalize(to_world(here.linear() * Eigen::Vector3d::UnitY(), 1));
            one.camera.vertical_fov_deg =
                std::clamp(number(camera["perspective"], "yfov", 0.5) / kDegree, 0.01, 179.0);
            found.push_back(one);
        }
    }
    for (const json& child : Gltf::list(node, "children")) {
        collect_cameras(gltf, child.get<std::size_t>(), here, distance_mm, found);
    }
}

/// Where the whole mesh is seen, from before and above.
Camera camera_around(Vec3f low, Vec3f high) {
    constexpr double kFov_deg = 25;
    const Vec3f middle = 0.5f * (low + high);
    const float radius = std::max(0.5f * length(high - low), 1e-3f);
    const auto away = static_cast<float>(1.15 / std::sin(0.5 * kFov_deg * kDegree));
    return {.position_mm = middle + away * radius * normalize(Vec3f{0.55f, -0.75f, 0.35f}),
            .target_mm = middle,
            .vertical_fov_deg = kFov_deg};
}

/// The JSON of a glTF, whose nodes have been found to be trees; empty of other files.
json gltf_of(std::string_view bytes, const std::string& extension) {
    if (extension == ".gltf") return Gltf(bytes).whole();
    if (extension == ".glb") return Gltf(open_glb(bytes).json).whole();
    return json::object();
}

SceneDescription compose(const std::filesystem::path& path, const MeshSceneOptions& options) {
    const std::string bytes = read_file(path, kMaxMeshBytes);
    std::set<std::string> parts;
    const Mesh mesh = parse_mesh(bytes, {.path = path}, &parts);
    const json gltf = gltf_of(bytes, lowercase(path.extension().string()));
    const auto join = [](const auto& names) { return fmt::format("{}", fmt::join(names, ", ")); };
    if (parts.size() > 1 && parts.contains("")) {
        throw MeshError("has several materials, and one without a name, by which parts are told");
    }
    for (const std::string& name : options.painted) {
        if (!parts.contains(name)) {
            throw MeshError(fmt::format("has no part '{}'; it has {}", excerpt(name), join(parts)));
        }
    }

    SceneDescription scene;
    scene.name = path.stem().string();
    scene.environment = StudioEnvironment{};
    std::map<std::string, json> materials;
    for (const json& material : Gltf::list(gltf, "materials")) {
        materials.emplace(name_of(material), material);
    }
    for (const std::string& part : parts) {
        const bool painted = options.painted.empty()
                                 ? parts.size() == 1
                                 : std::count(options.painted.begin(), options.painted.end(), part);
        const std::string name = part.empty() ? "paint" : part;
        if (painted) {
            scene.materials[name] = PaintMaterial{};
        } else if (materials.contains(part)) {
            scene.materials[name] = material_of(materials[part]);
        } else {
            scene.materials[name] = plastic({0.2, 0.2, 0.2}, 0.5);
        }
        scene.shapes.push_back(
            {MeshFile{.path = path, .part = parts.size() > 1 ? part : ""}, name, {}});
    }
    if (parts.size() > 1 && options.painted.empty()) {
        scene.notes.push_back(fmt::format("{}: no part is painted; --painted NAME says which of {}",
                                          path.string(), join(parts)));
    }
    if (!Gltf::list(gltf, "textures").empty()) {
        scene.notes.push_back(fmt::format("{}: its textures are left out", path.string()));
    }

    Vec3f low = mesh.positions_mm.at(0), high = low;
    for (const Vec3f& p : mesh.positions_mm) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    std::vector<FoundCamera> cameras;
    const json& nodes = Gltf::list(gltf, "nodes");
    std::set<std::size_t> children;
    for (const json& node : nodes) {
        for (const json& child : Gltf::list(node, "children"))
            children.insert(child.get<std::size_t>());
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (children.contains(i)) continue;
        collect_cameras(gltf, i, Matrix::Identity(), std::max(length(high - low), 1.0f), cameras);
    }
    scene.camera = cameras.empty() ? camera_around(low, high) : cameras[0].camera;
    std::vector<std::string> names;
    for (const FoundCamera& one : cameras) names.push_back(one.name);
    if (!options.camera.empty()) {
        const auto found = std::find(names.begin(), names.end(), options.camera);
        if (found == names.end()) {
            throw MeshError(fmt::format("has no camera '{}'; it has {}", excerpt(options.camera),
                                        names.empty() ? "none" : join(names)));
        }
        scene.camera = cameras[found - names.begin()].camera;
    } else if (names.size() > 1) {
        scene.notes.push_back(
            fmt::format("{}: of its cameras {} the first is taken", path.string(), join(names)));
    }
    return scene;
}

}  // namespace

SceneDescription scene_of_mesh(const std::filesystem::path& path, const MeshSceneOptions& options) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(fmt::format("mesh '{}': {}", path.string(), why));
    };
    try {
        SceneDescription scene = compose(path, options);
        validate(scene);
        return scene;
    } catch (const MeshError& fault) {
        refuse(fault.what());
    } catch (const DomainError& fault) {
        refuse(fault.what());
    } catch (const json::exception& fault) {
        refuse(fmt::format("is no glTF 2.0: {}", without_quotes(fault.what())));
    }
    throw std::logic_error("a mesh is read or refused");
}

}  // namespace nacre::render
