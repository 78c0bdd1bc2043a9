#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/measure/measurement.h"
#include "nacre/spectra/observer.h"

namespace nacre::measure {

/// The surface that an instrument reads: the BRDF in 1/sr at each of some wavelengths, without the
/// specular reflection of a smooth interface. Polar angles in rad in [0, pi/2);
/// phi = phi_o - phi_i, pi being the mirror side (docs/conventions.md). Must be safe to call from
/// several threads at once.
using Brdf = std::function<std::vector<double>(double theta_i, double theta_o, double phi)>;

// A round solid angle about a direction, as an instrument's lamp or detector fills it.

/// One direction of a rule.
struct ConeNode {
    double theta = 0, phi = 0;  ///< rad
    double weight = 0;          ///< of its projected solid angle; all of a rule sum to 1
};

/// A rule for the mean over a cone, weighted with the cosine: `rings` Gauss-Legendre nodes in the
/// solid angle times 4 `rings` equal steps around, exact for polynomials of degree 4 rings - 1 in
/// the directions of a small cone. Nodes below the horizon are left out. A half angle of 0 gives
/// the direction itself.
/// @param half_angle  rad, >= 0
/// @param theta, phi  of the axis, rad, theta in [0, pi/2)
/// @param rings  >= 1
std::vector<ConeNode> cone_rule(double theta, double phi, double half_angle, int rings);

/// The colour of spectra at some wavelengths, for formats that hold RGB: linear Rec. 709 under D65
/// for the 2 degree observer (spectra::rec709_weights()), components outside the gamut cut off at
/// zero.
class SpectrumColour {
 public:
    /// @throws DomainError as spectra::rec709_weights()
    explicit SpectrumColour(const std::vector<double>& wavelengths_nm);

    /// @throws DomainError if a value is negative or not finite, or their number is another
    std::vector<double> rgb(const std::vector<double>& values) const;
    /// The Y of that colour; 0 if it were negative.
    double luminance(const std::vector<double>& values) const;

 private:
    Vec3d sum(const std::vector<double>& values) const;

    std::vector<Vec3d> weights_;
};

/// Tolerance of a reading with finite cones, relative to its greatest value over wavelengths. Rules
/// of growing size over both cones are tried until the last two agree to this; each is exact for
/// polynomials of a far higher degree than the one before, so that the error of the last is
/// smaller.
inline constexpr double kApertureTolerance = 1e-4;

/// Measures a surface with a virtual multi-angle spectrophotometer.
///
/// With an ideal aperture the reflectance factor is pi times the BRDF at the geometry. With finite
/// cones it is relative to a perfect diffuser in the place of the surface: the mean of pi f over
/// lamp and detector, weighted with cos theta_i cos theta_o over both solid angles
/// [nicodemus-1977, biconical reflectance factor]; rays below the horizon carry nothing.
/// The specular lobe of a smooth interface is not part of it, as instruments keep away from the
/// gloss.
///
/// @param wavelengths_nm  those of `brdf`, at least two, in equal steps
/// @throws DomainError if an angle or an aperture is out of range
/// @throws Error if the largest rule does not reach kApertureTolerance; Stopped if `progress` asks to
///         stop
Measurement measure(const std::string& name, const Brdf& brdf,
                    const std::vector<double>& wavelengths_nm, std::span<const Geometry> geometries,
                    const Conditions& conditions, const Progress& progress = {});

}  // namespace nacre::measure
