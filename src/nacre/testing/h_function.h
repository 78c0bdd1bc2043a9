#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "nacre/core/quadrature.h"

namespace nacre::test {

/// H of the characteristic function Psi, by iteration of its integral equation in the form that
/// converges fast:  1/H = sqrt(1 - 2 Int Psi dx) + Int x Psi(x) H(x)/(mu + x) dx.
///                                                        [chandrasekhar-1960, chapter V]
class HFunction {
 public:
    explicit HFunction(std::function<double(double)> psi)
        : psi_(std::move(psi)), rule_(gauss_legendre(64, 0, 1)), h_(rule_.nodes.size(), 1.0) {
        double integral = 0;
        for (std::size_t i = 0; i < h_.size(); ++i) {
            integral += rule_.weights[i] * psi_(rule_.nodes[i]);
        }
        first_ = std::sqrt(std::max(1 - 2 * integral, 0.0));
        for (int iteration = 0; iteration < 200; ++iteration) {
            std::vector<double> next;
            for (double mu : rule_.nodes) next.push_back((h_[next.size()] + (*this)(mu)) / 2);
            h_ = next;
        }
    }
    double operator()(double mu) const {
        double integral = 0;
        for (std::size_t i = 0; i < h_.size(); ++i) {
            const double x = rule_.nodes[i];
            integral += rule_.weights[i] * x * psi_(x) * h_[i] / (mu + x);
        }
        return 1 / (first_ + integral);
    }

 private:
    std::function<double(double)> psi_;
    Quadrature rule_;
    std::vector<double> h_;
    double first_ = 0;
};

}  // namespace nacre::test
