#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/sparkle/footprint.h"
#include "nacre/sparkle/lane_bits.h"
#include "nacre/sparkle/normal_tree.h"
#include "nacre/sparkle/reflection_cone.h"

// The facets of an object: up to 1e15 of them, none of them stored.
// [jakob-2014, section 4; guo-2018; docs/special-effect.md]

namespace nacre::sparkle {

inline constexpr Range kFacetCountRange{.lo = 0, .hi = 1e15};
inline constexpr Range kFacetRoughnessRange{.lo = 0.001, .hi = 1};
inline constexpr Range kFacetConeRange{.lo = 0.05, .hi = 30, .unit = "deg"};

/// One facet: its place in the unit square, its unit normal, and where its film lies in the spread
/// of thicknesses, evenly in [0, 1).
struct Facet {
    double u, v;
    Vec3f normal;
    float thickness;
};

/// What a query counted.
struct FacetTally {
    /// The largest number of facets whose thickness is listed.
    static constexpr int kListed = 32;

    std::uint64_t count = 0;
    /// Thicknesses, as in Facet, of the first min(count, kListed) facets that were met: a random
    /// sample, as the order does not depend on the thickness.
    std::array<float, kListed> thickness;
    int listed = 0;

    void add(float fraction) {
        if (listed < kListed) thickness[listed++] = fraction;
        ++count;
    }
};

/// K facets, independent of each other: positions even over the unit square, normals of a Beckmann
/// surface (per projected area: Gaussian slopes), thicknesses even in [0, 1).
///
/// A fixed hierarchy of cells. Positions are split first: a quadtree, whose cells pass their facets
/// on to their quarters by the binomial law, down to cells that expect 16 to 64 facets; there each
/// facet is a hash of its cell and its number. For footprints over many such cells, larger cells
/// split their facets among spherical triangles of normals; of a cell or a triangle that lies only
/// partly in the footprint or the cone, a binomial number of facets counts. Every random number is
/// a hash of the seed and of the place in the tree, so that all queries, in any order and on any
/// thread, see the same facets.
///
/// Cost is bounded for any number of facets and any footprint; queries allocate nothing.
class FacetField {
 public:
    /// @param count      K, in kFacetCountRange, a whole number
    /// @param alpha      Beckmann roughness, in kFacetRoughnessRange
    /// @param gamma_deg  half-angle of the cones that will be asked for, in kFacetConeRange
    /// @throws DomainError naming the argument, its value and its range
    FacetField(double count, double alpha, double gamma_deg, std::uint64_t seed);

    double facets() const { return count_; }
    double alpha() const { return alpha_; }
    const ConeRule& cone_rule() const { return rule_; }

    /// How many facets lie in the footprint and reflect wi into the cone of half-angle gamma about
    /// wo; unit vectors upwards. Its distribution is that of facets() independent facets, for every
    /// footprint: the mean is facets() footprint.area() f with f = ConeRule::Means::projected times
    /// ConeRule::solid_angle().
    ///
    /// Facet by facet where is_explicit(footprint). Other footprints agree with each other and with
    /// those in how many facets the larger cells hold, and not on which of these they are.
    FacetTally count(const Footprint& footprint, Vec3f wi, Vec3f wo) const;

    /// Whether a footprint is small enough to be counted facet by facet: it touches at most
    /// kMaxLeaves or so of the smallest cells, so holds up to some 700 to 2500 facets.
    bool is_explicit(const Footprint& footprint) const;

    /// Calls visit(const Facet&) for every facet in the footprint, whatever their number.
    template <class Visit>
    void for_each_facet(const Footprint& footprint, Visit&& visit) const;

 private:
    // A square cell; `inside`: wholly within the footprint.
    struct Cell {
        std::uint32_t level, x, y;
        std::uint64_t count;
        bool inside;

        Box box() const {
            const double side = 1.0 / static_cast<double>(std::uint64_t{1} << level);
            return {x * side, y * side, (x + 1) * side, (y + 1) * side};
        }
    };
    struct NormalFilter;
    struct Candidates;
    struct Touched;

    static constexpr int kTableLevel = 8;
    static constexpr double kMaxFacetsPerLeaf = 64;
    static constexpr double kMaxLeaves = 60;

    std::uint64_t key_of(const Cell& cell) const {
        return mix_bits(seed_key_ ^ (static_cast<std::uint64_t>(cell.level) << 58 |
                                     static_cast<std::uint64_t>(cell.x) << 29 | cell.y));
    }
    std::array<Cell, 4> split(const Cell& cell) const;
    // The part with these numbers among those of the next level; as split(), for less.
    Cell part(const Cell& cell, std::uint32_t x, std::uint32_t y) const;
    // Calls visit(cell) for the cells of a level that share area with the footprint.
    template <class Visit>
    void for_each_cell(const Footprint& footprint, int level, Visit&& visit) const;
    // The bits of a facet of a smallest cell: its place in the cell, and its normal.
    static std::uint64_t place_bits(std::uint64_t cell_key, std::uint64_t facet) {
        return mix_bits(cell_key + (facet + 4) * detail::kNextBits);
    }
    static std::uint64_t normal_bits(std::uint64_t place) {
        return mix_bits(place + detail::kNextBits);
    }
    Vec3f normal_of(std::uint64_t bits) const;
    static float thickness_of(std::uint64_t normal_bits) {
        return to_unit_float(
            static_cast<std::uint32_t>(mix_bits(normal_bits + detail::kNextBits) >> 32));
    }

    void count_facets(const Footprint& footprint, const ReflectionCone& cone,
                      FacetTally& tally) const;
    void count_leaf(const Footprint& footprint, const Cell& cell, const NormalFilter& filter,
                    Candidates& candidates) const;
    void count_cells(const Footprint& footprint, Vec3f wi, Vec3f wo, FacetTally& tally) const;
    std::uint64_t count_node(const Touched& touched, int first, int last, int level,
                             std::uint32_t node, std::uint64_t facets, double overlap,
                             std::uint64_t key) const;
    int coarse_level(const Footprint& footprint) const;

    double count_, alpha_;
    float alpha_f_;
    std::uint64_t seed_key_;
    int leaf_level_, table_level_;  ///< of the smallest cells, 4^level of them; of those in table_
    ConeRule rule_;
    std::shared_ptr<const NormalTree> normals_;
    std::vector<std::uint64_t> table_;  // counts of the cells of the first levels, level by level
};

inline std::array<FacetField::Cell, 4> FacetField::split(const Cell& cell) const {
    const std::uint64_t key = key_of(cell);
    const std::uint64_t left = half_binomial(cell.count, key + 1);
    const std::uint64_t left_low = half_binomial(left, key + 2);
    const std::uint64_t right_low = half_binomial(cell.count - left, key + 3);
    const std::uint32_t level = cell.level + 1, x = 2 * cell.x, y = 2 * cell.y;
    return {{{level, x, y, left_low, cell.inside},
             {level, x, y + 1, left - left_low, cell.inside},
             {level, x + 1, y, right_low, cell.inside},
             {level, x + 1, y + 1, cell.count - left - right_low, cell.inside}}};
}

inline FacetField::Cell FacetField::part(const Cell& cell, std::uint32_t x, std::uint32_t y) const {
    const std::uint64_t key = key_of(cell);
    const bool right = x & 1, high = y & 1;
    const std::uint64_t left = half_binomial(cell.count, key + 1);
    const std::uint64_t half = right ? cell.count - left : left;
    const std::uint64_t low = half_binomial(half, key + 2 + right);
    return {cell.level + 1, x, y, high ? half - low : low, cell.inside};
}

template <class Visit>
void FacetField::for_each_cell(const Footprint& footprint, int level, Visit&& visit) const {
    if (!(footprint.area() > 0)) return;
    const auto classify = [&](Cell& cell) {
        if (cell.inside) return true;
        const Overlap overlap = footprint.overlap(cell.box());
        cell.inside = overlap == Overlap::full;
        return overlap != Overlap::none;
    };
    const std::uint32_t start = std::min(level, table_level_);
    const std::uint64_t* counts = &table_[((std::uint64_t{1} << (2 * start)) - 1) / 3];
    const double cells = static_cast<double>(1u << start);
    const auto index = [&](double x) {
        return static_cast<std::uint32_t>(std::clamp(x * cells, 0.0, cells - 1));
    };
    const Box& bounds = footprint.bounds();
    const std::uint32_t x_last = index(bounds.u_hi), y_last = index(bounds.v_hi);
    for (std::uint32_t y = index(bounds.v_lo); y <= y_last; ++y) {
        for (std::uint32_t x = index(bounds.u_lo); x <= x_last; ++x) {
            Cell top = {start, x, y, counts[(std::uint64_t{y} << start) + x], false};
            if (top.count == 0 || !classify(top)) continue;
            // Straight down, while a small footprint lies within one of the parts.
            while (static_cast<int>(top.level) < level && top.count > 0) {
                const double parts = static_cast<double>(std::uint64_t{2} << top.level);
                const auto u_lo = static_cast<std::uint32_t>(bounds.u_lo * parts);
                const auto v_lo = static_cast<std::uint32_t>(bounds.v_lo * parts);
                if (u_lo != static_cast<std::uint32_t>(bounds.u_hi * parts) || u_lo >> 1 != top.x ||
                    v_lo != static_cast<std::uint32_t>(bounds.v_hi * parts) || v_lo >> 1 != top.y) {
                    break;
                }
                top = part(top, u_lo, v_lo);
            }
            if (top.count == 0) continue;
            // Then depth first: three cells wait on every level, and four at the bottom.
            std::array<Cell, 3 * 29 + 4> waiting;
            int count = 1;
            waiting[0] = top;
            while (count > 0) {
                const Cell cell = waiting[--count];
                if (static_cast<int>(cell.level) == level) {
                    visit(cell);
                    continue;
                }
                for (Cell part : split(cell)) {
                    if (part.count > 0 && classify(part)) waiting[count++] = part;
                }
            }
        }
    }
}

inline Vec3f FacetField::normal_of(std::uint64_t bits) const {
    const SlopeLanes slopes = gaussian_slopes(BitLanes{bits});
    return normalize(Vec3f{alpha_f_ * slopes.x[0], alpha_f_ * slopes.y[0], 1.0f});
}

template <class Visit>
void FacetField::for_each_facet(const Footprint& footprint, Visit&& visit) const {
    for_each_cell(footprint, leaf_level_, [&](const Cell& cell) {
        const std::uint64_t key = key_of(cell);
        const Box box = cell.box();
        const double side = box.u_hi - box.u_lo;
        for (std::uint64_t i = 0; i < cell.count; ++i) {
            const std::uint64_t place = place_bits(key, i), normal = normal_bits(place);
            const double u = box.u_lo + static_cast<double>(place >> 32) * 0x1p-32 * side;
            const double v = box.v_lo + static_cast<double>(place & 0xffffffffu) * 0x1p-32 * side;
            if (footprint.contains(u, v)) {
                visit(Facet{u, v, normal_of(normal), thickness_of(normal)});
            }
        }
    });
}

}  // namespace nacre::sparkle
