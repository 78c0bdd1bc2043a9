#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/sparkle/facet_field.h"

namespace nacre::sparkle {

inline std::array<FacetField::Cell, 4> FacetField::split(const Cell& cell) const {
    const std::uint64_t key = key_of(cell);
    const std::uint64_t left = half_binomial(cell.count, mix_bits(key + 1));
    const std::uint64_t left_low = half_binomial(left, mix_bits(key + 2));
    const std::uint64_t right_low = half_binomial(cell.count - left, mix_bits(key + 3));
    const std::uint32_t level = cell.level + 1, x = 2 * cell.x, y = 2 * cell.y;
    return {{{level, x, y, left_low, cell.inside},
             {level, x, y + 1, left - left_low, cell.inside},
             {level, x + 1, y, right_low, cell.inside},
             {level, x + 1, y + 1, cell.count - left - right_low, cell.inside}}};
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
            // Depth first: three cells wait on every level, and four at the bottom.
            std::array<Cell, 3 * 29 + 4> waiting;
            int count = 0;
            waiting[count] = {start, x, y, counts[(std::uint64_t{y} << start) + x], false};
            if (waiting[0].count > 0 && classify(waiting[0])) count = 1;
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

template <class Visit>
void FacetField::for_each_in_leaf(const Footprint& footprint, const Cell& cell,
                                  Visit&& visit) const {
    const std::uint64_t key = key_of(cell);
    const double side = 1.0 / static_cast<double>(std::uint64_t{1} << cell.level);
    for (std::uint64_t i = 0; i < cell.count; ++i) {
        const std::uint64_t place = mix_bits(key + (i + 4) * detail::kNextBits);
        const double u = (cell.x + static_cast<double>(place >> 32) * 0x1p-32) * side;
        const double v = (cell.y + static_cast<double>(place & 0xffffffffu) * 0x1p-32) * side;
        if (cell.inside || footprint.contains(u, v)) visit(place, u, v);
    }
}

inline Vec3f FacetField::normal_of(std::uint64_t bits) const {
    // Slopes are Gaussian: exp(-tan^2 / alpha^2) is even in (0, 1). [walter-2007, eq. 28]
    const float survival = (static_cast<float>(bits >> 32) + 0.5f) * 0x1p-32f;
    const float tangent = alpha_f_ * std::sqrt(std::max(0.0f, -std::log(survival)));
    const float turns = static_cast<float>(bits & 0xffffffffu) * 0x1p-32f;
    const float angle = 2 * std::numbers::pi_v<float> * turns;
    return normalize({tangent * std::cos(angle), tangent * std::sin(angle), 1.0f});
}

template <class Visit>
void FacetField::for_each_facet(const Footprint& footprint, Visit&& visit) const {
    for_each_cell(footprint, leaf_level_, [&](const Cell& cell) {
        for_each_in_leaf(footprint, cell, [&](std::uint64_t place, double u, double v) {
            const std::uint64_t bits = mix_bits(place + detail::kNextBits);
            visit(Facet{u, v, normal_of(bits), thickness_of(bits)});
        });
    });
}

}  // namespace nacre::sparkle
