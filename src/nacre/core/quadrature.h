#pragma once

#include <vector>

namespace nacre {

/// Nodes (increasing) and weights of a rule  Int_a^b f(x) dx = sum_i weights[i] f(nodes[i]).
struct Quadrature {
    std::vector<double> nodes, weights;
};

/// The n-point Gauss-Legendre rule on [a, b], exact for polynomials of degree 2 n - 1; every node
/// lies strictly inside the interval.
///
/// Nodes are the zeros of the Legendre polynomial P_n, found by Newton's method from Tricomi's
/// estimate; weights are 2 / ((1 - x^2) P_n'(x)^2) [abramowitz-stegun-1964, eq. 25.4.29 and
/// 25.4.30]. Nodes and weights are exact to kGaussLegendreError (b - a) / 2 for n <= 512.
/// @throws DomainError unless 1 <= n <= 100000, a < b and both are finite
Quadrature gauss_legendre(int n, double a, double b);

/// The n-point rule on [0, 1], computed once per process.
const Quadrature& unit_gauss_legendre(int n);

/// The same with cos(pi x) in place of each node x: for means of functions of cos(phi) over phi from
/// 0 to pi, which would spend most of their time on cosines.
const Quadrature& half_turn_cosines(int n);

inline constexpr double kGaussLegendreError = 1e-14;

}  // namespace nacre
