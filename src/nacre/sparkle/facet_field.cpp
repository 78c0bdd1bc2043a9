#include "nacre/sparkle/facet_field.h"

#include <numbers>

#include "nacre/core/error.h"

namespace nacre::sparkle {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double whole_number_in_range(double count) {
    require_in_range(count, kFacetCountRange.lo, kFacetCountRange.hi, "number of facets");
    if (count != std::floor(count)) {
        throw DomainError(fmt::format("number of facets = {} is not a whole number", count));
    }
    return count;
}

double gamma_rad(double gamma_deg) {
    require_in_range(gamma_deg, kFacetConeRange.lo, kFacetConeRange.hi,
                     "half-angle of the query cone in deg");
    return gamma_deg * kDegree;
}

double checked_alpha(double alpha) {
    require_in_range(alpha, kFacetRoughnessRange.lo, kFacetRoughnessRange.hi,
                     "roughness alpha of the facets");
    return alpha;
}

}  // namespace

FacetField::FacetField(double count, double alpha, double gamma_deg, std::uint64_t seed)
    : count_(whole_number_in_range(count)),
      alpha_(checked_alpha(alpha)),
      alpha_f_(static_cast<float>(alpha)),
      seed_key_(mix_bits(seed + detail::kNextBits)),
      rule_(gamma_rad(gamma_deg), alpha),
      // Triangles about as large as the region of normals that a cone sees.
      normals_(std::make_shared<NormalTree>(alpha, gamma_rad(gamma_deg))) {
    leaf_level_ = 0;
    for (double n = count_; n > kMostFacetsPerLeaf; n /= 4) ++leaf_level_;
    table_level_ = std::min(kTableLevel, leaf_level_);

    table_.resize(((std::uint64_t{1} << (2 * (table_level_ + 1))) - 1) / 3);
    table_[0] = static_cast<std::uint64_t>(count_);
    std::uint64_t* counts = table_.data();
    for (std::uint32_t level = 0; static_cast<int>(level) < table_level_; ++level) {
        const std::uint32_t side = 1u << level;
        std::uint64_t* below = counts + (std::uint64_t{1} << (2 * level));
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                for (const Cell& part : split({level, x, y, counts[y * side + x], false})) {
                    below[std::uint64_t{part.y} * 2 * side + part.x] = part.count;
                }
            }
        }
        counts = below;
    }
}

bool FacetField::is_explicit(const Footprint& footprint) const {
    const double cells = static_cast<double>(std::uint64_t{1} << leaf_level_);
    const Box& b = footprint.bounds();
    const double width = (b.u_hi - b.u_lo) * cells, height = (b.v_hi - b.v_lo) * cells;
    // A convex shape touches about as many cells as its area plus its half outline in cells.
    return footprint.area() * cells * cells + width + height <= kMostLeaves;
}

FacetTally FacetField::count(const Footprint& footprint, Vec3f wi, Vec3f wo) const {
    FacetTally tally;
    if (!(footprint.area() > 0)) return tally;
    if (is_explicit(footprint)) {
        count_facets(footprint, {wi, wo, rule_.chord2()}, tally);
    } else {
        count_cells(footprint, wi, wo, tally);
    }
    return tally;
}

}  // namespace nacre::sparkle
