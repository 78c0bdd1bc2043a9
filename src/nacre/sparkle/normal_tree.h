#pragma once

#include <cstdint>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/sparkle/binomial.h"

// A tree of spherical triangles over the normals of facets.

namespace nacre::sparkle {

/// The upper hemisphere as four octants, each halved along its edges into four triangles, over and
/// over. A triangle's mass is the share of facets whose normals it holds: the integral of
/// D(m) (m.n), Beckmann's distribution per projected area, which is 1 over the hemisphere.
/// [jakob-2014, section 4.2]
///
/// D is the same in all octants, so one is stored and the others are turned onto it: memory
/// 0.1 to 6 MB, by depth.
class NormalTree {
 public:
    /// @param alpha     Beckmann roughness, in [1e-4, 2]
    /// @param edge_rad  triangles are halved until their edges are about as long, at most
    ///                  kMaxDepth times
    /// @throws DomainError out of range
    NormalTree(double alpha, double edge_rad);

    static constexpr int kMaxDepth = 7;
    int depth() const { return depth_; }

    /// Which triangle: two bits for the octant, then two for each level from the top.
    using Code = std::uint32_t;
    /// The smallest triangle that holds m, a unit vector upwards.
    Code locate(Vec3f m) const;
    /// Share of the facets in a smallest triangle.
    double mass(Code leaf) const;

    /// A number of facets for each of the four parts of a node.
    struct Parts {
        std::uint64_t count[4];
    };
    /// Splits n facets among the octants.
    static Parts split_octants(std::uint64_t n, std::uint64_t key);
    /// Splits n facets of a triangle among its parts, multinomially by their masses. `node` counts
    /// the triangles of an octant from 0, its own; the parts of `node` are 4 node + 1 .. 4.
    /// @param wanted  bit i: part i is asked for; others may be left at 0
    Parts split(std::uint32_t node, std::uint64_t n, std::uint64_t key, unsigned wanted = 15) const;

 private:
    struct Node {
        Vec3f corner_planes[3];  // positive side: the part at that corner
        double odds[3];          // of kOrder's first three parts, among those that are left
    };
    // Parts in the order in which they take their facets: the corner nearest the pole and the
    // middle first, as they are asked for most.
    static constexpr int kOrder[4] = {2, 3, 0, 1};

    void build(std::uint32_t node, int level, Vec3f a, Vec3f b, Vec3f c, double alpha);

    int depth_;
    std::vector<Node> nodes_;     // those that are split
    std::vector<double> masses_;  // all, within an octant of mass 1/4
};

}  // namespace nacre::sparkle
