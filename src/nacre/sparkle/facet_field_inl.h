#pragma once

#include <algorithm>
#include <cmath>

#include "nacre/sparkle/facet_field.h"
#include "nacre/sparkle/slope_lanes.h"

namespace nacre::sparkle {

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
        cell.inside = overlap == Overlap::whole;
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
    return normalize({alpha_f_ * slopes.x[0], alpha_f_ * slopes.y[0], 1.0f});
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
