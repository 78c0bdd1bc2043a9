#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "nacre/core/range.h"
#include "nacre/sparkle/footprint.h"
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
    /// Of how many facets the thickness is told.
    static constexpr int kListed = 32;

    std::uint64_t count = 0;
    /// Thicknesses, as in Facet, of the first min(count, kListed) facets that were met, which says
    /// nothing about their thickness: they stand for all.
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
/// facet is a hash of its cell and its number. Footprints that reach over many such cells are
/// answered from larger cells, which split their facets among spherical triangles of normals, and
/// thin out what a footprint or a cone shares with a part of them. Every random number is a hash of
/// the seed and of the place in the tree, so that all queries, in any order and on any thread, see
/// the same facets.
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

    /// How many facets lie in the footprint and mirror wi into the cone of half-angle gamma about
    /// wo; unit vectors upwards. The law of the answer is that of count() independent facets, for
    /// every footprint: its mean is count() area share, where share is the cone rule's.
    ///
    /// Facet by facet where is_explicit(footprint). Other footprints agree with each other and with
    /// those in how many facets the larger cells hold, and not on which of these they are.
    FacetTally count(const Footprint& footprint, Vec3f wi, Vec3f wo) const;

    /// Whether a footprint is small enough to be counted facet by facet: it touches at most
    /// kMostLeaves or so of the smallest cells, so holds up to some 700 to 2500 facets.
    bool is_explicit(const Footprint& footprint) const;

    /// Calls visit(const Facet&) for every facet in the footprint, whatever their number.
    template <class Visit>
    void for_each_facet(const Footprint& footprint, Visit&& visit) const;

    /// The smallest cells: 4^level of them.
    int leaf_level() const { return leaf_level_; }

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
    static constexpr double kMostFacetsPerLeaf = 64;
    static constexpr double kMostLeaves = 60;

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
    int leaf_level_, table_level_;
    ConeRule rule_;
    std::shared_ptr<const NormalTree> normals_;
    std::vector<std::uint64_t> table_;  // counts of the cells of the first levels, level by level
};

}  // namespace nacre::sparkle

#include "nacre/sparkle/facet_field_inl.h"  // IWYU pragma: export
