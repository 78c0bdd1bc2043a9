#pragma once

#include <array>
#include <vector>

#include "nacre/bsdf/smooth_table.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/progress.h"
#include "nacre/solver/solved_paint.h"

namespace nacre::bsdf {

// A tinted coat whose thickness varies.                              [docs/coat-thickness.md]
//
// Where the coat is z standard deviations s thicker than on the mean, light that crosses it once in and
// once out is weaker by C(z) = exp(-z s a (1/mu_i + 1/mu_o)), a the absorption coefficient. Light that
// the interface sends back crosses it more often. What there is of both, the table of a paint, is
//
//     T(z) = T(0) C(z) q(z),
//
// q a factor that depends on the thickness far less than C does. Were all layers below the coat one
// diffuse reflectance R, and the light that is sent back a fraction r of it, then 1/q would go as
// 1 - r R exp(-2 a d): 1/q is taken as a parabola in z, through the values of the paint solved anew at
// kCoatNode deviations below and above the mean.

/// In standard deviations. The error is about the same at 1 and 2 deviations.
inline constexpr double kCoatNode = 2.5;
static_assert(kCoatNode <= paint::limits::kMaxCoatDeviation);

/// The tables at the two other thicknesses.
struct CoatSpread {
    /// @param hot_spot  tables under a rough clearcoat hold the hot spot (rough_hot_spot.h)
    /// @throws as solver::solve_with_coat() and with_rough_hot_spot()
    CoatSpread(const solver::SolvedPaint& paint, bool hot_spot, const Progress& progress = {});

    double spread;  ///< standard deviation over the mean
    std::array<solver::SolvedPaint, 2> paint;  ///< thinner, thicker
    std::array<SmoothTable, 2> table;
};

/// The same at eight wavelengths.
class BoundCoatSpread {
 public:
    BoundCoatSpread() = default;  ///< an even coat
    BoundCoatSpread(const CoatSpread& spread, const std::array<WavelengthPosition, kLanes>& where);

    float spread() const { return spread_; }
    const std::vector<FloatLanes>& thinner() const { return tables_[0]; }
    const std::vector<FloatLanes>& thicker() const { return tables_[1]; }

 private:
    float spread_ = 0;
    std::array<std::vector<FloatLanes>, 2> tables_;
};

/// q(z).
/// @param table, thinner, thicker  T(0), T(-kCoatNode), T(kCoatNode)
/// @param depth  s a (1/mu_i + 1/mu_o)
FloatLanes relative_remainder(const FloatLanes& table, const FloatLanes& thinner,
                              const FloatLanes& thicker, const FloatLanes& depth, float deviation);

}  // namespace nacre::bsdf
