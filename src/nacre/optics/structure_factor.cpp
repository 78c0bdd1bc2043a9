#include "nacre/optics/structure_factor.h"

#include <cmath>
#include <limits>

#include "nacre/core/error.h"

namespace nacre::optics {

double percus_yevick(double q_diameter, double volume_fraction) {
    require_in_range(q_diameter, 0, std::numeric_limits<double>::max(), "q_diameter");
    require_in_range(volume_fraction, 0, 0.5, "volume_fraction");
    const double v = volume_fraction, x = q_diameter;
    const double thin = (1 - v) * (1 - v) * (1 - v) * (1 - v);
    const double alpha = (1 + 2 * v) * (1 + 2 * v) / thin;
    const double beta = -6 * v * (1 + v / 2) * (1 + v / 2) / thin;
    const double gamma = v * alpha / 2;
    // The direct correlation function is -(alpha + beta s + gamma s^3) within the diameter, s = r/d;
    // its transform times the density is -24 v g.
    double g = 0;
    if (x < 2) {
        // The closed form would lose its digits: sin(x s)/(x s) by its series, whose next term is below
        // 1e-17.
        constexpr int kTerms = 13;
        double term = 1;  // (-x^2)^j / (2 j + 1)!
        for (int j = 0; j < kTerms; ++j) {
            const double m = 2 * j;
            g += term * (alpha / (m + 3) + beta / (m + 4) + gamma / (m + 6));
            term *= -x * x / ((m + 2) * (m + 3));
        }
    } else {
        const double x2 = x * x, sine = std::sin(x), cosine = std::cos(x);
        g = alpha * (sine - x * cosine) / (x2 * x) +
            beta * (2 * x * sine + (2 - x2) * cosine - 2) / (x2 * x2) +
            gamma * (-x2 * x2 * cosine + 4 * ((3 * x2 - 6) * cosine + (x2 - 6) * x * sine + 6)) /
                (x2 * x2 * x2);
    }
    return 1 / (1 + 24 * v * g);
}

}  // namespace nacre::optics
