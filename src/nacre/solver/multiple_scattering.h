#pragma once

#include <span>
#include <vector>

#include "nacre/solver/directions.h"
#include "nacre/solver/lane_matrix.h"

// The smooth part of a solved paint as a compact tensor.

namespace nacre::solver {

/// f(theta_i, theta_o, phi; wavelength) =
///     sum_l (2 - delta_l0) cos(l (phi - pi)) sum_k basis[k][wavelength] coefficient[k][l](i, j)
///
/// on the exit nodes i >= j: symmetric, hence reciprocal, by construction. phi - pi because phi is
/// measured between directions that point away from the surface. The spectral basis comes from a
/// singular value decomposition: a paint's wavelengths are strongly correlated.
///
/// Between nodes polynomials interpolate what is left of the values when they are divided by a lobe
/// of about their width,
///
///     exp(-((sin theta_i - sin theta_o)/lobe_width)^2) + kLobeFloor,
///
/// by which the result is multiplied again. A polynomial errs by some 1e-5 of the largest value
/// everywhere, which near the normal is many times what flakes that lie flat reflect there; so
/// divided, values that are small err by less.
struct MultipleScattering {
    std::vector<double> exit_angle;  ///< nodes theta_e, rad
    int wavelength_count = 0;
    std::vector<int> first;          ///< by order: first exit node with a coefficient
    std::vector<float> basis;        ///< [k][wavelength]
    std::vector<float> coefficient;  ///< [k][pair], pairs by order, then rows i >= j from first[l]
    double lobe_width = 0;  ///< of a sine; 0: polynomials interpolate the values themselves
    /// The first so many spectra suffice where values may err by the tolerance itself, not by a
    /// hundredth of it: in tables for pictures, whose own interpolation errs by more.
    int table_rank = 0;

    int orders() const { return static_cast<int>(first.size()); }
    int rank() const {
        return wavelength_count ? static_cast<int>(basis.size()) / wavelength_count : 0;
    }
    /// Pairs of nodes over all orders; coefficient.size() = rank() pair_count().
    std::size_t pair_count() const;

    /// Whether an order is evaluated at theta_e. Its values are zero at the nodes before
    /// first[order]; between these the interpolating polynomial would oscillate instead of
    /// vanishing, in phase in hundreds of orders, so that the order is set to zero up to the last
    /// of them. There the polynomial is zero too: there is no jump.
    bool contributes(int order, double theta_e) const {
        return first[order] == 0 || theta_e > exit_angle[first[order] - 1];
    }

    /// The lobe that values are divided by before they are interpolated; 1 if there is none.
    double lobe(double theta_i, double theta_o) const;

    friend bool operator==(const MultipleScattering&, const MultipleScattering&) = default;
};

/// What is left of MultipleScattering's lobe far away from its middle.
inline constexpr double kLobeFloor = 0.03;

/// A BRDF in 1/sr that counts as black: the least value to which a tolerance is relative, so that
/// rounding (some 1e-13 at grazing exit nodes) is never mistaken for light. Errors below it times
/// the tolerance, 1e-12, are made even where a paint is darker.
inline constexpr double kBlackBrdf = 1e-8;

/// How much finer than the tolerance orders are kept. At its peak the BRDF is a sum of many orders,
/// larger than each of them by far, and errs by less; but at dark angles beside a lobe orders cancel,
/// and the errors of all of them show.
inline constexpr double kFineErrorFraction = 0.01;
/// The most coefficients that are kept so finely, 1 MB and a quarter of that in a file; flakes of
/// alpha < 0.03 with fringes would have more.
inline constexpr int kMaxFineCoefficients = 1 << 18;

/// Values [pair][wavelength] in, compressed by truncating the spectral basis and rounding the
/// coefficients. Errors are relative to the smaller of the largest values that a pair's two
/// directions have, or kBlackBrdf. First tries an error of tolerance * kFineErrorFraction. If that takes
/// more than kMaxFineCoefficients, it keeps as many spectra as fit and accepts up to `tolerance`.
/// If even `tolerance` needs more than fit, it exceeds the limit and rounds the coefficients to
/// `tolerance`.
MultipleScattering compress(std::vector<double> exit_angle, std::vector<int> first,
                            int wavelength_count, std::span<const double> values, double tolerance);

/// Evaluates the multiple scattering for one incident direction at any number of outgoing ones.
class MultipleScatteringSlice {
 public:
    MultipleScatteringSlice(const MultipleScattering& multiple_scattering, double theta_i)
        : MultipleScatteringSlice(multiple_scattering, theta_i, multiple_scattering.rank()) {}
    /// Of the first `rank` spectra.
    MultipleScatteringSlice(const MultipleScattering& multiple_scattering, double theta_i,
                            int rank);
    /// Coefficients of the spectral basis, as many as there are spectra.
    void coefficients(double theta_o, double phi, std::span<double> out) const;
    /// The same of several directions, [direction][order l][k]: what is to be multiplied by
    /// (2 - delta_l0) cos(l (phi - pi)) and summed over l.
    void by_order(std::span<const double> theta_o, std::span<double> out) const;

 private:
    std::size_t lanes_of_terms() const;  // of a row

    const MultipleScattering& multiple_scattering_;
    ExitInterpolation interpolation_;
    double theta_i_;
    int rank_;
    // [j][l][k]: over the lobe, contracted with the weights of theta_i; rows of whole lanes.
    LaneBuffer by_node_;
};

}  // namespace nacre::solver
