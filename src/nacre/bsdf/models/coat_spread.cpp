#include "nacre/bsdf/models/coat_spread.h"

#include <algorithm>
#include <cmath>

#include "nacre/bsdf/models/paint_table.h"
#include "nacre/bsdf/models/rough_hot_spot.h"
#include "nacre/core/lane_math.h"
#include "nacre/solver/solver.h"

namespace nacre::bsdf {
namespace {

/// Bounds of q: where a coat is nearly opaque a table holds little but its own error.
constexpr float kMaxRatio = 8;
/// D over the depth of C, at most: light that the interface sends back crosses the coat twice more, at
/// angles that are flatter than those at which light leaves.
constexpr float kMaxCrossings = 2;
/// Below, e^x is taken for a straight line.
constexpr float kFlat = 1e-2f;
constexpr float kDark = 1e-30f;

solver::SolvedPaint at_deviation(const solver::SolvedPaint& paint, double deviation, bool hot_spot,
                                 SharedProgress& work) {
    const double factor = 1 + deviation * paint.recipe.coat_spread();
    const Progress asking = [&](double) { return work.keep_going(); };
    solver::SolvedPaint solved = solver::solve_with_coat(paint, factor, asking);
    return hot_spot ? with_rough_hot_spot(solved) : solved;
}

}  // namespace

CoatSpread::CoatSpread(const solver::SolvedPaint& mean, bool hot_spot, SharedProgress& work)
    : spread(mean.recipe.coat_spread()),
      paint{at_deviation(mean, -kCoatNode, hot_spot, work),
            at_deviation(mean, kCoatNode, hot_spot, work)},
      table{smooth_table(paint[0]), smooth_table(paint[1])} {}

BoundCoatSpread::BoundCoatSpread(const CoatSpread& spread,
                                 const std::array<WavelengthPosition, kLanes>& where)
    : spread_(static_cast<float>(spread.spread)) {
    for (std::size_t k = 0; k < tables_.size(); ++k) {
        tables_[k] = bind_table(spread.table[k], spread.paint[k], where);
    }
}

FloatLanes relative_multiple_scattering(const CoatNodes& table, const FloatLanes& depth,
                                        float deviation) {
    constexpr auto kNode = static_cast<float>(kCoatNode);
    const auto bounded = [](const FloatLanes& x) {
        return min_lanes(max_lanes(x, splat(1 / kMaxRatio)), splat(kMaxRatio));
    };
    // 1/q at a node, whose C is e^exponent.
    const auto inverse = [&](const FloatLanes& there, const FloatLanes& exponent) {
        return bounded(table.mean * exp_lanes(exponent) / max_lanes(there, splat(kDark)));
    };
    const FloatLanes thinner = inverse(table.thinner, kNode * depth);
    const FloatLanes thicker = inverse(table.thicker, -kNode * depth);
    // B (e^(-D n) - 1) and B (e^(D n) - 1): minus their ratio is e^(D n).
    const FloatLanes rise = max_lanes(thicker - 1.0f, splat(kDark));
    const FloatLanes steepest = exp_lanes(max_lanes(kMaxCrossings * kNode * depth, splat(kFlat)));
    const FloatLanes steepness =
        log_lanes(min_lanes(max_lanes((1.0f - thinner) / rise, splat(1 + kFlat)), steepest));
    // Of the way from the mean to the node on this side.
    const bool thin = deviation < 0;
    const float part = std::abs(deviation) / kNode;
    const FloatLanes exponent = thin ? steepness : -steepness;
    const FloatLanes way = (exp_lanes(part * exponent) - 1.0f) / (exp_lanes(exponent) - 1.0f);
    const FloatLanes at_node = thin ? thinner : thicker;
    return 1.0f / max_lanes(1.0f + (at_node - 1.0f) * min_lanes(way, splat(std::max(part, 1.0f))),
                            0.5f * at_node);
}

}  // namespace nacre::bsdf
