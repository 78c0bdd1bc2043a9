#include <algorithm>
#include <cmath>

#include "nacre/sparkle/flake_field.h"
#include "nacre/sparkle/lane_bits.h"

// The flakes in the cells that a patch touches, eight at a time.

namespace nacre::sparkle {
namespace {

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, as in SplitMix64

}  // namespace

void FlakeField::find(const FlakePlane& plane, const PatchOutline& outline, const Weights& weights,
                      Found& found) const {
    const CellRange u_range = plane.u.cells(1 / levels_[0].cell_mm);
    const CellRange v_range = plane.v.cells(1 / levels_[0].cell_mm);
    for (int i = 0; i < kLevels; ++i) {
        const float weight = weights.by_level[i];
        if (weight == 0) continue;
        const Level& level = levels_[i];
        const std::uint64_t key = level.key + static_cast<std::uint64_t>(plane.side) * kGolden;
        const int coarser = i * kSideBits;
        const std::int64_t u_first = u_range.first >> coarser, u_last = u_range.last >> coarser;
        const std::int64_t v_first = v_range.first >> coarser, v_last = v_range.last >> coarser;
        const float grain_mm = static_cast<float>(level.cell_mm * 0x1p-16);
        for (std::int64_t v = v_first; v <= v_last; ++v) {
            const double v_mm = static_cast<double>(v) * level.cell_mm - plane.v.at_mm;
            for (std::int64_t u = u_first; u <= u_last; ++u) {
                const double u_mm = static_cast<double>(u) * level.cell_mm - plane.u.at_mm;
                const std::uint64_t place =
                    static_cast<std::uint64_t>(v) << 32 | static_cast<std::uint32_t>(u);
                find_in_cell(mix_bits(key ^ place),
                             {static_cast<float>(u_mm), static_cast<float>(v_mm)}, grain_mm, plane,
                             outline, weight, found);
            }
        }
    }
}

// A flake is 64 bits: twice 16 are its place in the cell, 16 its rank, by which the sides of the
// rest space share out the flakes, and 16 its size.
inline void FlakeField::find_in_cell(std::uint64_t key, Vec2f corner_mm, float grain_mm,
                                     const FlakePlane& plane, const PatchOutline& outline,
                                     float weight, Found& found) const {
    constexpr ShortBitLanes kNumber = {1, 2, 3, 4, 5, 6, 7, 8};
    constexpr std::uint32_t kShortGolden = 0x9e3779b9u;
    // The number of flakes exceeds i if the draw exceeds the odds of at most i.
    const float draw = to_unit_float(static_cast<std::uint32_t>(key >> 32));
    for (int first = 0;; first += kLanes) {
        const FloatLanes odds = load_lanes(&at_most_[first]);
        const ShortBitLanes step = (static_cast<std::uint32_t>(first) + kNumber) * kShortGolden;
        const ShortBitLanes place = mix_short_lanes(static_cast<std::uint32_t>(key) + step);
        const ShortBitLanes kind = mix_short_lanes(static_cast<std::uint32_t>(key >> 32) + step);
        const FloatLanes u = corner_mm.x + grain_mm * lower_half(place);
        const FloatLanes v = corner_mm.y + grain_mm * upper_half(place);
        const FloatLanes x = plane.u.step.x * u + plane.v.step.x * v;
        const FloatLanes y = plane.u.step.y * u + plane.v.step.y * v;
        const LanePacker here((odds <= draw) & (lower_half(kind) < plane.kept) &
                              outline.touches(x, y));
        here.store(&found.place[found.count], place);
        here.store(&found.kind[found.count], kind);
        here.store(&found.x[found.count], x);
        here.store(&found.y[found.count], y);
        store_lanes(&found.weight[found.count], splat(weight));
        found.count = std::min(found.count + here.count(), FlakeView::kMost);
        if (first + kLanes >= kMostFlakesPerCell || draw < at_most_[first + kLanes - 1]) return;
    }
}

void FlakeField::show(const Found& found, const FlakePlane& plane, const PatchOutline& outline,
                      FlakeView& view) const {
    const bool alike = population_.diameter_spread_um == 0;
    for (int first = 0; first < found.count; first += kLanes) {
        const ShortBitLanes place = load_short_bits(&found.place[first]);
        const ShortBitLanes kind = load_short_bits(&found.kind[first]);
        FloatLanes diameter_um = splat(static_cast<float>(population_.diameter_um));
        for (int i = 0; i < kLanes && !alike; ++i) {
            diameter_um[i] = sizes_.diameter_um(kind[i] >> 16);
        }
        const FloatLanes number = {0, 1, 2, 3, 4, 5, 6, 7};
        const FloatLanes x = load_lanes(&found.x[first]), y = load_lanes(&found.y[first]);
        const FloatLanes weight = load_lanes(&found.weight[first]) * inverse_cover_ *
                                  outline.coverage(x, y, 0.5e-3f * diameter_um);
        const BitLanes bits = mix_lanes(__builtin_convertvector(place, BitLanes) +
                                        (__builtin_convertvector(kind, BitLanes) << 32));
        const SlopeLanes slopes = gaussian_slopes(bits);
        const LanePacker seen((weight > 0.0f) & (number < static_cast<float>(found.count - first)));
        seen.store(&view.weight[view.count], weight);
        seen.store(&view.slope_x[view.count],
                   alpha_ * (plane.turn.x * slopes.x - plane.turn.y * slopes.y));
        seen.store(&view.slope_y[view.count],
                   alpha_ * (plane.turn.y * slopes.x + plane.turn.x * slopes.y));
        seen.store(&view.lobe_radius[view.count], lobe_.radius(diameter_um));
        seen.store(&view.place[view.count], place);
        seen.store(&view.kind[view.count], kind);
        view.count = std::min(view.count + seen.count(), FlakeView::kMost);
    }
}

}  // namespace nacre::sparkle
