#pragma once

#include <vector>

#include "nacre/layers/directions.h"
#include "nacre/layers/fourier_kernel.h"
#include "nacre/layers/impedance.h"

// The rough interface (rough_interface.h) as matrices for the solver, one set per azimuthal order.
//
// Psi is basic radiance times the square root of etendue, so that both sides share one scale and
// what goes in is the transpose of what comes out. The matrices are the Galerkin projections of the
// kernel on the polynomials that the quadrature nodes interpolate,
//
//     A_ij = Int Int l_i(x) K(x, y) l_j(y) dx dy / sqrt(W_i W_j),
//
// with the inner integral over facets. Hence (1) lobes narrower than the spacing of the nodes do no
// harm: only the light they scatter must be smooth, and that the flakes decide; (2) projections of
// a contraction contract, and constants are among the polynomials: energy is conserved exactly;
// (3) for alpha -> 0 they tend to Fresnel's diagonal matrices.
//
// Below the interface light goes down as D = Rii U + T^T s, and comes back as U = R D. With
// impedances Y_i = (1 - Rii)(1 + Rii)^-1 and Y = (1 - R)(1 + R)^-1, and B = T (1 + Rii)^-1,
//
//     T U = [2 B (Y_i + Y)^-1 B^T - B T^T] s:
//
// one Cholesky factor of a symmetric positive definite matrix, as for everything else here.

namespace nacre::layers {

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

    /// How far the quadrature over facets is from reciprocal: the difference between the masked
    /// share m inside, found from inside and from what enters, rms over etendue.
    double asymmetry() const { return asymmetry_; }

 private:
    std::vector<Order> orders_;
    double asymmetry_ = 0;
};

/// T U T^T of one order into u (exits x exits), given the impedance y of all that lies below the
/// interface (n x n, overwritten).
void reflect_under_rough_interface(const RoughInterfaceOperators::Order& interface, DoubleLanes* y,
                                   DoubleLanes* u, ImpedanceWorkspace& work);

/// T S T^T of one order into u (exits x exits), for a symmetric S (n x n): light that the interface
/// lets in and out, with one reflection S between.
void reflect_once_under_rough_interface(const RoughInterfaceOperators::Order& interface,
                                        const DoubleLanes* s, DoubleLanes* u,
                                        ImpedanceWorkspace& work);

}  // namespace nacre::layers
