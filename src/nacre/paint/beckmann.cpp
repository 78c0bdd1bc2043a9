#include "nacre/paint/beckmann.h"

#include "nacre/core/error.h"

namespace nacre::paint {

namespace detail {

// Mean over phi of |a - b cos phi|, a, b >= 0.
static double mean_absolute_projection(double a, double b) {
    if (a >= b) return a;
    return 2.0 * std::numbers::inv_pi * (a * std::asin(a / b) + std::sqrt(b * b - a * a));
}

}  // namespace detail

double flake_density(double tan2, double alpha) {
    const double a2 = alpha * alpha;
    const double sec2 = 1.0 + tan2;
    return sec2 * std::sqrt(sec2) * std::exp(-tan2 / a2) / (2.0 * std::numbers::pi * a2);
}

double projected_area(double mu, double alpha) {
    require_in_range(mu, 0.0, 1.0, "mu");
    require_in_range(alpha, 1e-4, 10.0, "alpha");
    static const Quadrature unit = gauss_legendre(40, 0.0, 1.0);
    const double s = std::sqrt(std::max(0.0, 1.0 - mu * mu));
    const double t_max = alpha * std::sqrt(40.0);
    const double t0 = std::min(s > 0 ? mu / s : INFINITY, t_max);
    const auto density = [&](double t) {
        return 2.0 * t / (alpha * alpha) * std::exp(-t * t / (alpha * alpha)) /
               std::sqrt(1.0 + t * t) * detail::mean_absolute_projection(mu, s * t);
    };
    double sum = 0;
    for (std::size_t k = 0; k < unit.nodes.size(); ++k) {
        sum += t0 * unit.weights[k] * density(t0 * unit.nodes[k]);
    }
    if (t0 < t_max) {
        const double v_max = std::sqrt(t_max * t_max - t0 * t0);
        for (std::size_t k = 0; k < unit.nodes.size(); ++k) {
            const double v = v_max * unit.nodes[k];
            const double t = std::sqrt(t0 * t0 + v * v);
            sum += v_max * unit.weights[k] * v / t * density(t);
        }
    }
    return sum;
}

}  // namespace nacre::paint
