#include "nacre/optics/thickness_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/dense.h"
#include "nacre/core/lru_cache.h"
#include "nacre/core/quadrature.h"

namespace nacre::optics {

namespace {

constexpr double kNormalCut = 3;  // standard deviations
constexpr int kMaxGaussNodes = 24;

/// Proportional to the density inside the range; x may be complex.
template <class Number>
Number density(Number x, double mean_nm, const ThicknessSpread& spread) {
    if (spread.law == ThicknessSpread::Law::uniform) return Number(1);
    const Number z = (x - mean_nm) / spread.standard_deviation_nm;
    return std::exp(-0.5 * z * z);
}

/// Gauss-Legendre with the density in the weights: for many nodes as accurate as the Gauss rule of
/// the law.
ThicknessRule product_rule(double mean_nm, const ThicknessSpread& spread, int n) {
    const auto [lo, hi] = thickness_range(mean_nm, spread);
    auto [nodes, weights] = gauss_legendre(n, lo, hi);
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        weights[i] *= density(nodes[i], mean_nm, spread);
        sum += weights[i];
    }
    for (double& weight : weights) weight /= sum;
    return {std::move(nodes), std::move(weights)};
}

/// A law on [-1, 1], where rules for it are made.
struct UnitLaw {
    ThicknessSpread::Law law;
    double lowest;  ///< of a normal law, in deviations from its mean: at -1; kNormalCut is at 1
    int n;          ///< nodes of its rule

    friend bool operator==(const UnitLaw&, const UnitLaw&) = default;

    double density(double x) const {
        const double deviations = std::lerp(lowest, kNormalCut, (x + 1) / 2);
        return optics::density(deviations, 0, {.standard_deviation_nm = 1, .law = law});
    }
};

/// The Gauss rule for the law itself.
Quadrature gauss_rule(const UnitLaw& law) {
    const int n = law.n;
    // The law as a sum of points. Twice n points and some for the density make the inner products of the n
    // polynomials exact to rounding.
    const Quadrature points = gauss_legendre(2 * n + 24, -1, 1);
    const auto count = static_cast<Eigen::Index>(points.nodes.size());
    Eigen::ArrayXd x(count), w(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto j = static_cast<std::size_t>(i);
        x[i] = points.nodes[j];
        w[i] = points.weights[j] * law.density(x[i]);
    }
    w /= w.sum();
    // Orthonormal polynomials by the three-term recurrence; its coefficients are the matrix.
    Eigen::VectorXd diagonal(n), beside = Eigen::VectorXd::Zero(std::max(1, n - 1));
    Eigen::ArrayXd previous = Eigen::ArrayXd::Zero(count), current = Eigen::ArrayXd::Ones(count);
    for (int k = 0; k < n; ++k) {
        diagonal[k] = (w * x * current * current).sum();
        if (k == n - 1) break;
        Eigen::ArrayXd next = (x - diagonal[k]) * current;
        if (k > 0) next -= beside[k - 1] * previous;
        beside[k] = std::sqrt((w * next * next).sum());
        previous = current;
        current = next / beside[k];
    }
    const SymmetricEigen eigen = tridiagonal_eigen(diagonal, beside.head(n - 1));
    Quadrature rule;
    for (int i = 0; i < n; ++i) {
        const double first = eigen.vectors(0, i);
        rule.nodes.push_back(eigen.values[i]);
        rule.weights.push_back(first * first);
    }
    return rule;
}

/// Few different counts, so that few rules are made.
int rounded_count(double n) {
    const int step = n < 24 ? 1 : n < 64 ? 4 : 8;
    const int rounded = step * static_cast<int>(std::ceil(std::min(n, 1e4) / step));
    return std::clamp(rounded, 1, kMaxNodesPerFilm);
}

}  // namespace

ThicknessRange thickness_range(double mean_nm, const ThicknessSpread& spread) {
    const double half =
        spread.standard_deviation_nm *
        (spread.law == ThicknessSpread::Law::uniform ? std::numbers::sqrt3 : kNormalCut);
    return {std::max(0.0, mean_nm - half), mean_nm + half};
}

double mean_thickness_nm(double mean_nm, const ThicknessSpread& spread) {
    const auto [lo, hi] = thickness_range(mean_nm, spread);
    if (lo > 0) return mean_nm;
    if (spread.law == ThicknessSpread::Law::uniform) return 0.5 * (lo + hi);
    // Of a Gaussian between two deviations from its mean: the difference of its density there over the
    // difference of its distribution.
    const double sigma = spread.standard_deviation_nm, a = mean_nm / sigma, b = kNormalCut;
    const double density = std::exp(-0.5 * a * a) - std::exp(-0.5 * b * b);
    const double inside =
        0.5 * (std::erf(a / std::numbers::sqrt2) + std::erf(b / std::numbers::sqrt2));
    return mean_nm + sigma * density / (std::sqrt(2 * std::numbers::pi) * inside);
}

double thickness_quantile(double mean_nm, const ThicknessSpread& spread, double fraction) {
    if (spread.standard_deviation_nm == 0) return mean_nm;
    auto [lo, hi] = thickness_range(mean_nm, spread);
    if (spread.law == ThicknessSpread::Law::uniform) return std::lerp(lo, hi, fraction);
    const auto below = [&](double thickness) {
        return 0.5 * std::erfc((mean_nm - thickness) /
                               (std::numbers::sqrt2 * spread.standard_deviation_nm));
    };
    const double wanted = std::lerp(below(lo), below(hi), fraction);
    for (int step = 0; step < 45; ++step) {
        const double middle = 0.5 * (lo + hi);
        (below(middle) < wanted ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
}

ThicknessRule thickness_rule(double mean_nm, const ThicknessSpread& spread, int n) {
    if (spread.standard_deviation_nm == 0) return {{mean_nm}, {1.0}};
    if (n > kMaxGaussNodes) return product_rule(mean_nm, spread, n);
    const auto [lo, hi] = thickness_range(mean_nm, spread);
    const double lowest = lo > 0 ? -kNormalCut : -mean_nm / spread.standard_deviation_nm;
    // A film that is moved has the law that it had, unless thickness 0 cuts it.
    static LruCache<UnitLaw, Quadrature> recent(256);
    const auto unit = recent.get({spread.law, lowest, n}, [&] {
        return gauss_rule({spread.law, lowest, n});
    });
    ThicknessRule rule;
    for (const double x : unit->nodes) {
        rule.thickness_nm.push_back((lo + hi) / 2 + (hi - lo) / 2 * x);
    }
    rule.weights = unit->weights;
    return rule;
}

int nodes_for_wave(double half_phase, double p, double target_error) {
    p = std::clamp(p, 1e-12, 1 - 1e-9);
    const double pole = -std::log(p) / std::max(half_phase, 1e-12);
    return rounded_count(-std::log(target_error) / (2 * std::asinh(pole)) + 1);
}

int nodes_for_decay(double lo_nm, double hi_nm, double decay_per_nm, double target_error) {
    const double half_nm = (hi_nm - lo_nm) / 2;
    const double pole = std::max((lo_nm + hi_nm) / 2 / half_nm, 1.05);
    return rounded_count(-std::log(target_error) / (2 * std::acosh(pole)) +
                         decay_per_nm * half_nm / 2 + 1);
}

ThicknessArc thickness_arc(double mean_nm, const ThicknessSpread& spread) {
    using Complex = std::complex<double>;
    const auto [lo, hi] = thickness_range(mean_nm, spread);
    // Found by trial over all phases and reflectances up to 1 - 1e-5: an error below 1e-6 needs 32
    // nodes for the tails of a normal law and 64 where the density ends in a step.
    const bool has_step = spread.law == ThicknessSpread::Law::uniform || lo == 0;
    const int count = has_step ? 64 : 32;
    constexpr double height = 0.5;  // of the arc, in halves of the range
    const Quadrature rule = gauss_legendre(count, -1, 1);
    ThicknessArc arc;
    Complex sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double s = rule.nodes[i];
        // t runs from -1 to 1 with zero derivative at its ends: a resonance there, which the arc
        // cannot avoid, falls among closely spaced nodes.
        const double t = s * (3 - s * s) / 2, speed = 1.5 * (1 - s * s);
        const Complex thickness = (lo + hi) / 2 + (hi - lo) / 2 * Complex(t, height * (1 - t * t));
        const Complex weight = rule.weights[i] * speed * Complex(1, -2 * height * t) *
                               density(thickness, mean_nm, spread);
        arc.thickness_nm.push_back(thickness);
        arc.weights.push_back(weight);
        sum += weight;
    }
    for (Complex& weight : arc.weights) weight /= sum;
    return arc;
}

}  // namespace nacre::optics
