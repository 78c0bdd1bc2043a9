#include "nacre/core/quadrature.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>

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

// On [-1, 1], from the largest node down to the centre; the others are their mirror images.
Quadrature upper_half(int n) {
    Quadrature half;
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
        half.nodes.push_back(x);
        half.weights.push_back(2 / ((1 - x) * (1 + x) * derivative * derivative));
    }
    return half;
}

// Finding the zeros takes time in n^2: of gauss_legendre(), rules of up to so many nodes are kept,
// four megabytes in all. Those that are handed out by reference are kept however long; callers ask
// for few.
constexpr int kMaxKeptNodes = 1024;

// One rule for each number of nodes, made when it is first asked for and kept. Small ones, which
// inner loops ask for, are found without a lock.
class RuleCache {
 public:
    template <class Make>
    const Quadrature& at(int n, const Make& make) {
        const bool small = n <= kMaxKeptNodes;
        if (small) {
            if (const Quadrature* rule = small_[n].load(std::memory_order_acquire)) return *rule;
        }
        {
            const std::scoped_lock lock(mutex_);
            if (static_cast<int>(rules_.size()) <= n) rules_.resize(n + 1);
            if (rules_[n]) return *rules_[n];
        }
        auto made = std::make_unique<const Quadrature>(make(n));  // others need not wait meanwhile
        const std::scoped_lock lock(mutex_);
        if (!rules_[n]) rules_[n] = std::move(made);
        if (small) small_[n].store(rules_[n].get(), std::memory_order_release);
        return *rules_[n];
    }

 private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<const Quadrature>> rules_;
    std::array<std::atomic<const Quadrature*>, kMaxKeptNodes + 1> small_{};
};

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
    static RuleCache kept;
    Quadrature found;
    if (n > kMaxKeptNodes) found = upper_half(n);
    const Quadrature& upper = n > kMaxKeptNodes ? found : kept.at(n, upper_half);
    for (int i = 0; i < (n + 1) / 2; ++i) {
        rule.nodes[n - 1 - i] = centre + half * upper.nodes[i];
        rule.nodes[i] = centre - half * upper.nodes[i];
        rule.weights[i] = rule.weights[n - 1 - i] = half * upper.weights[i];
    }
    return rule;
}

const Quadrature& unit_gauss_legendre(int count) {
    static RuleCache rules;
    return rules.at(count, [](int n) { return gauss_legendre(n, 0.0, 1.0); });
}

const Quadrature& half_turn_cosines(int count) {
    static RuleCache rules;
    return rules.at(count, [](int n) {
        Quadrature rule = unit_gauss_legendre(n);
        for (double& x : rule.nodes) x = std::cos(std::numbers::pi * x);
        return rule;
    });
}

}  // namespace nacre
