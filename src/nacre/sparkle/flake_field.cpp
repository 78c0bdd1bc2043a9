#include "nacre/sparkle/flake_field.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/sparkle/flake_plane.h"
#include "nacre/sparkle/lane_bits.h"

namespace nacre::sparkle {

FlakeField::FlakeField(const FlakePopulation& population, std::uint64_t seed)
    : population_(population),
      sizes_(population.sizes.value_or(
          paint::FlakeSizes(population.diameter_um, population.diameter_spread_um))),
      lobe_(population.alpha, population.ior, population.coat_roughness, population.waviness) {
    require_in_range(population.density_per_mm2, 1e-9, 1e15, "flakes per mm^2");
    const double density = population.density_per_mm2;
    double all = 0;
    for (int i = 0; i < kLevels; ++i) all += std::pow(kLevelRatio, -i);
    for (int i = 0; i < kLevels; ++i) {
        const double fraction = std::pow(kLevelRatio, -i) / all;
        const double cell = std::sqrt(kFlakesPerCell / (density * double{kMaxStretch} * fraction));
        levels_[i] = {cell, hash_of(seed, static_cast<std::uint64_t>(i))};
        per_mm_[i] = static_cast<float>(1 / cell);
        fraction_[i] = static_cast<float>(fraction);
    }
    double probability = std::exp(-kFlakesPerCell), sum = 0;
    for (int n = 0; n < kMaxFlakesPerCell; ++n) {
        sum += probability;
        cumulative_[n] = static_cast<float>(sum);
        probability *= kFlakesPerCell / (n + 1);
    }

    alpha_ = static_cast<float>(population.alpha);
    largest_radius_mm_ = static_cast<float>(0.5e-3 * sizes_.largest_um());
    smallest_radius_mm_ = static_cast<float>(0.5e-3 * sizes_.smallest_um());
    inverse_cover_ = static_cast<float>(1 / (density * sizes_.mean_area_um2() * 1e-6));
    typical_radius_ = lobe_.radius(static_cast<float>(population.diameter_um)) / alpha_;
    constexpr float kWidest = 0.32f;
    max_widening_ = std::max(
        1.0f, kWidest / std::hypot(typical_radius_, std::sqrt(lobe_.spread_radius2(lobe_.spread2(
                                                        lobe_.coat().spread2(1, 1)))) /
                                                        alpha_));
    // A point resolves its flakes, unless too many lie over each other.
    constexpr float kFewestCells = 6, kMaxCells = 12;
    const float across = 1 + 2 * largest_radius_mm_ / static_cast<float>(levels_[0].cell_mm);
    full_cells_ = splat(std::clamp(1.5f * across * across, kFewestCells, kMaxCells));
    for (int i = 0; const float cells : Constants::kFinestCells) full_cells_[i++] = cells;
}

double FlakeField::exact_side_mm() const {
    // The side that touches full_cells_ as level_weights() counts them, less a margin for rounding.
    constexpr double kSafety = 0.999;
    const double side = levels_[0].cell_mm * (std::sqrt(double{full_cells_[0]}) - 1) -
                        2 * double{largest_radius_mm_};
    return kSafety * std::max(0.0, side);
}

float FlakeField::lobe_area(float cosine) const {
    const float radius = typical_radius_ * alpha_ * lobe_.widening(1, cosine);
    const float coat = lobe_.spread_radius2(lobe_.spread2(lobe_.coat().spread2(cosine, cosine)));
    return 5 * std::numbers::pi_v<float> / 9 * (radius * radius + coat);  // Int K^2 = 9/(5 pi r^2)
}

FlakeField::Constants FlakeField::constants() const {
    Constants out;
    for (int level = 0; level < kLevels; ++level) {
        out.cell_mm[level] = levels_[level].cell_mm;
        out.key[level] = levels_[level].key;
        out.fraction[level] = fraction_[level];
        out.full_cells[level] = full_cells_[level];
    }
    out.cumulative = cumulative_;
    out.inverse_cover = inverse_cover_;
    out.typical_radius = typical_radius_;
    out.max_widening = max_widening_;
    return out;
}

FlakeField::Weights FlakeField::begin(const float* side_mm, const StandIns& stand_ins,
                                      FlakeView& view) const {
    const Weights weights = level_weights(side_mm, stand_ins);
    view.count = 0;
    view.weight_sum = 0;
    view.background = 1 - weights.resolved;
    view.widening = weights.widening;
    view.typical_radius = typical_radius_;
    return weights;
}

void FlakeField::leave_out(const ObjectSpaceFootprint& patch, FlakeView& view,
                           const StandIns& stand_ins) const {
    const float side_mm[] = {length(patch.edge_mm[0]), length(patch.edge_mm[1])};
    begin(side_mm, stand_ins, view);
}

void FlakeField::query(const ObjectSpaceFootprint& patch, FlakeView& view,
                       const StandIns& stand_ins) const {
    const PatchOutline outline(patch, smallest_radius_mm_, largest_radius_mm_);
    const Weights weights = begin(outline.size_mm, stand_ins, view);
    if (weights.resolved == 0) return;
    const Projections projections = projections_of(patch.normal);
    for (int i = 0; i < projections.count; ++i) {
        const FlakePlane plane(patch, outline, projections.list[i]);
        Found found;
        find(plane, weights, found);
        show(found, plane, outline, weights.widening, view);
    }
    // Padding to a whole vector: flakes beyond the widest lobe that a coat may make, which reflect
    // nothing.
    constexpr float kBeyond = 1e3f;
    store_lanes(&view.slope_x[view.count], splat(kBeyond));
    store_lanes(&view.slope_y[view.count], splat(kBeyond));
    store_lanes(&view.lobe_radius[view.count], FloatLanes{});
}

// A level is resolved while the patch touches few of its cells.
FlakeField::Weights FlakeField::level_weights(const float* side_mm,
                                              const StandIns& stand_ins) const {
    /// Where a level has faded out, in terms of full_cells_.
    constexpr float kFaded = 2.3f;
    const FloatLanes cells = (1.0f + (side_mm[0] + 2 * largest_radius_mm_) * per_mm_) *
                             (1.0f + (side_mm[1] + 2 * largest_radius_mm_) * per_mm_);
    Weights weights;
    if (cells[0] <= full_cells_[0]) {  // every level: the most common case
        weights.by_level = splat(1.0f);
        weights.resolved = 1;
        return weights;
    }
    const FloatLanes t = min_lanes(
        max_lanes((kFaded - cells / full_cells_) / (kFaded - 1), FloatLanes{}), splat(1.0f));
    // Squared, as a level gives way to the next, of a sixteenth of its density, near the end.
    const FloatLanes w = t * t;
    const float first = lane_sum(w * fraction_), second = lane_sum(w * w * fraction_);
    if (second == 0) return weights;
    // Scaled up to the mean of all flakes, those resolved have N = deviation_ratio^2 times their
    // variance. Lobes wider by B, nearly deviation_ratio, undo that, but a lobe must stay narrower than the
    // distribution of slopes: the remaining excess is removed by background. There is always some
    // background, for resolved_factor().                               [docs/nacre-model.md: N, B]
    constexpr float kMaxResolved = 0.95f;
    const float deviation_ratio = std::sqrt(second) / first;
    const float area = stand_ins.light_area;
    if (area <= 1) {
        weights.widening = std::clamp(kMaxResolved * deviation_ratio, 1.0f, max_widening_);
    }
    // The variance of what lobes of an area show of a light goes with 1 / (their area + its own).
    const float contrast = std::sqrt((weights.widening * weights.widening + area) / (1 + area));
    weights.resolved = std::min((area <= 1 ? contrast : 1.0f) / deviation_ratio, 1.0f);
    weights.by_level = w * (weights.resolved / first);
    return weights;
}

// The flakes in the cells that a patch touches, eight at a time.

std::uint64_t FlakeField::cell_key(std::uint64_t level, int side, std::int64_t u, std::int64_t v) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, as in SplitMix64
    return mix_bits((level + static_cast<std::uint64_t>(side) * kGolden) ^
                    (static_cast<std::uint64_t>(v) << 32 | static_cast<std::uint32_t>(u)));
}

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

// A flake is 64 bits: twice 16 are its place in the cell, 16 its rank, by which the flakes are
// divided among the six sides of object space, and the last 8 its size.
inline void FlakeField::find_in_cell(const Cell& cell, const FlakePlane& plane,
                                     const Weights& weights, Found& found) const {
    constexpr UintLanes kNumber = {0, 1, 2, 3, 4, 5, 6, 7};
    const Level& level = levels_[cell.level];
    const std::uint64_t key = cell_key(level.key, plane.side, cell.u, cell.v);
    const Vec2f corner_mm = {
        static_cast<float>(static_cast<double>(cell.u) * level.cell_mm - plane.u.at_mm),
        static_cast<float>(static_cast<double>(cell.v) * level.cell_mm - plane.v.at_mm)};
    const float grain_mm = static_cast<float>(level.cell_mm * 0x1p-16);
    // The number of flakes exceeds i if the draw exceeds the probability of at most i.
    const float draw = to_unit_float(static_cast<std::uint32_t>(key >> 32));
    const auto& strip = plane.strip;
    const float across[2] = {strip[0].u * corner_mm.x + strip[0].v * corner_mm.y,
                             strip[1].u * corner_mm.x + strip[1].v * corner_mm.y};
    for (int first = 0;; first += kLanes) {
        const FloatLanes probability = load_lanes(&cumulative_[first]);
        const auto [place, kind] =
            flake_bits<UintLanes>(key, static_cast<std::uint32_t>(first) + kNumber);
        const FloatLanes u = lower_half(place), v = upper_half(place);
        const FloatLanes a = across[0] + (strip[0].u * grain_mm) * u + (strip[0].v * grain_mm) * v;
        const FloatLanes b = across[1] + (strip[1].u * grain_mm) * u + (strip[1].v * grain_mm) * v;
        const LanePacker here((probability <= draw) & (lower_half(kind) < plane.kept) &
                              (a * a < strip[0].half_width2_mm2) &
                              (b * b < strip[1].half_width2_mm2));
        const int k = found.count;
        here.store(&found.place[k], place);
        here.store(&found.kind[k], kind);
        store_lanes(&found.corner_u[k], splat(corner_mm.x));
        store_lanes(&found.corner_v[k], splat(corner_mm.y));
        store_lanes(&found.grain[k], splat(grain_mm));
        store_lanes(&found.weight[k], splat(weights.by_level[cell.level]));
        found.count = std::min(k + here.count(), FlakeView::kMax);
        if (first + kLanes >= kMaxFlakesPerCell || draw < cumulative_[first + kLanes - 1]) return;
    }
}

void FlakeField::show(const Found& found, const FlakePlane& plane, const PatchOutline& outline,
                      float widening, FlakeView& view) const {
    constexpr FloatLanes kNumber = {0, 1, 2, 3, 4, 5, 6, 7};
    // Which of them touch the patch, now by their own size.
    FlakeView::List<float> touching_x, touching_y, touching_weight;
    const int begin = view.count;
    for (int first = 0; first < found.count; first += kLanes) {
        const UintLanes place = load_short_bits(&found.place[first]);
        const UintLanes kind = load_short_bits(&found.kind[first]);
        const FloatLanes grain = load_lanes(&found.grain[first]);
        const FloatLanes u = load_lanes(&found.corner_u[first]) + grain * lower_half(place);
        const FloatLanes v = load_lanes(&found.corner_v[first]) + grain * upper_half(place);
        const FloatLanes x = plane.u.step.x * u + plane.v.step.x * v;
        const FloatLanes y = plane.u.step.y * u + plane.v.step.y * v;
        const LanePacker touching(
            outline.touches(
                x, y,
                0.5e-3f * gather(sizes_.diameters_um(), std::bit_cast<IntLanes>(kind >> 24))) &
            (kNumber < static_cast<float>(found.count - first)));
        const int k = view.count;
        touching.store(&view.place[k], place);
        touching.store(&view.kind[k], kind);
        touching.store(&touching_x[k], x);
        touching.store(&touching_y[k], y);
        touching.store(&touching_weight[k], load_lanes(&found.weight[first]));
        view.count = std::min(k + touching.count(), FlakeView::kMax);
    }
    FloatLanes weight_sum{};
    for (int k = begin; k < view.count; k += kLanes) {
        const UintLanes place = load_short_bits(&view.place[k]);
        const UintLanes kind = load_short_bits(&view.kind[k]);
        const FloatLanes diameter_um =
            gather(sizes_.diameters_um(), std::bit_cast<IntLanes>(kind >> 24));
        const FloatLanes weight =
            load_lanes(&touching_weight[k]) * inverse_cover_ *
            outline.coverage(load_lanes(&touching_x[k]), load_lanes(&touching_y[k]),
                             0.5e-3f * diameter_um) *
            outline.relative_weight(load_lanes(&touching_x[k]), load_lanes(&touching_y[k]),
                                    0.5e-3f * diameter_um);
        weight_sum += kNumber < static_cast<float>(view.count - k) ? weight : FloatLanes{};
        const SlopeLanes slopes =
            gaussian_slopes(unit_fraction(mix_bits_32(place + 0x9e3779b9u * kind)),
                            unit_fraction(mix_bits_32(kind ^ (place >> 7) ^ (place << 25))));
        store_lanes(&view.weight[k], weight);
        store_lanes(&view.slope_x[k], alpha_ * (plane.turn.x * slopes.x - plane.turn.y * slopes.y));
        store_lanes(&view.slope_y[k], alpha_ * (plane.turn.y * slopes.x + plane.turn.x * slopes.y));
        store_lanes(&view.lobe_radius[k], widening * lobe_.radius(diameter_um));
    }
    view.weight_sum += lane_sum(weight_sum);
}

}  // namespace nacre::sparkle
