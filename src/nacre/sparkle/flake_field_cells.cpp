#include <algorithm>
#include <cmath>

#include "nacre/sparkle/flake_field.h"
#include "nacre/sparkle/lane_bits.h"

// The flakes in the cells that a patch touches, eight at a time.

namespace nacre::sparkle {
namespace {

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, as in SplitMix64

}  // namespace

void FlakeField::find(const FlakePlane& plane, const Weights& weights, Found& found) const {
    const CellRange u_range = plane.u.cells(1 / levels_[0].cell_mm);
    const CellRange v_range = plane.v.cells(1 / levels_[0].cell_mm);
    for (int level = 0; level < kLevels; ++level) {
        if (weights.by_level[level] == 0) continue;
        const int coarser = level * kSideBits;
        const std::int64_t u_last = u_range.last >> coarser, v_last = v_range.last >> coarser;
        for (std::int64_t v = v_range.first >> coarser; v <= v_last; ++v) {
            for (std::int64_t u = u_range.first >> coarser; u <= u_last; ++u) {
                find_in_cell({u, v, level}, plane, weights, found);
            }
        }
    }
}

// A flake is 64 bits: twice 16 are its place in the cell, 16 its rank, by which the sides of the
// rest space share out the flakes, and 16 its size.
inline void FlakeField::find_in_cell(const Cell& cell, const FlakePlane& plane,
                                     const Weights& weights, Found& found) const {
    constexpr ShortBitLanes kNumber = {1, 2, 3, 4, 5, 6, 7, 8};
    constexpr std::uint32_t kShortGolden = 0x9e3779b9u;
    const Level& level = levels_[cell.level];
    const std::uint64_t key =
        mix_bits((level.key + static_cast<std::uint64_t>(plane.side) * kGolden) ^
                 (static_cast<std::uint64_t>(cell.v) << 32 | static_cast<std::uint32_t>(cell.u)));
    const Vec2f corner_mm = {
        static_cast<float>(static_cast<double>(cell.u) * level.cell_mm - plane.u.at_mm),
        static_cast<float>(static_cast<double>(cell.v) * level.cell_mm - plane.v.at_mm)};
    const float grain_mm = static_cast<float>(level.cell_mm * 0x1p-16);
    // The number of flakes exceeds i if the draw exceeds the odds of at most i.
    const float draw = to_unit_float(static_cast<std::uint32_t>(key >> 32));
    const auto& strip = plane.strip;
    const float across[2] = {strip[0].u * corner_mm.x + strip[0].v * corner_mm.y,
                             strip[1].u * corner_mm.x + strip[1].v * corner_mm.y};
    for (int first = 0;; first += kLanes) {
        const FloatLanes odds = load_lanes(&at_most_[first]);
        const ShortBitLanes step = (static_cast<std::uint32_t>(first) + kNumber) * kShortGolden;
        const ShortBitLanes place = mix_short_lanes(static_cast<std::uint32_t>(key) + step);
        const ShortBitLanes kind = mix_short_lanes(static_cast<std::uint32_t>(key >> 32) + step);
        const FloatLanes u = lower_half(place), v = upper_half(place);
        const FloatLanes a = across[0] + (strip[0].u * grain_mm) * u + (strip[0].v * grain_mm) * v;
        const FloatLanes b = across[1] + (strip[1].u * grain_mm) * u + (strip[1].v * grain_mm) * v;
        const LanePacker here((odds <= draw) & (lower_half(kind) < plane.kept) &
                              (a * a < strip[0].half_width2_mm2) &
                              (b * b < strip[1].half_width2_mm2));
        const int k = found.count;
        here.store(&found.place[k], place);
        here.store(&found.kind[k], kind);
        store_lanes(&found.corner_u[k], splat(corner_mm.x));
        store_lanes(&found.corner_v[k], splat(corner_mm.y));
        store_lanes(&found.grain[k], splat(grain_mm));
        store_lanes(&found.weight[k], splat(weights.by_level[cell.level]));
        found.count = std::min(k + here.count(), FlakeView::kMost);
        if (first + kLanes >= kMostFlakesPerCell || draw < at_most_[first + kLanes - 1]) return;
    }
}

void FlakeField::show(const Found& found, const FlakePlane& plane, const PatchOutline& outline,
                      float widening, FlakeView& view) const {
    FloatLanes weight_sum{};
    const bool alike = population_.diameter_spread_um == 0;
    for (int first = 0; first < found.count; first += kLanes) {
        const ShortBitLanes place = load_short_bits(&found.place[first]);
        const ShortBitLanes kind = load_short_bits(&found.kind[first]);
        FloatLanes diameter_um = splat(static_cast<float>(population_.diameter_um));
        for (int i = 0; i < kLanes && !alike; ++i) {
            diameter_um[i] = sizes_.diameter_um(kind[i] >> 16);
        }
        const FloatLanes number = {0, 1, 2, 3, 4, 5, 6, 7};
        const FloatLanes grain = load_lanes(&found.grain[first]);
        const FloatLanes u = load_lanes(&found.corner_u[first]) + grain * lower_half(place);
        const FloatLanes v = load_lanes(&found.corner_v[first]) + grain * upper_half(place);
        const FloatLanes x = plane.u.step.x * u + plane.v.step.x * v;
        const FloatLanes y = plane.u.step.y * u + plane.v.step.y * v;
        const FloatLanes weight = load_lanes(&found.weight[first]) * inverse_cover_ *
                                  outline.coverage(x, y, 0.5e-3f * diameter_um);
        const SlopeLanes slopes =
            gaussian_slopes(unit_share(mix_short_lanes(place + 0x9e3779b9u * kind)),
                            unit_share(mix_short_lanes(kind ^ (place >> 7) ^ (place << 25))));
        const auto visible = (weight > 0.0f) & (number < static_cast<float>(found.count - first));
        weight_sum += visible ? weight : FloatLanes{};
        const LanePacker seen(visible);
        const int k = view.count;
        seen.store(&view.weight[k], weight);
        seen.store(&view.slope_x[k], alpha_ * (plane.turn.x * slopes.x - plane.turn.y * slopes.y));
        seen.store(&view.slope_y[k], alpha_ * (plane.turn.y * slopes.x + plane.turn.x * slopes.y));
        seen.store(&view.lobe_radius[k], widening * lobe_.radius(diameter_um));
        seen.store(&view.place[k], place);
        seen.store(&view.kind[k], kind);
        view.count = std::min(k + seen.count(), FlakeView::kMost);
    }
    view.weight_sum += lane_sum(weight_sum);
}

}  // namespace nacre::sparkle
