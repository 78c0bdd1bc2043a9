#include "nacre/render/smooth_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "nacre/core/angles.h"

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

}  // namespace

std::vector<Vec3f> smooth_normals(std::span<const Vec3f> corners, double crease_angle_deg) {
    constexpr std::size_t kMostWithCreases = 1024;
    constexpr float kTolerance = 1e-6f;  // of the cosine: rounding is no crease
    const float least_cosine = static_cast<float>(std::cos(crease_angle_deg * kDegree)) - kTolerance;

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
        if (here.size() > kMostWithCreases) {
            const Vec3f all = mean([](std::uint32_t) { return true; });
            for (const std::uint32_t i : here) normals[i] = all;
            return;
        }
        for (const std::uint32_t i : here) {
            const bool flat = dot(plane[i], plane[i]) > 0;
            normals[i] = mean([&](std::uint32_t j) {
                return !flat || dot(plane[i], plane[j]) >= least_cosine;
            });
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
