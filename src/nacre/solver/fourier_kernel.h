#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/core/progress.h"
#include "nacre/solver/directions.h"
#include "nacre/solver/medium.h"

// The scattering kernel sigma_s p in azimuthal Fourier orders at pairs of quadrature nodes.
//
//     sigma_s p(mu_i, mu_j, phi) = sum_l (2 - delta_l0) p_l(mu_i, mu_j) cos l phi,
//
// phi between directions of travel. Even in phi, symmetric in i and j. "Same" keeps the hemisphere
// of travel, "opposite" changes it.

namespace nacre::solver {

/// What the message of a solver that was stopped calls its work.
inline constexpr const char* kSolving = "solving the paint";

/// Which nodes take part in which order. A direction near the normal has hardly any high orders
/// (they vanish like sin^l theta); the nodes that do are the last ones. What nodes take part changes
/// only after orders that are solved and not interpolated (order_interpolation.h).
class ActiveNodes {
 public:
    /// @param alpha   smallest flake roughness, which sets the width of lobes in azimuth
    /// @param orders  upper bound on the number of orders, >= 1
    ActiveNodes(const Directions& directions, double alpha, int orders);

    int orders() const { return static_cast<int>(first_.size()); }
    /// First active node of order l; a multiple of kTile.
    int first(int l) const { return first_[l]; }
    int order_count(int node) const { return order_count_[node]; }
    friend bool operator==(const ActiveNodes&, const ActiveNodes&) = default;

 private:
    std::vector<int> first_, order_count_;
};

/// Azimuthal orders from `begin` on, below `end`.
struct OrderRange {
    int begin = 0, end = std::numeric_limits<int>::max();
};

/// p_l of one layer by block of eight wavelengths, in 1/(um sr). Single precision: the
/// solver takes extinction from the sums of these very numbers, so that rounding costs no energy.
class FourierKernel {
 public:
    /// Of the first `blocks` blocks, those of `orders` that the active nodes have.
    /// @throws Error if `work`, where given, is stopped
    FourierKernel(const LayerMedium& layer, const Directions& directions, const ActiveNodes& active,
                  int blocks, SharedProgress* work = nullptr, OrderRange orders = {});

    /// Memory that one block of all orders takes, in bytes.
    static std::size_t bytes(const Directions& directions, const ActiveNodes& active);

    /// Rows i >= j of order l, both counted from active.first(l): element i (i + 1)/2 + j.
    const FloatLanes* same(int block, int l) const { return same_[block].data() + offset(l); }
    const FloatLanes* opposite(int block, int l) const {
        return opposite_[block].data() + offset(l);
    }

 private:
    std::size_t offset(int l) const { return offset_[l - orders_.begin]; }
    void add_flakes(const FlakeMedium& flake, const Directions& d, const ActiveNodes& active,
                    SharedProgress* work);
    void add_pigment(const PigmentMedium& pigment, const Directions& d, const ActiveNodes& active,
                     SharedProgress* work);
    /// @param series  terms of the phase function's Legendre series, each for all wavelengths of the
    ///                block or for each of them
    template <class T>
    void add_legendre(const std::vector<T>& series, const DoubleLanes& scattering,
                      const Directions& d, const ActiveNodes& active, int block,
                      SharedProgress* work);

    OrderRange orders_;
    std::vector<std::size_t> offset_;                       // by order of the range
    std::vector<std::vector<FloatLanes>> same_, opposite_;  // [block]
};

}  // namespace nacre::solver
