#include "nacre/solver/directions.h"

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"

namespace nacre::solver {

double inside_cosine(double ior, double theta_e) {
    const double s = std::sin(theta_e) / ior;
    // At ior = 1 the cosine itself, without the cancellation of 1 - sin^2 near grazing.
    return ior == 1.0 ? std::cos(theta_e) : std::sqrt((1.0 - s) * (1.0 + s));
}

Directions make_directions(double ior, int exit_count, int inner_count) {
    require_in_range(ior, 1.0, 3.0, "refractive index of the binder");
    Directions d;
    d.ior = ior;
    d.exit_count = exit_count;
    const Quadrature exit = gauss_legendre(exit_count, 0.0, std::numbers::pi / 2);
    for (int i = 0; i < exit_count; ++i) {
        const double theta = exit.nodes[i], mu = inside_cosine(ior, theta);
        d.exit_angle.push_back(theta);
        d.mu.push_back(mu);
        d.weight.push_back(exit.weights[i] * std::sin(theta) * std::cos(theta) / (ior * ior * mu));
    }
    if (ior > 1.0) {
        const double critical = std::asin(1.0 / ior);
        const double width = (std::numbers::pi / 2 - critical) / (std::numbers::pi / 2 - 0.7297);
        const int blocks = std::max(1, static_cast<int>(std::ceil(inner_count * width / 4 - 1e-3)));
        const Quadrature inner = gauss_legendre(4 * blocks, critical, std::numbers::pi / 2);
        for (int i = 0; i < 4 * blocks; ++i) {
            d.mu.push_back(std::cos(inner.nodes[i]));
            d.weight.push_back(inner.weights[i] * std::sin(inner.nodes[i]));
        }
    }
    return d;
}

ExitInterpolation::ExitInterpolation(const std::vector<double>& exit_angle) : node_(exit_angle) {
    const std::size_t n = node_.size();
    // Products of differences under- or overflow for many nodes; the common scale 4/(pi/2), the
    // inverse capacity of the interval, keeps them near one.
    const double scale = 8.0 / std::numbers::pi;
    barycentric_.assign(n, 1.0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            if (j != i) barycentric_[i] /= scale * (node_[i] - node_[j]);
        }
    }
}

void ExitInterpolation::weights_at(double theta_e, double* weights) const {
    double sum = 0;
    for (std::size_t i = 0; i < node_.size(); ++i) {
        const double difference = theta_e - node_[i];
        if (difference == 0.0) {
            for (std::size_t j = 0; j < node_.size(); ++j) weights[j] = j == i ? 1.0 : 0.0;
            return;
        }
        weights[i] = barycentric_[i] / difference;
        sum += weights[i];
    }
    for (std::size_t i = 0; i < node_.size(); ++i) weights[i] /= sum;
}

}  // namespace nacre::solver
