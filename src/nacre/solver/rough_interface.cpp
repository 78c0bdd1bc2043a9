#include "nacre/solver/rough_interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/lru_cache.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/directions.h"
#include "nacre/solver/rough_interface_operators.h"

namespace nacre::solver {

namespace {

// Nodes of m in the polar angle: it changes within alpha of the horizon, where they are dense.
constexpr int kNodes = 64;
// Of 1/(alpha tan theta), up to which light may be masked: e^-36 of it beyond.
constexpr double kFarthest = 6;

}  // namespace

double smith_beckmann_over_cosine(double cosine, double sine, double alpha) {
    // G1 = 2/(1 + erf a + e^(-a^2)/(a sqrt(pi))), a = 1/(alpha tan theta).
    const double across = alpha * sine;
    if (cosine > kFarthest * across) return 1 / cosine;
    const double a = cosine / across;
    return 2 / (cosine * (1 + std::erf(a)) + across * std::exp(-a * a) * std::numbers::inv_sqrtpi);
}

namespace {

// 1/sqrt(pi) - a e^(a^2) erfc(a) for a in [0, kFarthest], by powers of
// s = 1.5 (a - 3)/(a + 3) + 0.5 in [-1, 1]: the Chebyshev interpolant of 64 nodes, in 60 digits (mpmath
// 1.4.1), cut after 18 terms; to 6e-16 of 2 a e^(a^2) plus it.
constexpr std::array<double, 18> kMaskingTail = {
    0.08181145886628007,     -0.17133983967482336,    0.1643991422811365,    -0.0975184463872506,
    0.03871865265859144,     -0.009668838064391174,   0.000994620450849111,  0.00020137595187659111,
    -6.732761312755701e-05,  -4.13417304113765e-06,   3.514081913853089e-06, 1.979519464299191e-07,
    -1.9006764550826748e-07, -2.1031281392014073e-08, 9.856210189393986e-09, 2.1704771134176864e-09,
    -3.680669172551128e-10,  -1.4512756534527685e-10};

}  // namespace

DoubleLanes smith_beckmann_over_cosine(const DoubleLanes& cosine, const DoubleLanes& sine,
                                       double alpha) {
    // As above, with 1 + erf a = 2 - erfc a.
    const DoubleLanes across = max_lanes(alpha * sine, splat(1e-300));
    if (lane_max(kFarthest * across - cosine) < 0) return 1 / cosine;
    const DoubleLanes near = min_lanes(cosine, kFarthest * across);
    const DoubleLanes a = near / across;
    const DoubleLanes s = 1.5 * (near - 3 * across) / (near + 3 * across) + 0.5;
    return 2 / (2 * cosine + across * exp_lanes(-a * a) * detail::horner(s, kMaskingTail));
}

RoughInterface::RoughInterface(double ior, double alpha) : ior_(ior), alpha_(alpha) {
    if (!(ior > 1.0 && ior <= 3.0)) {
        throw DomainError(fmt::format("refractive index = {} is not in (1, 3]", ior));
    }
    if (!(alpha > 0.0 && alpha <= 1.0)) {
        throw DomainError(fmt::format("interface roughness = {} is not in (0, 1]", alpha));
    }
    const Quadrature outside = gauss_legendre(kNodes, 0.0, kHorizon);
    // Of m inside only its integral is wanted, to 1e-7 of it or better: below the critical angle, in
    // the angle outside, and beyond it.
    const int inner_nodes = std::min(kNodes, static_cast<int>(12 + 3.5 / std::sqrt(alpha)));
    const Quadrature refracted = gauss_legendre(inner_nodes, 0.0, kHorizon);
    const Quadrature beyond = gauss_legendre(inner_nodes, std::asin(1 / ior), kHorizon);
    const auto etendue = [](const Quadrature& rule, int i) {  // over 2 pi, n^2 left out inside
        return rule.weights[i] * std::sin(rule.nodes[i]) * std::cos(rule.nodes[i]);
    };
    const auto masked_inside = [&](double theta) {
        double leaves = 0;
        for_each_facet_exit(theta, alpha, ior, 1.0, {},
                            [&](const FacetExits& exits) { leaves += lane_sum(exits.fraction); });
        return std::max(0.0, 1 - leaves);
    };
    reflected_.resize(kNodes);
    masked_.resize(kNodes);
    std::vector<double> inner(inner_nodes);  // m inside times etendue / 2 pi
    parallel_for(0, kNodes + inner_nodes, [&](int i) {
        if (i < inner_nodes) {
            inner[i] = etendue(refracted, i) *
                           masked_inside(std::asin(std::sin(refracted.nodes[i]) / ior)) +
                       ior * ior * etendue(beyond, i) * masked_inside(beyond.nodes[i]);
            return;
        }
        i -= inner_nodes;
        double through = 0;
        for_each_facet_exit(outside.nodes[i], alpha, 1.0, ior, {}, [&](const FacetExits& exits) {
            (exits.through ? through : reflected_[i]) += lane_sum(exits.fraction);
        });
        masked_[i] = std::max(0.0, 1 - reflected_[i] - through);
    });
    double outer = 0;
    for (int i = 0; i < kNodes; ++i) outer += etendue(outside, i) * masked_[i];
    masked_outside_ = 2 * std::numbers::pi * outer;
    const double both =
        2 * std::numbers::pi * (outer + std::accumulate(inner.begin(), inner.end(), 0.0));
    diffuse_scale_ = both > 0 ? 1 / both : 0;
}

double RoughInterface::facet_brdf(double theta_i, double theta_o, double phi) const {
    const double c_i = std::cos(theta_i), s_i = std::sin(theta_i);
    const double c_o = std::cos(theta_o), s_o = std::sin(theta_o);
    const double cosine_sum = c_i + c_o;
    // tan^2 of the facet's tilt without cancellation at the mirror direction, as in medium.cpp.
    const double half = std::sin(0.5 * (phi - std::numbers::pi));
    const double across2 = (s_i - s_o) * (s_i - s_o) + 4 * s_i * s_o * half * half;
    const double tan2 = across2 / (cosine_sum * cosine_sum);
    const double cosine = std::min(1.0, 0.5 * std::sqrt(across2 + cosine_sum * cosine_sum));
    const double density = std::exp(-tan2 / (alpha_ * alpha_)) * (1 + tan2) * (1 + tan2) /
                           (std::numbers::pi * alpha_ * alpha_);
    return 0.25 * optics::dielectric_reflectance(1.0, ior_, cosine) * density *
           smith_beckmann_over_cosine(c_i, s_i, alpha_) *
           smith_beckmann_over_cosine(c_o, s_o, alpha_);
}

namespace {

double interpolate(const ExitInterpolation& interpolation, const std::vector<double>& values,
                   double theta) {
    std::array<double, kNodes> weight;
    interpolation.weights_at(theta, weight.data());
    double sum = 0;
    for (int i = 0; i < kNodes; ++i) sum += weight[i] * values[i];
    return sum;
}

const ExitInterpolation& on_nodes() {
    static const ExitInterpolation interpolation(gauss_legendre(kNodes, 0.0, kHorizon).nodes);
    return interpolation;
}

}  // namespace

double RoughInterface::masked(double theta) const {
    return std::clamp(interpolate(on_nodes(), masked_, theta), 0.0, 1.0);
}

double RoughInterface::albedo(double theta_i) const {
    return interpolate(on_nodes(), reflected_, theta_i) +
           diffuse_scale_ * masked_outside_ * masked(theta_i);
}

double RoughInterface::brdf(double theta_i, double theta_o, double phi) const {
    return facet_brdf(theta_i, theta_o, phi) + diffuse_scale_ * masked(theta_i) * masked(theta_o);
}

std::shared_ptr<const RoughInterface> rough_interface(double ior, double alpha) {
    static LruCache<std::pair<double, double>, RoughInterface> interfaces(256);
    return interfaces.get({ior, alpha}, [&] { return RoughInterface(ior, alpha); });
}

double rough_interface_brdf(double ior, double alpha, double theta_i, double theta_o, double phi) {
    if (ior == 1.0) return 0;
    return rough_interface(ior, alpha)->brdf(theta_i, theta_o, phi);
}

void reflect_under_rough_interface(const RoughInterfaceOperators::Order& interface, DoubleLanes* y,
                                   DoubleLanes* u, ImpedanceWorkspace& work) {
    const int n = interface.n, exits = interface.exits;
    DoubleLanes* solved = work.b.data();
    for (int i = 0; i < n * n; ++i) y[i] += splat(interface.impedance[i]);
    for (int i = 0; i < n * exits; ++i) solved[i] = splat(interface.through[i]);
    for (int i = 0; i < exits * exits; ++i) u[i] = splat(-interface.direct[i]);
    cholesky(y, n);
    forward_solve(y, solved, solved, n, exits);
    add_gram(1.0, u, 2.0, solved, n, exits);
}

void reflect_once_under_rough_interface(const RoughInterfaceOperators::Order& interface,
                                        const DoubleLanes* s, DoubleLanes* u,
                                        ImpedanceWorkspace& work) {
    const int n = interface.n, exits = interface.exits;
    DoubleLanes* half = work.b.data();  // S T^T, n x exits
    multiply(s, interface.enter.data(), half, n, exits);
    multiply_transposed(interface.enter.data(), half, u, n, exits);
}

}  // namespace nacre::solver
