#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/quadrature.h"

// The Beckmann distribution of flake normals: Gaussian slopes, two-sided flakes.
//
// D(m) is even and its integral over the whole sphere is 1. It is the microfacet Beckmann
// distribution D_B times |cos m| / 2: a microfacet surface counts facets per projected area, a
// flake medium counts them per flake area.                      [ergun-2016; jakob-2010, sec. 5]

namespace nacre::paint {

/// D as a function of tan^2 of the angle between flake normal and surface normal, in 1/sr.
/// @param alpha  roughness, sqrt(2) times the standard deviation of a slope component; > 0
double flake_density(double tan2, double alpha);

/// s(mu) = Int |w.m| D(m) dm: the projected area of the flakes, per flake area, seen under the
/// cosine mu. s(1) = sqrt(pi)/alpha erfcx(1/alpha); s ~ mu s(1) for mu >> alpha.
/// Relative error below 1e-9 for alpha in [0.005, 2], mu in [0, 1].
double projected_area(double mu, double alpha);

/// Nodes for integrals over flake normals m ~ D: sum of weight f(cosine) approximates
/// Int f(|w.m|) |w.m| D(m) dm.
/// Calls visit(cosine, weight) for every node; weights are positive and sum to s(mu) within 1e-5 of
/// it (kNormalQuadratureError in beckmann_test.cpp).
/// @param nodes  on either side of where flakes begin to be seen edge on, in slope and in azimuth:
///               kNormalNodes where f is smooth, else normal_nodes()
template <class Visit>
void for_each_normal(double mu, double alpha, int nodes, Visit&& visit);

inline constexpr int kNormalNodes = 16;

/// Nodes for an f that Chebyshev interpolation resolves with so many cosines on [0, 1] (a film's
/// FlakeTable): fringes of thick films cost as many as the tilts of flakes spread them over. Tables
/// of more than 120 cosines hold fringes that are finer but weak. The error is below 1e-4 of s(mu)
/// for films of silica up to 400 nm on metal, 1e-3 up to 900 nm, where 16 nodes err by up to 4e-2.
constexpr int normal_nodes(double alpha, int cosine_count) {
    return kNormalNodes + 8 * static_cast<int>(alpha * std::min(cosine_count, 120) / 8 + 0.5);
}

namespace detail {

// Radial nodes for the slope t = tan theta_m >= 0, whose density is 2 t/alpha^2 exp(-t^2/alpha^2).
// The integrand has a kink of order 3/2 where flakes begin to be seen edge on, t = mu/s: the
// interval is split there and the outer part uses t^2 = t0^2 + v^2, in which it is smooth.
inline constexpr double kTail = 26.0;  // exp(-26) of the normals are left out

}  // namespace detail

template <class Visit>
void for_each_normal(double mu, double alpha, int nodes, Visit&& visit) {
    const double s = std::sqrt(std::max(0.0, 1.0 - mu * mu));
    const double t_edge = s > 0 ? mu / s : INFINITY;
    const double t_max = alpha * std::sqrt(detail::kTail);
    const double t0 = std::min(t_edge, t_max);
    const Quadrature &radial = unit_gauss_legendre(nodes), &azimuth = radial,
                     &half_turn = half_turn_cosines(nodes);

    // Mean over the azimuth of |mu - s t cos phi| g(|mu - s t cos phi| cos theta_m).
    const auto ring = [&](double t, double weight) {
        const double cos_m = 1.0 / std::sqrt(1.0 + t * t);
        weight *= 2.0 * t / (alpha * alpha) * std::exp(-t * t / (alpha * alpha)) * cos_m;
        const double b = s * t;
        if (b <= 1e-12) {
            visit(std::min(1.0, mu * cos_m), weight * mu);
            return;
        }
        const auto see = [&](double cos_phi, double fraction) {
            const double projected = std::abs(mu - b * cos_phi);
            visit(std::min(1.0, projected * cos_m), weight * projected * fraction);
        };
        if (mu >= b) {
            for (std::size_t k = 0; k < half_turn.nodes.size(); ++k) {
                see(half_turn.nodes[k], half_turn.weights[k]);
            }
            return;
        }
        // Split where mu = b cos phi, so that each part is smooth.
        const double phi_edge = std::acos(mu / b);
        const auto arc = [&](double from, double to) {
            const double part = (to - from) * std::numbers::inv_pi;
            for (std::size_t k = 0; k < azimuth.nodes.size(); ++k) {
                see(std::cos(from + (to - from) * azimuth.nodes[k]), azimuth.weights[k] * part);
            }
        };
        arc(0.0, phi_edge);
        arc(phi_edge, std::numbers::pi);
    };
    for (std::size_t k = 0; k < radial.nodes.size(); ++k) {
        ring(t0 * radial.nodes[k], t0 * radial.weights[k]);
    }
    if (t0 < t_max) {
        const double v_max = std::sqrt(t_max * t_max - t0 * t0);
        for (std::size_t k = 0; k < radial.nodes.size(); ++k) {
            const double v = v_max * radial.nodes[k];
            const double t = std::sqrt(t0 * t0 + v * v);
            ring(t, v_max * radial.weights[k] * v / t);
        }
    }
}

}  // namespace nacre::paint
