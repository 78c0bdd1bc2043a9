#pragma once

#include <span>
#include <vector>

#include "nacre/optics/material.h"

// Scattering of a plane wave by a homogeneous sphere: Mie's series.
// Signs, time factor and the meaning of k: docs/conventions.md, which are those of the source.

namespace nacre::optics {

/// Size parameters x = pi diameter / wavelength, the wavelength taken in the surrounding medium.
inline constexpr Range kSizeParameterRange{.lo = 1e-6, .hi = 1e4};
/// |m| x is the number of terms that a recurrence needs.
inline constexpr double kMaxPhaseShift = 1e6;

/// Relative error of the efficiencies against 40-digit arithmetic, for 1e-3 <= x <= 1e3 and indices
/// 0.5 <= n <= 5, k <= 5; of the extinction of a sphere that hardly absorbs, that of its scattering.
inline constexpr double kMieRelativeError = 1e-9;

/// Cross sections over the sphere's shadow, pi diameter^2 / 4.
struct MieEfficiencies {
    double extinction, scattering;
    double
        asymmetry;  ///< g, the mean cosine of the angle by which light is turned; 0 where no light
                    ///< is turned, as by a sphere of the medium's own index

    double absorption() const { return extinction - scattering; }
};

/// The series of one sphere.                                    [bohren-huffman-1983, chapter 4]
class MieSeries {
 public:
    /// @param size_parameter  x, in kSizeParameterRange
    /// @param relative_index  m, the sphere's index over that of the medium; k >= 0 absorbs
    /// @throws DomainError naming the argument, its value and its range
    MieSeries(double size_parameter, ComplexIndex relative_index);

    /// Number of terms, somewhat above those of [wiscombe-1980]: what follows is rounding.
    int terms() const { return static_cast<int>(electric_.size()); }
    /// a_n and b_n, n = 1 ... terms() at index n - 1; all 0 where the relative index is 1.
    ///                                                          [bohren-huffman-1983, eq. 4.53]
    const std::vector<ComplexIndex>& electric() const { return electric_; }
    const std::vector<ComplexIndex>& magnetic() const { return magnetic_; }

    /// [bohren-huffman-1983, eq. 4.61, 4.62 and page 120]
    MieEfficiencies efficiencies() const;

    /// (|S_1|^2 + |S_2|^2)/2 of light that is turned by the angle of this cosine, unpolarised: the
    /// power scattered per sr over the irradiance is this over the wave number squared. Over the
    /// sphere it integrates to pi x^2 times the scattering efficiency; it is a polynomial of degree
    /// 2 terms() in the cosine.                   [bohren-huffman-1983, eq. 4.74 and 4.77]
    double intensity(double cosine) const { return intensities(std::span(&cosine, 1))[0]; }
    /// The same for many cosines, which are the lanes.
    std::vector<double> intensities(std::span<const double> cosines) const;

 private:
    double size_parameter_;
    std::vector<ComplexIndex> electric_, magnetic_;
};

}  // namespace nacre::optics
