#include "nacre/render/polygon_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "nacre/core/math.h"
#include "nacre/core/text.h"
#include "nacre/render/mesh_file.h"
#include "nacre/render/mesh_formats.h"

namespace nacre::render {
namespace {

/// Numbers from 0 in the order of their keys, those of equal keys in a row and rising.
template <class Key>
std::vector<std::uint32_t> order_of(const std::vector<Key>& keys) {
    std::vector<std::uint32_t> order(keys.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
    });
    return order;
}

/// Calls visit(numbers) for each run of equal keys.
template <class Key, class Visit>
void for_each_equal(const std::vector<Key>& keys, Visit&& visit) {
    const std::vector<std::uint32_t> order = order_of(keys);
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && keys[order[end]] == keys[order[begin]]) ++end;
        visit(std::span(order).subspan(begin, end - begin));
    }
}

using Place = std::array<float, 3>;
Place place_of(Vec3f p) { return {p.x, p.y, p.z}; }

/// Of length 1, or of length 0 if it has none.
Vec3f direction_of(Vec3f v) {
    // In double, as squares of lengths of small triangles are too small for a float.
    const double x = v.x, y = v.y, z = v.z, length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
    return {static_cast<float>(x / length), static_cast<float>(y / length),
            static_cast<float>(z / length)};
}

/// Twice the area of a triangle, positive if counter-clockwise.
double turn(Vec2<double> a, Vec2<double> b, Vec2<double> c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A polygon seen along its mean normal, by Newell.                      [sutherland-1974]
std::vector<Vec2<double>> flattened(std::span<const Vec3f> polygon) {
    Vec3d normal{0, 0, 0};
    const Vec3d origin = to_double(polygon[0]);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = to_double(polygon[i]) - origin,
                    b = to_double(polygon[(i + 1) % polygon.size()]) - origin;
        normal += cross(a, b);
    }
    // Without the axis along which it is seen best, in an order that keeps it counter-clockwise.
    const Vec3d size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    const int away = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int u = (away + 1) % 3, v = (away + 2) % 3;
    if (normal[away] < 0) std::swap(u, v);
    std::vector<Vec2<double>> flat;
    flat.reserve(polygon.size());
    for (const Vec3f p : polygon) flat.push_back({p[u], p[v]});
    return flat;
}

}  // namespace

void PolygonMesh::end_face(std::uint32_t of_material) {
    const std::size_t first = end.empty() ? 0 : end.back();
    const std::size_t count = corners.size() - first;
    if (count < 3) {
        corners.resize(first);
        return;
    }
    if (count > kMaxFaceCorners) {
        throw MeshError(fmt::format("face {} has {} corners; at most {} are read", end.size(),
                                    count, kMaxFaceCorners));
    }
    if (corners.size() >= kNone) throw MeshError("has more than 2^32 corners of faces");
    end.push_back(static_cast<std::uint32_t>(corners.size()));
    material.push_back(of_material);
}

std::uint32_t PolygonMesh::material_of(const std::string& name) {
    const auto [at, is_new] =
        materials.try_emplace(name, static_cast<std::uint32_t>(materials.size()));
    if (materials.size() > kMaxMeshMaterials) {
        throw MeshError(fmt::format("has more than {} materials", kMaxMeshMaterials));
    }
    return at->second;
}

std::vector<std::array<std::uint32_t, 3>> cut_into_triangles(std::span<const Vec3f> polygon,
                                                             double& steps) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    if (polygon.size() == 3) return {{0, 1, 2}};
    const std::vector<Vec2<double>> p = flattened(polygon);
    std::vector<std::uint32_t> rest(polygon.size());
    std::iota(rest.begin(), rest.end(), 0u);
    // Whether the triangle of the corner k of the rest holds no other.
    const auto is_ear = [&](std::size_t k) {
        const std::size_t n = rest.size(), before = (k + n - 1) % n, after = (k + 1) % n;
        const Vec2<double> a = p[rest[before]], b = p[rest[k]], c = p[rest[after]];
        if (turn(a, b, c) <= 0) return false;
        steps -= static_cast<double>(n);
        if (steps < 0) throw MeshError("has faces too intricate to be cut into triangles");
        for (std::size_t j = 0; j < n; ++j) {
            if (j == before || j == k || j == after) continue;
            const Vec2<double> q = p[rest[j]];
            const bool at_corner = (q.x == a.x && q.y == a.y) || (q.x == b.x && q.y == b.y) ||
                                   (q.x == c.x && q.y == c.y);
            if (!at_corner && turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0) {
                return false;
            }
        }
        return true;
    };
    std::size_t k = 0, looked_at = 0;
    while (rest.size() > 3) {
        k %= rest.size();
        steps -= 1;
        if (!is_ear(k) && ++looked_at <= rest.size()) {
            ++k;
            continue;
        }
        const std::size_t n = rest.size();
        triangles.push_back({rest[(k + n - 1) % n], rest[k], rest[(k + 1) % n]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
        ++k;  // ears of a fan would make long, thin triangles
        looked_at = 0;
    }
    triangles.push_back({rest[0], rest[1], rest[2]});
    return triangles;
}

namespace {

[[noreturn]] void refuse_part(const std::string& part, const std::set<std::string>& names) {
    std::vector<std::string> shown;
    for (const std::string& name : names) shown.push_back(excerpt(name));
    throw MeshError(fmt::format("has no material '{}'{}; its materials are '{}'", excerpt(part),
                                did_you_mean(excerpt(part), shown), fmt::join(shown, "', '")));
}

/// Corners of triangles, by material.
std::vector<std::vector<PolygonMesh::Corner>> corners_by_material(const PolygonMesh& polygons) {
    constexpr double kMaxSteps = 2e9;
    double steps = kMaxSteps;
    std::vector<std::vector<PolygonMesh::Corner>> out(polygons.materials.size());
    std::vector<Vec3f> outline;
    std::uint32_t first = 0;
    for (std::size_t f = 0; f < polygons.end.size(); ++f) {
        const std::span face(polygons.corners.data() + first, polygons.end[f] - first);
        first = polygons.end[f];
        outline.clear();
        for (const PolygonMesh::Corner& corner : face) {
            outline.push_back(polygons.positions[corner.position]);
        }
        for (const auto& triangle : cut_into_triangles(outline, steps)) {
            for (const std::uint32_t k : triangle) out[polygons.material[f]].push_back(face[k]);
        }
    }
    return out;
}

}  // namespace

Mesh triangles_of(const PolygonMesh& polygons, const MeshFile& file, float mm_per_unit, bool y_up,
                  std::set<std::string>* parts) {
    const auto turned = [y_up](Vec3f v) { return y_up ? Vec3f{v.x, -v.z, v.y} : v; };
    const auto is_finite = [](Vec3f v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    const auto by_material = corners_by_material(polygons);
    Mesh mesh;
    std::set<std::string> names;
    bool laid_out = true;
    for (const auto& [name, number] : polygons.materials) {
        const std::vector<PolygonMesh::Corner>& corners = by_material[number];
        if (corners.empty()) continue;
        names.insert(name);
        if (!file.part.empty() && name != file.part) continue;
        const std::size_t first = mesh.positions_mm.size();
        if (first + corners.size() > std::numeric_limits<std::uint32_t>::max()) {
            throw MeshError("has more than 2^32 vertices");
        }
        for (const PolygonMesh::Corner& corner : corners) {
            const Vec3f position = mm_per_unit * turned(polygons.positions[corner.position]);
            if (!is_finite(position)) {
                throw MeshError(fmt::format("vertex {} is not finite", corner.position));
            }
            mesh.positions_mm.push_back(position);
            const Vec2f uv =
                corner.uv == PolygonMesh::kNone ? Vec2f{NAN, NAN} : polygons.uv[corner.uv];
            laid_out = laid_out && std::isfinite(uv.x) && std::isfinite(uv.y);
            mesh.uv.push_back(uv);
        }
        std::vector<Vec3f> made;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::uint32_t n = corners[k].normal;
            Vec3f normal = n == PolygonMesh::kNone ? Vec3f{0, 0, 0}
                                                   : direction_of(turned(polygons.normals[n]));
            if (normal == Vec3f{0, 0, 0}) {
                if (made.empty()) {
                    made = smooth_normals(std::span(mesh.positions_mm).subspan(first),
                                          file.crease_angle_deg);
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
    if (!file.part.empty() && !names.contains(file.part)) refuse_part(file.part, names);
    if (mesh.triangles.empty()) throw MeshError("has no triangles");
    if (!laid_out) mesh.uv.clear();
    if (parts) *parts = std::move(names);
    join_equal_vertices(mesh);
    return mesh;
}

std::vector<Vec3f> smooth_normals(std::span<const Vec3f> corners, double crease_angle_deg) {
    constexpr std::size_t kMaxWithCreases = 1024;
    constexpr float kTolerance = 1e-6f;  // of the cosine: rounding is no crease
    const float min_cosine = static_cast<float>(std::cos(crease_angle_deg * kDegree)) - kTolerance;

    const std::size_t count = corners.size();
    std::vector<Vec3f> plane(count), weighted(count);
    for (std::size_t first = 0; first + 2 < count; first += 3) {
        const std::array<Vec3f, 3> side{direction_of(corners[first + 1] - corners[first]),
                                        direction_of(corners[first + 2] - corners[first + 1]),
                                        direction_of(corners[first] - corners[first + 2])};
        const Vec3f normal = direction_of(cross(side[0], side[1]));
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f along = side[k], back = side[(k + 2) % 3];
            const float angle = std::acos(std::clamp(-dot(along, back), -1.0f, 1.0f));
            plane[first + k] = normal;
            weighted[first + k] = angle * normal;
        }
    }

    std::vector<Place> places(count);
    std::transform(corners.begin(), corners.end(), places.begin(), place_of);
    std::vector<Vec3f> normals(count);
    for_each_equal(places, [&](std::span<const std::uint32_t> here) {
        const auto mean = [&](auto&& counts) {
            Vec3f sum{0, 0, 0};
            for (const std::uint32_t j : here) {
                if (counts(j)) sum = sum + weighted[j];
            }
            const Vec3f n = direction_of(sum);
            return dot(n, n) > 0 ? n : Vec3f{0, 0, 1};
        };
        if (here.size() > kMaxWithCreases) {
            const Vec3f all = mean([](std::uint32_t) { return true; });
            for (const std::uint32_t i : here) normals[i] = all;
            return;
        }
        for (const std::uint32_t i : here) {
            const bool flat = dot(plane[i], plane[i]) > 0;
            normals[i] = mean(
                [&](std::uint32_t j) { return !flat || dot(plane[i], plane[j]) >= min_cosine; });
        }
    });
    return normals;
}

void join_equal_vertices(Mesh& mesh) {
    const bool laid_out = !mesh.uv.empty();
    using Vertex = std::array<float, 8>;
    std::vector<Vertex> vertices(mesh.positions_mm.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3f p = mesh.positions_mm[i], n = mesh.normals[i];
        const Vec2f t = laid_out ? mesh.uv[i] : Vec2f{0, 0};
        vertices[i] = {p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y};
    }
    std::vector<std::uint32_t> first(vertices.size());
    for_each_equal(vertices, [&](std::span<const std::uint32_t> equal) {
        for (const std::uint32_t i : equal) first[i] = equal.front();
    });
    // Numbers from 0 of those that stay, each at or before its old place.
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) {
            first[i] = first[first[i]];
            continue;
        }
        mesh.positions_mm[kept] = mesh.positions_mm[i];
        mesh.normals[kept] = mesh.normals[i];
        if (laid_out) mesh.uv[kept] = mesh.uv[i];
        first[i] = kept++;
    }
    mesh.positions_mm.resize(kept);
    mesh.normals.resize(kept);
    if (laid_out) mesh.uv.resize(kept);
    for (auto& triangle : mesh.triangles) {
        for (std::uint32_t& corner : triangle) corner = first[corner];
    }
}

}  // namespace nacre::render
