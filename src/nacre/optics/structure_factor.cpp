#include "nacre/optics/structure_factor.h"

#include <cmath>
#include <limits>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"

namespace nacre::optics {

double percus_yevick(double q_diameter, double volume_fraction) {
    require_in_range(q_diameter, 0, std::numeric_limits<double>::max(), "q_diameter");
    require_in_range(volume_fraction, 0, 0.5, "volume_fraction");
    const double v = volume_fraction, x = q_diameter;
    const double thin = std::pow(1 - v, 4);
    const double alpha = (1 + 2 * v) * (1 + 2 * v) / thin;
    const double beta = -6 * v * (1 + v / 2) * (1 + v / 2) / thin;
    const double gamma = v * alpha / 2;
    // The direct correlation function is -(alpha + beta s + gamma s^3) within the diameter, s = r/d;
    // its transform times the density is -24 v g.
    double g = 0;
    if (x < 2) {
        // The closed form would lose its digits.
        const Quadrature& rule = unit_gauss_legendre(12);
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double s = rule.nodes[i], t = x * s;
            const double sinc = t > 1e-4 ? std::sin(t) / t : 1 - t * t / 6;
            g += rule.weights[i] * s * s * (alpha + s * (beta + gamma * s * s)) * sinc;
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
