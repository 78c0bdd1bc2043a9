#pragma once

#include <array>
#include <span>
#include <string>

#include "nacre/spectra/spectrum.h"

// From spectra to colours. CIE 1931 (2 deg) and 1964 (10 deg) observers; the perfect diffuser has
// Y = 100 in XYZ meant for CIELAB and Y = 1 in linear RGB.

namespace nacre::spectra {

using Vec3 = std::array<double, 3>;  // X Y Z, or L* a* b*, or R G B

enum class Observer { cie1931_2deg, cie1964_10deg };
enum class Illuminant { A, D50, D65, FL2, FL11, E };

/// Colour-matching functions at a wavelength, linear between 5 nm samples, zero outside 360-830.
Vec3 colour_matching(Observer observer, double wavelength_nm);
/// Relative spectral power, 100 at 560 nm where the CIE defines it so; zero outside the data.
double illuminant_power(Illuminant illuminant, double wavelength_nm);

Observer parse_observer(const std::string& text);      ///< "2", "10" @throws InputError
Illuminant parse_illuminant(const std::string& text);  ///< "D65" ... @throws InputError

/// XYZ of a reflectance sampled at `wavelengths_nm` (sorted, equal steps), as sums over those
/// samples, normalised so that the perfect diffuser has Y = 100.        [CIE 15:2018, 7.1]
Vec3 reflectance_to_xyz(std::span<const double> wavelengths_nm, std::span<const double> reflectance,
                        Illuminant illuminant, Observer observer);
/// XYZ of the perfect diffuser by the same sums: the white point for CIELAB.
Vec3 white_point(std::span<const double> wavelengths_nm, Illuminant illuminant, Observer observer);

Vec3 xyz_to_lab(const Vec3& xyz, const Vec3& white);
Vec3 lab_to_xyz(const Vec3& lab, const Vec3& white);
/// Y = 1 scale, D65 white, Rec. 709 primaries.                        [IEC 61966-2-1:1999]
Vec3 xyz_to_linear_rec709(const Vec3& xyz);
Vec3 linear_rec709_to_xyz(const Vec3& rgb);
double srgb_encode(double linear);  ///< transfer function, [0, 1] -> [0, 1], odd for negatives
double srgb_decode(double encoded);

/// CIEDE2000 colour difference with kL = kC = kH = 1.         [Sharma, Wu & Dalal 2005, eq. 2-22]
double delta_e_2000(const Vec3& lab1, const Vec3& lab2);

/// A smooth reflectance in [0, 1] whose colour under D65 is the given linear Rec. 709.
/// @throws DomainError if a component is outside [0, 1]
Spectrum reflectance_from_rec709(const Vec3& linear_rgb);

}  // namespace nacre::spectra
