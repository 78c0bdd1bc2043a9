#pragma once

#include <vector>

#include "nacre/core/lanes.h"

namespace nacre::optics {

/// How particles turn light, at a set of wavelengths: a density over directions in 1/sr that depends
/// on the cosine of the angle between the directions of travel, before and after. Stated by its
/// Legendre series
///
///     p(cosine) = sum_n (2 n + 1)/(4 pi) chi_n P_n(cosine),   chi_0 = 1, chi_1 = g,
///
/// which the solver takes; and tabulated, for evaluation and sampling. Between
/// kIntervals equal steps of the angle the table is linear in the cosine, and it integrates to 1.
class PhaseFunction {
 public:
    /// @param legendre  [wavelength][degree]: chi_n from n = 0; shorter lists end in zeros
    /// @throws DomainError if there is no wavelength, or a list does not begin with 1, or goes on
    /// with what is not in [-1, 1]
    explicit PhaseFunction(std::vector<std::vector<double>> legendre);

    int wavelength_count() const { return static_cast<int>(legendre_.size()); }
    /// Terms of the longest series.
    int degrees() const { return degrees_; }
    /// chi_n; 0 beyond the end of a series.
    double coefficient(int degree, int wavelength) const {
        const std::vector<double>& series = legendre_[wavelength];
        return degree < static_cast<int>(series.size()) ? series[degree] : 0.0;
    }
    const std::vector<std::vector<double>>& legendre() const { return legendre_; }

    /// The same at some of the wavelengths.
    PhaseFunction at(const std::vector<int>& wavelengths) const;

    /// The smallest |g| whose Henyey-Greenstein function, with chi_n = g^n, has no smaller
    /// coefficients than this one wherever (2 n + 1) chi_n matters: how sharp it is.
    double sharpness() const;

    static constexpr int kIntervals = 1024;
    /// Of the tabulated value, over the largest one at the wavelength, for a series of up to 40
    /// terms; it grows with the square of their number.
    static constexpr double kTableError = 6e-4;

    /// Between nodes `node` and `node + 1`, which is at 180 deg for the last one.
    struct Place {
        int node;
        double fraction;
    };
    /// @param cosine  rounding beyond [-1, 1] is taken as the end
    static Place locate(double cosine);
    /// From 1 down to -1.
    static double node_cosine(int node);
    /// By wavelength, at one node.
    const double* row(int node) const { return table_.data() + node * stride_; }

    /// At the eight wavelengths of `block`; lanes beyond the last wavelength repeat it.
    DoubleLanes value(double cosine, int block) const;

    friend bool operator==(const PhaseFunction& a, const PhaseFunction& b) {
        return a.legendre_ == b.legendre_;
    }

 private:
    std::vector<std::vector<double>> legendre_;
    int degrees_ = 0;
    std::size_t stride_ = 0;     // wavelengths, rounded up to blocks
    std::vector<double> table_;  // [node][wavelength]
};

}  // namespace nacre::optics
