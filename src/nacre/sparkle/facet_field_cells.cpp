#include <tuple>
#include <utility>

#include "nacre/sparkle/facet_field.h"

// Large footprints: cell by cell, triangle by triangle.

namespace nacre::sparkle {

// The smallest triangles that the cone's normals lie in, in order, and the share of facets that
// are in both.
struct FacetField::Touched {
    static constexpr int kMost = 512;
    std::array<NormalTree::Code, kMost> code;
    std::array<float, kMost> share;
    int count = 0;

    void add(NormalTree::Code leaf, float mass) {
        // Nodes come ring by ring, so most are found near the end; there are a dozen or so.
        for (int i = 0; i < count; ++i) {
            if (code[i] == leaf) {
                share[i] += mass;
                return;
            }
        }
        // The region is two or three triangles wide and at most 9 alpha / gamma long: never so
        // many.
        if (count == kMost) {
            share[count - 1] += mass;
            return;
        }
        code[count] = leaf;
        share[count++] = mass;
    }
    void sort() {
        for (int i = 1; i < count; ++i) {
            const NormalTree::Code c = code[i];
            const float s = share[i];
            int j = i;
            for (; j > 0 && code[j - 1] > c; --j) {
                code[j] = code[j - 1];
                share[j] = share[j - 1];
            }
            code[j] = c;
            share[j] = s;
        }
    }
};

// The level whose cells are a quarter to a half of the footprint's longer side. Footprints side by
// side answer from the same cells at their border, which makes their random deviations alike there:
// the coarser the cells, the more. Where the deviations are too small to be seen (at the peak an
// eighth of the facets mirror into the cone, say 4000, which vary by 1.6 %), cells are twice as
// large.
int FacetField::coarse_level(const Footprint& footprint) const {
    constexpr double kManyFacets = 3e4;
    const double across = count_ * footprint.area() < kManyFacets ? 4 : 2;
    const Box& b = footprint.bounds();
    const double side = std::max(b.u_hi - b.u_lo, b.v_hi - b.v_lo);
    return std::clamp(static_cast<int>(std::floor(std::log2(across / side))), 0, leaf_level_);
}

void FacetField::count_cells(const Footprint& footprint, Vec3f wi, Vec3f wo,
                             FacetTally& tally) const {
    // The same normals mirror wo into the cone about wi; the rule must not tell which was which.
    if (std::tie(wi.z, wi.x, wi.y) < std::tie(wo.z, wo.x, wo.y)) std::swap(wi, wo);
    Touched touched;
    rule_.visit(wi, wo, [&](FloatLanes x, FloatLanes y, FloatLanes z, FloatLanes share) {
        for (int i = 0; i < kLanes; ++i) {
            if (share[i] > 0) touched.add(normals_->locate({x[i], y[i], z[i]}), share[i]);
        }
    });
    touched.sort();

    std::uint64_t key = 0;
    for_each_cell(footprint, coarse_level(footprint), [&](const Cell& cell) {
        const Box box = cell.box();
        const double side = box.u_hi - box.u_lo;
        const double overlap =
            cell.inside ? 1.0 : std::min(1.0, footprint.shared_area(box) / (side * side));
        if (!(overlap > 0)) return;
        const std::uint64_t cell_key = mix_bits(key_of(cell) + 5 * detail::kNextBits);
        key ^= cell_key;
        const NormalTree::Parts octants = NormalTree::split_octants(cell.count, cell_key);
        int first = 0;
        for (std::uint32_t octant = 0; octant < 4; ++octant) {
            int last = first;
            while (last < touched.count &&
                   touched.code[last] >> (2 * normals_->depth()) == octant) {
                ++last;
            }
            if (last > first && octants.count[octant] > 0) {
                tally.count += count_node(touched, first, last, 0, 0, octants.count[octant],
                                          overlap, mix_bits(cell_key + 8 + octant));
            }
            first = last;
        }
    });
    while (tally.listed < FacetTally::kListed &&
           static_cast<std::uint64_t>(tally.listed) < tally.count) {
        key += detail::kNextBits;
        tally.thickness[tally.listed++] =
            to_unit_float(static_cast<std::uint32_t>(mix_bits(key) >> 32));
    }
}

std::uint64_t FacetField::count_node(const Touched& touched, int first, int last, int level,
                                     std::uint32_t node, std::uint64_t facets, double overlap,
                                     std::uint64_t key) const {
    const std::uint64_t node_key = mix_bits(key ^ node);
    if (level == normals_->depth()) {
        const double mass = normals_->mass(touched.code[first]);
        if (!(mass > 0)) return 0;
        // The cone rule is no exact measure of a triangle: it may find a little more than all of
        // one and less of its neighbours. Counting some twice then keeps the mean.
        const double expected = overlap * touched.share[first] / mass;
        const double times = std::floor(expected);
        return static_cast<std::uint64_t>(times) * facets +
               binomial(facets, expected - times, node_key);
    }
    const int shift = 2 * (normals_->depth() - level - 1);
    unsigned wanted = 0;
    for (int i = first; i < last; ++i) wanted |= 1u << ((touched.code[i] >> shift) & 3);
    const NormalTree::Parts parts = normals_->split(node, facets, node_key, wanted);
    std::uint64_t sum = 0;
    for (std::uint32_t part = 0; part < 4; ++part) {
        int end = first;
        while (end < last && ((touched.code[end] >> shift) & 3) == part) ++end;
        if (end > first && parts.count[part] > 0) {
            sum += count_node(touched, first, end, level + 1, 4 * node + 1 + part,
                              parts.count[part], overlap, key);
        }
        first = end;
    }
    return sum;
}

}  // namespace nacre::sparkle
