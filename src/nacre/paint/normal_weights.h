#pragma once

#include <algorithm>
#include <array>

#include "nacre/paint/flake_table.h"

namespace nacre::paint {

/// The nodes of for_each_normal(), gathered on the fine grid of FlakeTable.
///
/// A table is linear between two nodes of its grid, so that a sum over normals is one over the grid,
/// with weights that depend on the direction and the orientation of the flakes alone: they are found
/// once for R and T at all wavelengths. What the sums give is that of for_each_normal() with the
/// table's look-ups, to rounding.
class NormalWeights {
 public:
    /// @param mu, alpha, nodes  as of for_each_normal()
    NormalWeights(double mu, double alpha, int nodes);

    /// Int f(|w.m|) |w.m| D(m) dm, for an f that is linear between the nodes.
    /// @param value  (node of the grid) -> f there, a number or lanes
    template <class F>
    auto sum(F&& value) const {
        decltype(value(0)) sum{};
        for (int n = first_; n <= last_; ++n) sum += linear_[n] * value(n);
        return sum;
    }

    /// Int f^2(|w.m|) |w.m| D(m) dm of the f that is linear between its values, not of the values' squares.
    template <class F>
    auto sum_of_square(F&& value) const {
        decltype(value(0)) sum{}, here = value(first_);
        for (int n = first_; n <= last_; ++n) {
            const auto next = value(std::min(n + 1, last_));
            sum += here * (square_[n] * here + product_[n] * next);
            here = next;
        }
        return sum;
    }

 private:
    static constexpr int kNodes = FlakeTable::kFineIntervals + 1;
    int first_ = kNodes - 1, last_ = 0;  // of those that have a weight
    std::array<double, kNodes> linear_{};
    std::array<double, kNodes> square_{};   // of f^2
    std::array<double, kNodes> product_{};  // of f times that of the next node
};

}  // namespace nacre::paint
