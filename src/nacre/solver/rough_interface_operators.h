#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "nacre/core/lane_math.h"
#include "nacre/core/lanes.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/directions.h"
#include "nacre/solver/fourier_kernel.h"
#include "nacre/solver/impedance.h"
#include "nacre/solver/rough_interface.h"

// Integrals over the facets of a rough interface that are visible from one direction. The nodes are
// facets, not directions, so that narrow lobes need no more of them.

namespace nacre::solver {

/// Light that leaves the surface after one facet, and its exit direction: of eight facets.
struct FacetExits {
    bool through = false;
    DoubleLanes fraction{};  ///< of the light that met the surface; 0 where none leaves
    DoubleLanes cosine{};    ///< of the exit direction, in (0, 1]
    DoubleLanes sine{};
    DoubleLanes cos_phi{};  ///< azimuth between directions of travel before and after
};

/// How fast the integrand varies, for the choice of nodes.
struct FacetDetail {
    double polar = 0;  ///< its phase in rad per rad of the polar angle of the exit direction
    double order = 0;  ///< its largest azimuthal order
    /// It jumps at this cosine of the exit directions inside (on the side of larger index); 0:
    /// nowhere.
    double edge_inside = 0;
};

/// smith_beckmann_over_cosine(), to 1e-13 of it.
DoubleLanes smith_beckmann_over_cosine(const DoubleLanes& cosine, const DoubleLanes& sine,
                                       double alpha);

/// Calls visit(FacetExits) for nodes that integrate over all that leaves the surface when light
/// comes from the polar angle theta on the side of index n_incident. Fractions sum to 1 - m(theta).
///
/// Nodes are polar in the slope plane. Rings are cut where facets turn out of sight, reflect or
/// refract beyond the horizon, or begin to reflect totally: between cuts the integrand is smooth
/// but for square roots at the ends, which the cubic 3 u^2 - 2 u^3 takes away.
template <class Visit>
void for_each_facet_exit(double theta, double alpha, double n_incident, double n_transmitted,
                         FacetDetail detail, Visit&& visit) {
    constexpr double kTail = 20.0;  // e^-20 of the facets are left out
    const double c = std::cos(theta), s = std::sin(theta);
    const double eta = n_transmitted / n_incident;
    const bool inside = eta < 1;
    const double total_reflection = inside ? std::sqrt(1 - eta * eta) : -1.0;
    const double scale = smith_beckmann_over_cosine(c, s, alpha);
    const double t_max = alpha * std::sqrt(kTail);

    // Of eight facets: their slope's size and azimuth, as part of a turn, and their weight.
    struct Node {
        double t = 0, turn = 0, weight = 0;
    };
    std::array<Node, kLanes> waiting;
    int waiting_count = 0;
    const auto evaluate = [&] {
        const auto lanes = [&](double Node::*value) {
            return make_lanes<DoubleLanes>([&](int i) { return waiting[i].*value; });
        };
        const DoubleLanes zero{}, one = splat(1.0), t = lanes(&Node::t);
        const CosineSine<DoubleLanes> azimuth = cos_sin_turns(lanes(&Node::turn));
        const DoubleLanes p = t * azimuth.cosine, q = t * azimuth.sine;
        const DoubleLanes length = sqrt_lanes(1 + t * t);
        const DoubleLanes projected = max_lanes(c + s * p, zero);
        const DoubleLanes cosine = min_lanes(projected / length, one);
        const DoubleLanes fraction = lanes(&Node::weight) * projected * scale;
        const DoubleLanes reflectance =
            optics::dielectric_reflectance(splat(n_incident), splat(n_transmitted), cosine);
        const auto leave = [&](const DoubleLanes& x, const DoubleLanes& y, const DoubleLanes& z,
                               const DoubleLanes& part, bool through) {
            const DoubleLanes across = sqrt_lanes(x * x + y * y);
            FacetExits exit;
            exit.through = through;
            exit.cosine = where_positive(z, min_lanes(z, one), one);
            exit.sine = min_lanes(across, one);
            exit.fraction =
                where_positive(z,
                               fraction * part * exit.cosine *
                                   smith_beckmann_over_cosine(exit.cosine, exit.sine, alpha),
                               zero);
            exit.cos_phi =
                where_positive(across, min_lanes(max_lanes(-x / across, -one), one), one);
            visit(exit);
        };
        const DoubleLanes twice = 2 * cosine / length;
        leave(twice * p - s, twice * q, twice - c, reflectance, false);
        const DoubleLanes transmittance = 1 - reflectance;
        if (lane_max(transmittance) > 0) {
            const DoubleLanes bend =
                (cosine / eta -
                 optics::refracted_cos(splat(n_incident), splat(n_transmitted), cosine)) /
                length;
            leave(bend * p - s / eta, bend * q, c / eta - bend, transmittance, true);
        }
        waiting_count = 0;
    };

    // Cosines of exit directions at which rings are cut.
    const std::array<double, 2> reflected_cut = {0.0, inside ? detail.edge_inside : 0.0};
    const std::array<double, 2> through_cut = {0.0, inside ? 0.0 : detail.edge_inside};
    const int reflected_cuts = reflected_cut[1] > 0 ? 2 : 1,
              through_cuts = through_cut[1] > 0 ? 2 : 1;

    // Phase of the integrand, in rad, over facets up to slope t: reflection turns light by twice
    // the tilt of the facet, refraction by less than the tilt; the azimuth makes one turn when the
    // slope passes s.
    const auto phase_of = [&](double t) {
        return detail.polar * std::min(inside ? 2 * t : t, 0.5 * std::numbers::pi) +
               detail.order * std::min(2 * t / std::max(s, 1e-9), 1.0);
    };
    // Of an integrand without phase: to 1e-7 of all facets, and with phase as far as exit nodes
    // resolve radiance (rough_interface_test.cpp).
    constexpr double kBase = 12, kAtLeast = 5;
    const auto nodes = [](double count) { return static_cast<int>(std::ceil(count)); };

    const auto ring = [&](double t, double weight) {
        weight *= 2 * t / (alpha * alpha) * std::exp(-t * t / (alpha * alpha)) / std::numbers::pi;
        // The azimuths, by p = t cos phi, where the integrand is not smooth.
        std::array<double, 7> cut{};
        int cuts = 0;
        cut[cuts++] = 0;
        double end = std::numbers::pi;
        if (s * t > c) end = std::acos(-c / (s * t));
        const auto cut_at = [&](double p) {
            if (std::abs(p) < t) {
                const double phi = std::acos(p / t);
                if (phi > 0 && phi < end) cut[cuts++] = phi;
            }
        };
        const double length = std::sqrt(1 + t * t);
        if (inside) cut_at((total_reflection * length - c) / s);
        for (int k = 0; k < reflected_cuts; ++k) {
            cut_at((0.5 * (c + reflected_cut[k]) * length * length - c) / s);
        }
        for (int k = 0; k < through_cuts; ++k) {
            // cosine/eta - refracted cosine = turned for the facets that refract to that cosine.
            const double turned = (c / eta - through_cut[k]) * length;
            const double cosine = 0.5 * eta * (turned * turned - 1 + 1 / (eta * eta)) / turned;
            if (cosine > eta * turned) cut_at((cosine * length - c) / s);
        }
        cut[cuts++] = end;
        for (int k = 1; k < cuts; ++k) {  // by insertion: there are seven at most
            for (int j = k; j > 0 && cut[j] < cut[j - 1]; --j) std::swap(cut[j], cut[j - 1]);
        }
        const bool whole = cuts == 2 && end == std::numbers::pi;
        // The fewer facets are so steep, the fewer digits of what they do matter.
        const double ring_base = kBase * (1 - 0.5 * (t * t) / (t_max * t_max));
        for (int k = 0; k + 1 < cuts; ++k) {
            const double from = cut[k], width = cut[k + 1] - from;
            if (width < 1e-12) continue;
            // A whole ring is periodic: equal steps converge fastest.
            const int count =
                nodes(whole ? 2 * ring_base + 0.36 * phase_of(t)
                            : ring_base + 0.72 * phase_of(t) * width / std::numbers::pi);
            const Quadrature& rule = unit_gauss_legendre(count);
            for (int i = 0; i < count; ++i) {
                const double u = rule.nodes[i];
                const double phi = whole ? std::numbers::pi * (i + 0.5) / count
                                         : from + width * u * u * (3 - 2 * u);
                const double step =
                    whole ? std::numbers::pi / count : width * rule.weights[i] * 6 * u * (1 - u);
                waiting[waiting_count] = {t, phi / (2 * std::numbers::pi), weight * step};
                if (++waiting_count == kLanes) evaluate();
            }
        }
    };

    std::array<double, 16> cut{};
    int cuts = 0;
    cut[cuts++] = 0;
    const auto cut_at = [&](double t) {
        if (std::abs(t) > 0 && std::abs(t) < t_max) cut[cuts++] = std::abs(t);
    };
    cut_at(c / s);
    if (inside) {
        const double critical = std::acos(total_reflection);
        cut_at(std::tan(theta - critical));
        cut_at(std::tan(theta + critical));
    }
    for (int k = 0; k < reflected_cuts; ++k) {
        const double to = std::acos(reflected_cut[k]);
        cut_at(std::tan(0.5 * (theta - to)));
        cut_at(std::tan(0.5 * (theta + to)));
    }
    for (int k = 0; k < through_cuts; ++k) {
        const double z = through_cut[k], across = std::sqrt(1 - z * z);
        cut_at((s - eta * across) / (c - eta * z));
        cut_at((s + eta * across) / (c - eta * z));
    }
    cut[cuts++] = t_max;
    std::sort(cut.begin(), cut.begin() + cuts);
    for (int k = 0; k + 1 < cuts; ++k) {
        const double from = cut[k], width = cut[k + 1] - from;
        if (width < 1e-12 * t_max) continue;
        const int count = nodes(kAtLeast + (2 * kBase + 0.36 * phase_of(t_max)) * width / t_max);
        const Quadrature& rule = unit_gauss_legendre(count);
        for (int i = 0; i < count; ++i) {
            const double u = rule.nodes[i];
            ring(from + width * u * u * (3 - 2 * u), width * rule.weights[i] * 6 * u * (1 - u));
        }
    }
    if (waiting_count > 0) {
        for (int i = waiting_count; i < kLanes; ++i) waiting[i].weight = 0;
        evaluate();
    }
}

// The rough interface (rough_interface.h) as matrices for the solver, one set per azimuthal order.
//
// Psi is basic radiance times the square root of etendue, so that both sides share one scale and
// transmission inwards is the transpose of that outwards. The matrices are the Galerkin projections
// of the kernel on the polynomials that the quadrature nodes interpolate,
//
//     A_ij = Int Int l_i(x) K(x, y) l_j(y) dx dy / sqrt(W_i W_j),
//
// with the inner integral over facets. Hence (1) lobes may be narrower than the spacing of the
// nodes: only the radiance that they scatter must be smooth, which depends on the flakes; (2)
// projections of a contraction contract, and constants are among the polynomials: energy is
// conserved exactly; (3) for alpha -> 0 they tend to Fresnel's diagonal matrices.
//
// Below the interface light goes down as D = Rii U + T^T s, and comes back as U = R D. With
// impedances Y_i = (1 - Rii)(1 + Rii)^-1 and Y = (1 - R)(1 + R)^-1, and B = T (1 + Rii)^-1,
//
//     T U = [2 B (Y_i + Y)^-1 B^T - B T^T] s:
//
// one Cholesky factor of a symmetric positive definite matrix, as for everything else here.

class RoughInterfaceOperators {
 public:
    /// One order, on the active nodes: n inside, of them the first `exits` outside too.
    struct Order {
        int n = 0, exits = 0;
        std::vector<double> impedance;  ///< Y_i, n x n
        std::vector<double> through;    ///< B^T, n x exits
        std::vector<double> direct;     ///< B T^T, exits x exits
        std::vector<double> enter;      ///< T^T, n x exits
    };

    RoughInterfaceOperators(const Directions& directions, const ActiveNodes& active, double alpha);

    const Order& order(int l) const { return orders_[l]; }

    /// Error of reciprocity of the quadratures: the difference between the masked fraction m
    /// inside, found from inside and from what enters, rms over etendue. Of it the part that is
    /// smooth on the sphere, a polynomial of twelve terms in the cosine: the polynomials of nodes
    /// are in the angle, and may have a cone at the normal, which no radiance has and the nodes of
    /// facets do not follow.
    double asymmetry() const { return asymmetry_; }

    std::size_t bytes() const;

 private:
    std::vector<Order> orders_;
    double asymmetry_ = 0;
};

/// Those of the interface of these nodes, the greater part of the time of a solve. The last few are kept,
/// 64 MiB in all, for callers that solve many paints under coats of one index and roughness: fits,
/// pages with sliders.
std::shared_ptr<const RoughInterfaceOperators> rough_interface_operators(
    const Directions& directions, const ActiveNodes& active, double alpha);

/// T U T^T of one order into u (exits x exits), given the impedance y of all that lies below the
/// interface (n x n, overwritten).
void reflect_under_rough_interface(const RoughInterfaceOperators::Order& interface, DoubleLanes* y,
                                   DoubleLanes* u, ImpedanceWorkspace& work);

/// T S T^T of one order into u (exits x exits), for a symmetric S (n x n): light transmitted in and
/// out by the interface, with one reflection S between. The tiles on and below the diagonal are
/// written.
void reflect_once_under_rough_interface(const RoughInterfaceOperators::Order& interface,
                                        const DoubleLanes* s, DoubleLanes* u,
                                        ImpedanceWorkspace& work);

}  // namespace nacre::solver
