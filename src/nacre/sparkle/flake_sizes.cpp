#include "nacre/sparkle/flake_sizes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"

namespace nacre::sparkle {
namespace {

double normal_below(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

// The x between lo and hi below which the fraction `p` of a standard normal variable lies.
double normal_quantile(double p, double lo, double hi) {
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (lo + hi);
        (normal_below(middle) < p ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
}

}  // namespace

FlakeSizes::FlakeSizes(double mean_um, double spread_um) {
    require_in_range(mean_um, 1e-3, 1e6, "diameter_um of the flakes");
    require_in_range(spread_um, 0, mean_um, "diameter_spread_um of the flakes");
    constexpr double kCut = 3, kMin = 0.25;
    const double lo = spread_um > 0 ? std::max(-kCut, (kMin - 1) * mean_um / spread_um) : 0;
    const double below = normal_below(lo), inside = normal_below(kCut) - below;
    double squares = 0;
    for (int i = 0; i < kSizes; ++i) {
        const double p = below + inside * (i + 0.5) / kSizes;
        const double x = spread_um > 0 ? normal_quantile(p, lo, kCut) : 0;
        diameters_um_[i] = static_cast<float>(mean_um + spread_um * x);
        squares += double{diameters_um_[i]} * diameters_um_[i];
    }
    mean_area_um2_ = std::numbers::pi / 4 * squares / kSizes;
}

}  // namespace nacre::sparkle
