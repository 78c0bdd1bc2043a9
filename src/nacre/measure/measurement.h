#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/measure/geometry.h"
#include "nacre/spectra/colour.h"

// The report of a multi-angle spectrophotometer on a panel, computed or measured.

namespace nacre::measure {

inline constexpr Range kHalfAngle{0, 10, "deg"};  ///< of an instrument's cones

/// The solid angles of an instrument: round, about the directions of its geometry. Zero is a point.
struct Aperture {
    double lamp_half_angle_deg = 0;      ///< in kHalfAngle
    double detector_half_angle_deg = 0;  ///< in kHalfAngle

    friend bool operator==(const Aperture&, const Aperture&) = default;
};

/// Illuminant and observer of the colours, and the solid angles of the instrument.
struct Conditions {
    spectra::Illuminant illuminant = spectra::Illuminant::D65;
    spectra::Observer observer = spectra::Observer::cie1964_10deg;
    Aperture aperture{};

    friend bool operator==(const Conditions&, const Conditions&) = default;
};

/// The reading at one geometry.
struct Reading {
    Geometry geometry;
    /// pi times the BRDF at the measurement's wavelengths: 1 is the perfect diffuser. Empty where
    /// only the colour is known.
    std::vector<double> reflectance_factor;
    Vec3d xyz{};  ///< the perfect diffuser has Y = 100
    Vec3d lab{};  ///< CIELAB relative to the perfect diffuser

    friend bool operator==(const Reading&, const Reading&) = default;
};

double chroma(const Vec3d& lab);   ///< C* = sqrt(a*^2 + b*^2)
double hue_deg(const Vec3d& lab);  ///< h in [0, 360); 0 for C* < 1e-9

/// The colour as a chip on a display: encoded sRGB in [0, 1], the perfect diffuser being white.
/// Colours brighter than the display, or outside its gamut, are clipped.
Vec3d srgb_chip(const Vec3d& lab);
/// The same, but colours brighter than the display are scaled down until they fit, so that a lobe
/// keeps its hue.
Vec3d srgb_chip_at_full_light(const Vec3d& lab);

struct Measurement {
    std::string name;  ///< of the panel
    Conditions conditions;
    std::vector<double> wavelengths_nm;  ///< empty if no reading has a spectrum
    std::vector<Reading> readings;

    /// The reading at that geometry in the plane of incidence, to 1e-6 deg. Null if there is none.
    const Reading* find(double theta_i_deg, double aspecular_deg) const;

    friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// Instruments name directions to a tenth of a degree.
inline constexpr double kSameGeometry_deg = 0.1;
/// The reading that is nearest to a geometry by separation_deg(), within kSameGeometry_deg. Null if
/// there is none.
const Reading* find_reading(const Measurement& measurement, const Geometry& geometry);

/// XYZ of the perfect diffuser, by the sums that coloured() takes: what L*a*b* is relative to. By
/// sums at 5 nm without wavelengths.
/// @throws DomainError as spectra::white_point()
Vec3d white_point(const std::vector<double>& wavelengths_nm, const Conditions& conditions);

/// XYZ and L*a*b* of a reflectance factor, added to a reading: under A, D50, D65 and E by sums over
/// the samples, under FL2 and FL11, whose lines fall between them, by sums at 5 nm
/// (spectra/xyz.h).
/// @throws DomainError as spectra::reflectance_to_xyz()
Reading coloured(Geometry geometry, const std::vector<double>& wavelengths_nm,
                 std::vector<double> reflectance_factor, const Conditions& conditions);

// Measures of the change of colour with angle.

/// 2.69 (L*15 - L*110)^1.11 / (L*45)^0.86, lit from 45 deg: 0 for a solid colour, some 15 to 20 for
/// a strong metallic.                                      [alman-1987, by way of docs/measure.md]
/// Empty if one of the three angles was not read, or the formula has no value (L*15 < L*110, or
/// L*45 = 0).
std::optional<double> flop_index(const Measurement& measurement);

/// The path of the colour in the a*b* plane as the view leaves the mirror direction.
struct ColourTravel {
    std::vector<const Reading*>
        path;           ///< readings in the plane lit from one angle, by aspecular angle
    double length = 0;  ///< sum of the steps in a*b*
};

/// @param theta_i_deg  the lamp; readings lit from elsewhere, or off the plane, are left out
ColourTravel colour_travel(const Measurement& measurement, double theta_i_deg = 45);

/// What is to be said of colours that come from spectra which begin above 420 nm, end below 680 nm, or
/// have steps above 30 nm: sums over so few wavelengths may be wrong by 10 in Delta E and more. None of others.
std::optional<std::string> coarse_spectra_warning(const Measurement& measurement);

}  // namespace nacre::measure
