#include "nacre/render/mesh.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>

#include "nacre/core/angles.h"
#include "nacre/core/error.h"

namespace nacre::render {

/// What is wrong with a PLY file's header, or with its size given that header; empty if nothing.
/// assimp trusts the header's counts and may read on without end where a file is cut short, so a
/// file is looked at before assimp is.                                            [turk-1994]
std::optional<std::string> ply_fault(const std::filesystem::path& path);

Mesh mesh_of_surface(int columns, int rows,
                     const std::function<SurfacePoint(double u, double v)>& surface) {
    Mesh mesh;
    mesh.positions_mm.reserve(static_cast<std::size_t>(columns + 1) * (rows + 1));
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c) {
            const double u = static_cast<double>(c) / columns;
            const double v = static_cast<double>(r) / rows;
            const SurfacePoint p = surface(u, v);
            mesh.positions_mm.push_back(p.position_mm);
            mesh.normals.push_back(p.normal);
            mesh.uv.push_back({static_cast<float>(u), static_cast<float>(v)});
        }
    }
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t r = 0; r < static_cast<std::uint32_t>(rows); ++r) {
        for (std::uint32_t c = 0; c < static_cast<std::uint32_t>(columns); ++c) {
            const std::uint32_t i = r * stride + c;
            mesh.triangles.push_back({i, i + 1, i + stride + 1});
            mesh.triangles.push_back({i, i + stride + 1, i + stride});
        }
    }
    return mesh;
}

AffineMap::AffineMap(const Transform& transform)
    : translation_(transform.translation_mm), scale_(static_cast<float>(transform.scale)) {
    const double cx = std::cos(transform.rotation_deg.x * kDegree);
    const double sx = std::sin(transform.rotation_deg.x * kDegree);
    const double cy = std::cos(transform.rotation_deg.y * kDegree);
    const double sy = std::sin(transform.rotation_deg.y * kDegree);
    const double cz = std::cos(transform.rotation_deg.z * kDegree);
    const double sz = std::sin(transform.rotation_deg.z * kDegree);
    const auto vec = [](double x, double y, double z) {
        return Vec3f{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    };
    // R = Rz Ry Rx: x turns first.
    row_[0] = vec(cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx);
    row_[1] = vec(sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx);
    row_[2] = vec(-sy, cy * sx, cy * cx);
}

void apply(const AffineMap& map, Mesh& mesh) {
    for (Vec3f& p : mesh.positions_mm) p = map.point(p);
    for (Vec3f& n : mesh.normals) n = map.direction(n);
}

namespace {

/// Bytes of a scalar in a binary file; empty for an unknown type.
std::optional<int> scalar_size(const std::string& type) {
    static const std::map<std::string, int> kSizes{
        {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
        {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = kSizes.find(type);
    if (found == kSizes.end()) return std::nullopt;
    return found->second;
}

}  // namespace

std::optional<std::string> ply_fault(const std::filesystem::path& path) {
    constexpr int kMaxHeaderLength = 1000;  // lines
    std::ifstream in(path, std::ios::binary);
    std::string line;
    bool binary = false, ended = false;
    double count = 0, element_bytes = 0, min_bytes = 0;  // doubles: counts may overflow integers
    for (int number = 1; number <= kMaxHeaderLength && !ended && std::getline(in, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        std::istringstream words(line);
        std::string key, a, b;
        words >> key;
        if (number == 1 && key != "ply") return "line 1: does not begin with 'ply'";
        if (key == "format") {
            words >> a;
            binary = a != "ascii";
        } else if (key == "element") {
            min_bytes += count * element_bytes;
            element_bytes = 0;
            if (!(words >> a >> count) || count < 0) {
                return fmt::format("line {}: '{}' is not 'element NAME COUNT'", number, line);
            }
        } else if (key == "property") {
            words >> a;
            if (a == "list") words >> a >> b;  // at least its length is there
            const auto size = scalar_size(a);
            if (!size) return fmt::format("line {}: unknown type '{}'", number, a);
            // As text: one digit and one space.
            element_bytes += binary ? *size : 2;
        }
        ended = key == "end_header";
    }
    if (!ended) return "has no end_header";
    min_bytes += count * element_bytes;
    const auto body = static_cast<double>(in.tellg());
    std::error_code status;
    const auto size = static_cast<double>(std::filesystem::file_size(path, status));
    // The last number of a text file may do without its space.
    if (min_bytes > size - body + 1) {
        return fmt::format(
            "is cut short: its header asks for at least {:.0f} bytes of data, there "
            "are {:.0f}",
            min_bytes, size - body);
    }
    return std::nullopt;
}

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

namespace {

Vec3f vec(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

Mesh rectangle(double width_mm, double height_mm) {
    return mesh_of_surface(1, 1, [&](double u, double v) {
        return SurfacePoint{vec((u - 0.5) * width_mm, (v - 0.5) * height_mm, 0), {0, 0, 1}};
    });
}

}  // namespace

Mesh make_mesh(const FlatPanel& panel) { return rectangle(panel.width_mm, panel.height_mm); }

Mesh make_mesh(const GroundPlane& plane) { return rectangle(plane.size_mm, plane.size_mm); }

Mesh make_mesh(const CurvedPanel& panel) {
    // 256 facets round the bend: their chords lie within 1e-4 of the radius at a half turn.
    return mesh_of_surface(256, 1, [&](double u, double v) {
        const double r = panel.bend_radius_mm;
        const double angle = (u - 0.5) * panel.width_mm / r;
        return SurfacePoint{
            vec(r * std::sin(angle), (v - 0.5) * panel.height_mm, r * (std::cos(angle) - 1)),
            vec(std::sin(angle), 0, std::cos(angle))};
    });
}

Mesh make_mesh(const Backdrop& backdrop) {
    // The profile in the yz plane: floor, quarter circle, wall, each in its own rows so that the
    // straight parts stay exactly flat.
    const double r = backdrop.fillet_radius_mm;
    constexpr int kFilletRows = 64;
    constexpr int kRows = kFilletRows + 2;
    return mesh_of_surface(1, kRows, [&](double u, double v) {
        const double x = (u - 0.5) * backdrop.width_mm;
        const int row = static_cast<int>(std::lround(v * kRows));
        if (row == 0) return SurfacePoint{vec(x, -backdrop.depth_mm, 0), {0, 0, 1}};
        if (row == kRows) {
            return SurfacePoint{vec(x, backdrop.depth_mm, backdrop.height_mm), {0, -1, 0}};
        }
        const double angle = 0.5 * kPi * (row - 1) / kFilletRows;
        return SurfacePoint{
            vec(x, backdrop.depth_mm - r + r * std::sin(angle), r - r * std::cos(angle)),
            vec(0, -std::sin(angle), std::cos(angle))};
    });
}

// The speed shape is lofted: sections across x, each given in polar form about the ground below
// it. A section is the soft union of a wide, low body and a narrow, tall cabin, pressed in along
// the flank and tucked in at the sill. All functions are smooth, and so are the reflections.

namespace {

// Proportions in units of half of the length.
constexpr double kHalfWidth = 0.44;
constexpr double kBodyHeight = 0.29;
constexpr double kBodyFall = 0.10;  // of the body's height, from the middle to the nose
constexpr double kCabinHeight = 0.50;
constexpr double kCabinHalfWidth = 0.33;
constexpr double kCabinMiddle = -0.12;  // behind the middle
constexpr double kCabinHalfLength = 0.80;
constexpr double kFlankDepth = 0.075;     // of the flank's hollow, relative to the radius
constexpr double kFlankElevation = 0.32;  // of the hollow above the ground, in rad about the axis
constexpr double kFlankSpread = 0.16;
constexpr double kSillDepth = 0.10;
constexpr double kSillSpread = 0.10;

double square(double x) { return x * x; }

/// Radius of a superellipse of half axes a and b in direction (cosine, sine).
double superellipse(double a, double b, double cosine, double sine, double exponent) {
    if (a <= 0 || b <= 0) return 0;
    return std::pow(std::pow(std::abs(cosine) / a, exponent) + std::pow(sine / b, exponent),
                    -1 / exponent);
}

/// Point at station u along the body and v around it, both in [0, 1], for a half length of 1.
Vec3d point(double u, double v) {
    const double s = -std::cos(kPi * u);  // tail -1, nose +1; even steps round the ends
    const double angle = kPi * v;         // from the right sill over the roof to the left
    const double cosine = std::cos(angle);
    const double sine = std::max(0.0, std::sin(angle));

    const double end = std::sqrt(std::max(0.0, 1 - std::pow(std::abs(s), 3.0)));
    const double width = kHalfWidth * (1 - 0.05 * s) * end;
    const double height = kBodyHeight * (1 - kBodyFall * s) * end;
    const double body = superellipse(width, height, cosine, sine, 3.0);

    const double t = (s - kCabinMiddle) / kCabinHalfLength;
    const double bump = std::abs(t) < 1 ? square(1 - t * t) : 0.0;
    const double cabin =
        superellipse(kCabinHalfWidth * std::sqrt(bump), kCabinHeight * bump, cosine, sine, 2.2);

    constexpr double kUnion = 9;  // the larger, the sharper the line between cabin and shoulder
    double radius =
        body > 0 ? body * std::pow(1 + std::pow(cabin / body, kUnion), 1 / kUnion) : 0.0;

    const double elevation = std::asin(std::clamp(sine, 0.0, 1.0));
    const double along = square(1 - s * s);  // the hollow runs out before nose and tail
    radius *=
        1 - kFlankDepth * along * std::exp(-square((elevation - kFlankElevation) / kFlankSpread));
    radius *= 1 - kSillDepth * std::exp(-square(elevation / kSillSpread));
    return {s, -radius * cosine, radius * sine};
}

/// Normal by central differences; at the two tips, where all v meet, along x.
Vec3f normal(double u, double v) {
    constexpr double kStep = 1e-4;
    const double u0 = std::max(u - kStep, 0.0), u1 = std::min(u + kStep, 1.0);
    const double v0 = std::max(v - kStep, 0.0), v1 = std::min(v + kStep, 1.0);
    const Vec3d n = cross(point(u1, v) - point(u0, v), point(u, v1) - point(u, v0));
    if (length(n) < 1e-12) return {u < 0.5 ? -1.0f : 1.0f, 0, 0};
    return to_float(n / length(n));
}

}  // namespace

Mesh make_mesh(const SpeedShape& shape) {
    const double scale = 0.5 * shape.length_mm;
    return mesh_of_surface(384, 256, [&](double u, double v) {
        return SurfacePoint{to_float(scale * point(u, v)), normal(u, v)};
    });
}

}  // namespace nacre::render
