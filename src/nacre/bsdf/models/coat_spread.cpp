#include "nacre/bsdf/models/coat_spread.h"

#include "nacre/bsdf/models/paint_table.h"
#include "nacre/bsdf/models/rough_hot_spot.h"
#include "nacre/core/lane_math.h"
#include "nacre/solver/solver.h"

namespace nacre::bsdf {
namespace {

/// Bounds of q: where a coat is nearly opaque a table holds little but its own error.
constexpr float kMostRemainder = 8;

solver::SolvedPaint at_deviation(const solver::SolvedPaint& paint, double deviation, bool hot_spot,
                                 const Progress& progress) {
    const double factor = 1 + deviation * paint.recipe.coat_spread();
    solver::SolvedPaint solved = solver::solve_with_coat(paint, factor, progress);
    return hot_spot ? with_rough_hot_spot(solved) : solved;
}

}  // namespace

CoatSpread::CoatSpread(const solver::SolvedPaint& mean, bool hot_spot, const Progress& progress)
    : spread(mean.recipe.coat_spread()),
      paint{at_deviation(mean, -kCoatNode, hot_spot, progress),
            at_deviation(mean, kCoatNode, hot_spot, progress)},
      table{smooth_table(paint[0]), smooth_table(paint[1])} {}

BoundCoatSpread::BoundCoatSpread(const CoatSpread& spread,
                                 const std::array<WavelengthPosition, kLanes>& where)
    : spread_(static_cast<float>(spread.spread)) {
    for (std::size_t k = 0; k < tables_.size(); ++k) {
        tables_[k] = bind_table(spread.table[k], spread.paint[k], where);
    }
}

FloatLanes relative_remainder(const FloatLanes& table, const FloatLanes& thinner,
                              const FloatLanes& thicker, const FloatLanes& depth, float deviation) {
    constexpr auto kNode = static_cast<float>(kCoatNode);
    const auto bounded = [](const FloatLanes& x) {
        return min_lanes(max_lanes(x, splat(1 / kMostRemainder)), splat(kMostRemainder));
    };
    // 1/q at a node, whose C is e^exponent.
    const auto inverse = [&](const FloatLanes& there, const FloatLanes& exponent) {
        return bounded(table * exp_lanes(exponent) / max_lanes(there, splat(1e-30f)));
    };
    const FloatLanes below = inverse(thinner, kNode * depth);
    const FloatLanes above = inverse(thicker, -kNode * depth);
    const float t = deviation / kNode;
    return 1.0f / bounded(1.0f + (0.5f * t) * (above - below) +
                          (t * t) * (0.5f * (above + below) - 1.0f));
}

}  // namespace nacre::bsdf
