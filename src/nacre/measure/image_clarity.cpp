#include "nacre/measure/image_clarity.h"

#include <cmath>
#include <numbers>

namespace nacre::measure {

double grille_contrast(double slope, double period_deg) {
    using std::numbers::pi;
    const double blur = 2 * slope / (period_deg * pi / 180);  // in periods
    if (blur == 0) return 1;
    // Two series for the same, each where it converges fast.
    constexpr int kTerms = 8;
    double contrast = 0;
    if (blur > 0.3) {
        for (int k = 0; k < kTerms; ++k) {
            const double order = 2 * k + 1, turn = 2 * pi * order * blur;
            contrast += (k % 2 ? -1 : 1) * 4 / (pi * order) * std::exp(-0.5 * turn * turn);
        }
    } else {
        // The chance that light at the middle of a bar comes from a bright one, less that it does not.
        for (int bar = -kTerms; bar <= kTerms; ++bar) {
            const auto below = [&](double edge) {
                return 0.5 * std::erfc(-edge / (2 * blur * std::numbers::sqrt2));
            };
            contrast += (bar % 2 ? -1 : 1) * (below(bar + 0.5) - below(bar - 0.5));
        }
    }
    return contrast;
}

double half_contrast_period_deg(double slope) {
    using std::numbers::pi;
    return 4 * pi * slope / std::sqrt(2 * std::log(8 / pi)) * 180 / pi;
}

}  // namespace nacre::measure
