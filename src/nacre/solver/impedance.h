#pragma once

#include <span>

#include "nacre/solver/lane_matrix.h"

// Homogeneous scattering slabs as two-port impedances, and doubling as a mean of matrices.
//
// Let psi+ and psi- be the intensities travelling down and up at the quadrature nodes, each scaled
// by sqrt(weight x cosine), so that all operators are symmetric. With u = psi+ + psi- and
// v = psi+ - psi- (the net flux) the transfer equation of one azimuthal order reads
//
//     dv/dz = -E u,    du/dz = -F v,    E = A - B,  F = A + B,
//
// A = extinction minus scattering into the same hemisphere, B = scattering into the other. E is
// positive semidefinite (E = 0 on the isotropic field if nothing absorbs), F positive definite.
//
// A slab is symmetric, so it is described by what it does to equal and to opposite light from its
// two sides: v = Z_s u and v = Z_a u at the surface, the matrix forms of tanh and coth of half the
// optical thickness. Two equal slabs on each other follow from tanh 2x and coth 2x:
//
//     Z_a' = (Z_s + Z_a)/2,    Z_s' = 2 (Z_s^-1 + Z_a^-1)^-1,
//
// the arithmetic and the harmonic mean. One Cholesky factor, one triangular solve and one Gram
// product a doubling, a fifth of the classic R, T doubling [grant-hunt-1969; van-de-hulst-1980,
// sec. 4.2], nothing to pivot, and convergence to the half space (their geometric mean) is
// quadratic. Reciprocity is exact and flux is conserved to rounding, for any thickness.
//
// docs/solver.md derives this; impedance_test.cpp holds it to the scalar two-stream solution.

namespace nacre::solver {

/// Scratch memory for slabs of up to n nodes; allocate once a thread.
struct ImpedanceWorkspace {
    explicit ImpedanceWorkspace(int n) : a(n * n), b(n * n), c(n * n) {}
    LaneBuffer a, b, c;
};

/// How many doublings a slab needs.
///
/// Modes of half-thickness x err in optical thickness by x^6/1575 in the starting step (the third
/// convergent of tanh's continued fraction); modes too thick for it start as if they had half-
/// thickness 6/x and must double until they are opaque.
/// @param largest_optical_depth  thickness times the largest extinction over cosine of the nodes
int doublings_for(double largest_optical_depth);

/// Z_s and Z_a of a slab of thickness `thickness` (in units of the inverse of E and F), n nodes.
/// E and F are n x n, symmetric, F positive definite or 0 (a slab that is empty at a wavelength has
/// Z_s = 0 and some Z_a >= 1e30 there); both are overwritten: E by Z_s, F by Z_a on and below its
/// diagonal.
void slab_impedance(DoubleLanes* e_to_zs, DoubleLanes* f_to_za, double thickness, int doublings,
                    int n, ImpedanceWorkspace& work);

/// The impedance y (v = y u, n x n) seen through a slab that lies on something of impedance y;
/// in place, Z_a from its lower triangle. With Q = y + Z_s,
///
///     y' = Z_s + Q - Q (Q + (Z_a - Z_s)/2)^-1 Q,
///
/// the slab as a two-port of two shunts Z_s and, between them, (Z_a - Z_s)/2 in series. This form
/// errs by rounding of y and Z_s at any thickness: as the slab gets thin Z_a grows beyond bounds
/// and the last term vanishes, where the difference of two terms of the size of Z_a would lose y.
void stack_on(const DoubleLanes* zs, const DoubleLanes* za, DoubleLanes* y, int n,
              ImpedanceWorkspace& work);

/// Reflection psi- = R psi+ from impedance, R = 2 (1 + y)^-1 - 1; in place.
void impedance_to_reflection(DoubleLanes* y, int n, ImpedanceWorkspace& work);

/// U = R (1 - f R)^-1, the light that leaves the paint upwards inside the coat when the interface
/// reflects the fraction f_i = interface_reflectance[i] of node i back down, from the impedance y
/// of all that lies below. An interface is a shunt too, D = (1 - f)/(1 + f), and
///
///     U = 2 (1 + f)^-1 (y + D)^-1 (1 + f)^-1 - (1 + f)^-1.
///
/// The first `rows` rows and columns only, into u (rows x rows); reads the lower triangle of y.
void reflect_under_interface(const DoubleLanes* y, const DoubleLanes* interface_reflectance,
                             DoubleLanes* u, int n, int rows, ImpedanceWorkspace& work);

}  // namespace nacre::solver
