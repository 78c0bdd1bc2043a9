#pragma once

#include <array>

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
// diffuse reflectance R, and r the fraction of its light that the interface sends back, 1/q would go as
// 1 - r R exp(-D z): a constant and an exponential, laid through the values of the paint solved anew at
// kCoatNode deviations below and above the mean. Where the three hold no such curve (a table has an error
// of its own) each side takes the steepest or flattest that there is. Beyond the nodes 1/q goes on at most
// as a straight line, and not below half of its value there. The law of q is a choice of this project, after
// what a surface does to diffuse light [saunderson-1942]; its errors stand on the page named above.

/// In standard deviations: 1.2 % of a panel is beyond.
inline constexpr double kCoatNode = 2.5;
static_assert(kCoatNode <= paint::limits::kMaxCoatDeviation);

/// The tables at the two other thicknesses.
struct CoatSpread {
    /// @param hot_spot  tables under a rough clearcoat hold the hot spot (rough_hot_spot.h)
    /// @param work      asked whether to go on
    /// @throws as solver::solve_with_coat() and with_rough_hot_spot()
    CoatSpread(const solver::SolvedPaint& paint, bool hot_spot, SharedProgress& work);

    double spread;                             ///< standard deviation over the mean
    std::array<solver::SolvedPaint, 2> paint;  ///< thinner, thicker
    std::array<SmoothTable, 2> table;
};

/// The same at eight wavelengths.
class BoundCoatSpread {
 public:
    BoundCoatSpread() = default;  ///< an even coat
    BoundCoatSpread(const CoatSpread& spread, const std::array<WavelengthPosition, kLanes>& where);

    float spread() const { return spread_; }
    const BoundSmoothTable& thinner() const { return tables_[0]; }
    const BoundSmoothTable& thicker() const { return tables_[1]; }

 private:
    float spread_ = 0;
    std::array<BoundSmoothTable, 2> tables_;
};

/// T at the mean thickness and at the nodes.
struct CoatNodes {
    FloatLanes mean{}, thinner{}, thicker{};
};

/// q(z).
/// @param depth  s a (1/mu_i + 1/mu_o)
FloatLanes relative_multiple_scattering(const CoatNodes& table, const FloatLanes& depth,
                                        float deviation);

}  // namespace nacre::bsdf
