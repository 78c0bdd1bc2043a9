#include "nacre/sparkle/normal_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/paint/beckmann.h"

namespace nacre::sparkle {
namespace {

constexpr std::uint32_t nodes_above(int level) { return ((1u << (2 * level)) - 1) / 3; }

Vec3f midpoint(Vec3f a, Vec3f b) { return normalize(a + b); }

// Int D(m) (m.n) dm over a spherical triangle, by the seven-point rule of degree 5 on the flat
// triangle below it; solid angle = det(a, b, c) / |p|^3 per unit of barycentric area.
// [dunavant-1985, table II]
double rule_of_seven(Vec3d a, Vec3d b, Vec3d c, double alpha) {
    static constexpr double kNear = 0.797426985353087, kFar = 0.101286507323456;
    static constexpr double kSide = 0.470142064105115, kOther = 0.059715871789770;
    static constexpr double kThird = 1.0 / 3;
    static constexpr std::array<std::array<double, 4>, 7> kRule = {
        {{kThird, kThird, kThird, 0.225},
         {kNear, kFar, kFar, 0.125939180544827},
         {kFar, kNear, kFar, 0.125939180544827},
         {kFar, kFar, kNear, 0.125939180544827},
         {kOther, kSide, kSide, 0.132394152788506},
         {kSide, kOther, kSide, 0.132394152788506},
         {kSide, kSide, kOther, 0.132394152788506}}};
    const double det = dot(a, cross(b, c));
    double sum = 0;
    for (const auto& [wa, wb, wc, weight] : kRule) {
        const double x = wa * a.x + wb * b.x + wc * c.x, y = wa * a.y + wb * b.y + wc * c.y;
        const double z = wa * a.z + wb * b.z + wc * c.z;
        const double r2 = x * x + y * y, length = std::sqrt(r2 + z * z);
        if (z <= 0) continue;
        // A flake counts D_B |cos| / 2 per side: twice that is D_B cos.
        sum += weight * 2 * paint::flake_density(r2 / (z * z), alpha) / (length * length * length);
    }
    return 0.5 * std::abs(det) * sum;
}

// Halves the triangle while D changes much over it and is not negligible.
double integrate(Vec3f a, Vec3f b, Vec3f c, double edge, double alpha) {
    // No normal of the triangle is nearer to the pole than its highest corner by more than an edge.
    const double z = std::max({a.z, b.z, c.z});
    const double sine = std::sqrt(std::max(0.0, 1 - z * z)) - edge;
    const bool negligible = sine > 0 && sine * sine / (1 - sine * sine) > 80 * alpha * alpha;
    if (edge <= 0.6 * alpha || negligible) {
        return rule_of_seven(to_double(a), to_double(b), to_double(c), alpha);
    }
    const Vec3f ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    const double half = 0.5 * edge;
    return integrate(a, ab, ca, half, alpha) + integrate(ab, b, bc, half, alpha) +
           integrate(ca, bc, c, half, alpha) + integrate(ab, bc, ca, half, alpha);
}

}  // namespace

NormalTree::NormalTree(double alpha, double edge_rad) {
    require_in_range(alpha, 1e-4, 2, "roughness alpha of the facets");
    require_in_range(edge_rad, 1e-6, 2, "edge of the smallest triangles in rad");
    const double halvings = std::ceil(std::log2(0.5 * std::numbers::pi / edge_rad));
    depth_ = std::clamp(static_cast<int>(halvings), 1, kMaxDepth);
    nodes_.resize(nodes_above(depth_));
    masses_.resize(nodes_above(depth_ + 1));
    build(0, 0, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, alpha);
    // Spreads the rule's error over all, so that the masses of an octant add up to 1/4.
    const double scale = 0.25 / masses_[0];
    for (double& mass : masses_) mass *= scale;
}

void NormalTree::build(std::uint32_t node, int level, Vec3f a, Vec3f b, Vec3f c, double alpha) {
    if (level == depth_) {
        masses_[node] = integrate(a, b, c, 0.5 * std::numbers::pi / (1 << level), alpha);
        return;
    }
    const Vec3f ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    build(4 * node + 1, level + 1, a, ab, ca, alpha);
    build(4 * node + 2, level + 1, ab, b, bc, alpha);
    build(4 * node + 3, level + 1, ca, bc, c, alpha);
    build(4 * node + 4, level + 1, ab, bc, ca, alpha);
    const double* parts = &masses_[4 * node + 1];
    const auto conditional = [](double part, double rest) {
        return part > 0 ? part / (part + rest) : 0;
    };
    Node& n = nodes_[node];
    n.corner_planes[0] = cross(ab, ca);
    n.corner_planes[1] = cross(bc, ab);
    n.corner_planes[2] = cross(ca, bc);
    const std::array<Vec3f, 3> corners = {a, b, c};
    for (int i = 0; i < 3; ++i) {
        if (dot(n.corner_planes[i], corners[i]) < 0) n.corner_planes[i] = -n.corner_planes[i];
    }
    double rest = parts[0] + parts[1] + parts[2] + parts[3];
    for (int i = 0; i < 3; ++i) {
        const double part = parts[kOrder[i]];
        rest = std::max(0.0, rest - part);
        n.probability[i] = conditional(part, rest);
    }
    masses_[node] = parts[0] + parts[1] + parts[2] + parts[3];
}

NormalTree::Code NormalTree::locate(Vec3f m) const {
    const Code octant = m.y >= 0 ? (m.x >= 0 ? 0 : 1) : (m.x < 0 ? 2 : 3);
    const Vec3f turned = octant == 0   ? m
                         : octant == 1 ? Vec3f{m.y, -m.x, m.z}
                         : octant == 2 ? Vec3f{-m.x, -m.y, m.z}
                                       : Vec3f{-m.y, m.x, m.z};
    std::uint32_t node = 0;
    Code code = octant;
    for (int level = 0; level < depth_; ++level) {
        const Node& n = nodes_[node];
        Code part = 3;
        // The pole's corner first: most facets are there.
        if (dot(n.corner_planes[2], turned) > 0) {
            part = 2;
        } else if (dot(n.corner_planes[0], turned) > 0) {
            part = 0;
        } else if (dot(n.corner_planes[1], turned) > 0) {
            part = 1;
        }
        node = 4 * node + 1 + part;
        code = 4 * code + part;
    }
    return code;
}

double NormalTree::mass(Code leaf) const {
    return masses_[nodes_above(depth_) + (leaf & ((1u << (2 * depth_)) - 1))];
}

NormalTree::Parts NormalTree::split_octants(std::uint64_t n, std::uint64_t key) {
    const std::uint64_t half = half_binomial(n, key);
    const std::uint64_t first = half_binomial(half, key + 1);
    const std::uint64_t third = half_binomial(n - half, key + 2);
    return {{first, half - first, third, n - half - third}};
}

NormalTree::Parts NormalTree::split(std::uint32_t node, std::uint64_t n, std::uint64_t key,
                                    unsigned wanted) const {
    const Node& at = nodes_[node];
    Parts parts{};
    for (int i = 0; i < 3 && wanted != 0; ++i) {
        const int part = kOrder[i];
        parts.count[part] = binomial(n, at.probability[i], key + i);
        n -= parts.count[part];
        wanted &= ~(1u << part);
    }
    if (wanted != 0) parts.count[kOrder[3]] = n;
    return parts;
}

}  // namespace nacre::sparkle
