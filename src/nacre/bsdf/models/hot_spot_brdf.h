#pragma once

#include <optional>
#include <vector>

#include "nacre/bsdf/models/hot_spot.h"
#include "nacre/core/part.h"
#include "nacre/solver/solved_paint.h"

namespace nacre::bsdf {

/// The mean of the model nacre by values, from the solved paint itself: SolvedPaint::brdf() with the
/// hot spot, where the model that a renderer gets has a table.
class HotSpotBrdf {
 public:
    /// @param paint  outlives this
    /// @throws Error as compensation_factors(), with_rough_hot_spot()
    explicit HotSpotBrdf(const solver::SolvedPaint& paint);

    /// As SolvedPaint::brdf(). What the ground alone has scattered is part of the multiple.
    std::vector<double> operator()(double theta_i, double theta_o, double phi,
                                   Part part = Part::total) const;

 private:
    const solver::SolvedPaint& paint_;
    std::optional<solver::SolvedPaint> rough_;  // has all of it
    float inverse_mean_ior_;
    std::vector<HotSpot> blocks_;  // eight wavelengths each
};

}  // namespace nacre::bsdf
