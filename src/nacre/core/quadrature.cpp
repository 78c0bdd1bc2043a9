#include "nacre/core/quadrature.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>

#include "nacre/core/error.h"

namespace nacre {
namespace {

struct Legendre {
    double value, derivative;
};

// P_n and its derivative at |x| < 1 by the three-term recurrence [abramowitz-stegun-1964,
// eq. 22.7.10 and 22.8.5].
Legendre legendre(int n, double x) {
    double previous = 1, current = x;
    for (int k = 2; k <= n; ++k) {
        // Written as a correction to x * P_(k-1), which loses fewer digits than (2k-1)/k * x * P.
        const double next = x * current + (k - 1.0) / k * (x * current - previous);
        previous = current;
        current = next;
    }
    return {current, n * (previous - x * current) / ((1 - x) * (1 + x))};
}

double tricomi_estimate(int n, int i) {
    const double theta = std::numbers::pi * (4.0 * i + 3) / (4.0 * n + 2);
    return (1 - (n - 1.0) / (8.0 * n * n * n)) * std::cos(theta);
}

}  // namespace

Quadrature gauss_legendre(int n, double a, double b) {
    if (n < 1 || n > 100000) {
        throw DomainError(fmt::format("gauss_legendre: n = {} is outside [1, 100000]", n));
    }
    if (!(std::isfinite(a) && std::isfinite(b) && a < b)) {
        throw DomainError(
            fmt::format("gauss_legendre: [{}, {}] is not an interval of positive length", a, b));
    }
    Quadrature rule{std::vector<double>(n), std::vector<double>(n)};
    const double half = 0.5 * (b - a), centre = 0.5 * (a + b);
    // Zeros lie symmetrically about the centre: find the upper half, from the largest down.
    for (int i = 0; i < (n + 1) / 2; ++i) {
        double x = 2 * i + 1 == n ? 0.0 : tricomi_estimate(n, i);
        for (int step = 0; step < 8 && x != 0; ++step) {
            const auto [value, derivative] = legendre(n, x);
            const double change = value / derivative;
            x -= change;
            // Newton's error squares at each step: below 1e-9 it has reached rounding.
            if (std::abs(change) < 1e-9) break;
        }
        const double derivative = n == 1 ? 1.0 : legendre(n, x).derivative;
        const double weight = 2 / ((1 - x) * (1 + x) * derivative * derivative);
        rule.nodes[n - 1 - i] = centre + half * x;
        rule.nodes[i] = centre - half * x;
        rule.weights[i] = rule.weights[n - 1 - i] = half * weight;
    }
    return rule;
}

const Quadrature& unit_gauss_legendre(int count) {
    static std::mutex mutex;
    static std::vector<std::unique_ptr<const Quadrature>> rules;
    const std::scoped_lock lock(mutex);
    if (static_cast<int>(rules.size()) <= count) rules.resize(count + 1);
    if (!rules[count]) {
        rules[count] = std::make_unique<const Quadrature>(gauss_legendre(count, 0.0, 1.0));
    }
    return *rules[count];
}

}  // namespace nacre
