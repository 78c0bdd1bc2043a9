#include "nacre/sparkle/flake_field.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/sparkle/projection.h"

namespace nacre::sparkle {

FlakeField::FlakeField(const FlakePopulation& population, std::uint64_t seed)
    : population_(population),
      sizes_(population.diameter_um, population.diameter_spread_um),
      lobe_(population.alpha, population.ior) {
    require_in_range(population.density_per_mm2, 1e-9, 1e15, "flakes per mm^2");
    const double density = population.density_per_mm2;
    double all = 0;
    for (int i = 0; i < kLevels; ++i) all += std::pow(kLevelRatio, -i);
    for (int i = 0; i < kLevels; ++i) {
        const double share = std::pow(kLevelRatio, -i) / all;
        const double cell = std::sqrt(kFlakesPerCell / (density * double{kMostStretch} * share));
        levels_[i] = {cell, hash_of(seed, static_cast<std::uint64_t>(i))};
        per_mm_[i] = static_cast<float>(1 / cell);
        share_[i] = static_cast<float>(share);
    }
    double probability = std::exp(-kFlakesPerCell), sum = 0;
    for (int n = 0; n < kMostFlakesPerCell; ++n) {
        sum += probability;
        at_most_[n] = static_cast<float>(sum);
        probability *= kFlakesPerCell / (n + 1);
    }

    alpha_ = static_cast<float>(population.alpha);
    largest_radius_mm_ = static_cast<float>(0.5e-3 * sizes_.largest_um());
    smallest_radius_mm_ = static_cast<float>(0.5e-3 * sizes_.smallest_um());
    inverse_cover_ = static_cast<float>(1 / (density * sizes_.mean_area_um2() * 1e-6));
    typical_radius_ = lobe_.radius(static_cast<float>(population.diameter_um)) / alpha_;
    // A point tells its flakes apart, unless they lie in heaps.
    constexpr float kFewestCells = 6, kMostCells = 12;
    const float across = 1 + 2 * largest_radius_mm_ / static_cast<float>(levels_[0].cell_mm);
    full_cells_ = std::clamp(1.5f * across * across, kFewestCells, kMostCells);
}

double FlakeField::exact_side_mm() const {
    // As weigh() counts cells, a little less to be beyond the rounding.
    constexpr double kSafety = 0.999;
    const double side =
        levels_[0].cell_mm * (std::sqrt(double{full_cells_}) - 1) - 2 * double{largest_radius_mm_};
    return kSafety * std::max(0.0, side);
}

void FlakeField::look(const RestPatch& patch, FlakeView& view) const {
    const PatchOutline outline(patch, smallest_radius_mm_, largest_radius_mm_);
    const Weights weights = weigh(outline);
    view.count = 0;
    view.weight_sum = 0;
    view.background = 1 - weights.told_apart;
    view.widening = weights.widening;
    view.typical_radius = typical_radius_;
    if (weights.told_apart == 0) return;
    const Projections projections = projections_of(patch.normal);
    for (int i = 0; i < projections.count; ++i) {
        const FlakePlane plane(patch, outline, projections.list[i]);
        Found found;
        find(plane, weights, found);
        show(found, plane, outline, weights.widening, view);
    }
    // Up to a whole vector: flakes that answer to nothing.
    store_lanes(&view.lobe_radius[view.count], FloatLanes{});
}

// A level is told apart as long as it touches few cells.
FlakeField::Weights FlakeField::weigh(const PatchOutline& outline) const {
    /// Where a level has faded out, in terms of full_cells_.
    constexpr float kFaded = 2.3f;
    const FloatLanes cells = (1.0f + (outline.size_mm[0] + 2 * outline.reach_mm) * per_mm_) *
                             (1.0f + (outline.size_mm[1] + 2 * outline.reach_mm) * per_mm_);
    Weights weights;
    if (cells[0] <= full_cells_) {  // every level: the most common case
        weights.by_level = splat(1.0f);
        weights.told_apart = 1;
        return weights;
    }
    const FloatLanes t = min_lanes(
        max_lanes((kFaded - cells / full_cells_) / (kFaded - 1), FloatLanes{}), splat(1.0f));
    // Squared, as a level gives way to the next, of a sixteenth of its density, near the end.
    const FloatLanes w = t * t;
    const float first = lane_sum(w * share_), second = lane_sum(w * w * share_);
    if (second == 0) return weights;
    // The flakes told apart fluctuate stand_for^2 times as much as all flakes. With lobes wider by
    // as much they do not, but a lobe must stay narrower than the distribution of slopes: what is
    // left is made up for by background. A little is left always, for variance_correction().
    constexpr float kWidest = 0.35f, kMostToldApart = 0.95f;
    const float stand_for = std::sqrt(second) / first;
    weights.widening =
        std::clamp(kMostToldApart * stand_for, 1.0f, std::max(1.0f, kWidest / typical_radius_));
    weights.told_apart = std::min(weights.widening / stand_for, 1.0f);
    weights.by_level = w * (weights.told_apart / first);
    return weights;
}

}  // namespace nacre::sparkle
