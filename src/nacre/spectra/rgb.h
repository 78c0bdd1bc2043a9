#pragma once

#include <array>
#include <vector>

#include "nacre/spectra/observer.h"
#include "nacre/spectra/spectrum.h"

// RGB with the primaries of Rec. 709 and the white D65, x = 0.3127, y = 0.3290, as in sRGB.
// XYZ here has Y = 1 at white: divide what reflectance_to_xyz gives by 100.

namespace nacre::spectra {

/// Chromaticities x, y.                                              [iec-61966-2-1-1999]
inline constexpr double kRec709Primaries[3][2] = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
inline constexpr double kRec709White[2] = {0.3127, 0.3290};

/// The matrices follow from the chromaticities above in double precision; those printed in the
/// standard are rounded to four digits and are no inverses of each other. Nothing is clamped:
/// colours outside the gamut have negative components.
Vec3d xyz_to_linear_rec709(const Vec3d& xyz);
Vec3d linear_rec709_to_xyz(const Vec3d& rgb);

/// Y of linear Rec. 709 by the four digits of the recommendation.       [itu-bt-709-2015]
template <class T>
constexpr T rec709_luminance(T r, T g, T b) {
    return static_cast<T>(0.2126) * r + static_cast<T>(0.7152) * g + static_cast<T>(0.0722) * b;
}

/// XYZ of what looks, to an eye adapted to one white, as `xyz` looks to an eye adapted to another:
/// the transform of Bradford, which scales sharpened responses of the cones. [icc-1-2022, annex E.3]
/// @param from, to  XYZ of the whites
/// @throws DomainError unless every component of the whites is positive
Vec3d adapted(const Vec3d& xyz, const Vec3d& from, const Vec3d& to);

/// Primaries of displays, all with the white D65 and, in pictures, sRGB's transfer function.
enum class Gamut {
    rec709,      ///< sRGB
    display_p3,  ///< those of DCI-P3                                  [smpte-eg-432-1-2010]
    rec2020      ///< those of ultra-high-definition television        [itu-bt-2020-2015]
};

/// The same light by other primaries; rec709 leaves it as it is.
Vec3d rec709_to(Gamut gamut, const Vec3d& linear_rec709);
Vec3d to_rec709(Gamut gamut, const Vec3d& linear);

/// Chromaticities x, y of red, green and blue.
const double (&primaries(Gamut gamut))[3][2];

/// Transfer function of sRGB, [0, 1] -> [0, 1], odd for negative values.
/// [iec-61966-2-1-1999]
/// The standard's rounded constants leave a step of 3e-8 where its two branches meet.
double srgb_encode(double linear);
double srgb_decode(double encoded);

/// Linear Rec. 709 in single precision, as pictures and tables hold it.
using Rgb = Vec3f;

// Colour and spectrum as linear maps of each other, for data that exist in RGB only.

/// Weights of the samples of a reflectance in its colour, linear Rec. 709 under D65 for the 2
/// degree observer: a reflectance that is linear between its samples, and constant beyond the first
/// and the last, has the colour rgb = sum_i weights[i] reflectance[i], by the sums over 360-780 nm
/// at 5 nm of reflectance_to_xyz(). Colours are relative to the white of that sum: reflectance 1
/// has (1, 1, 1), to rounding.
/// @throws DomainError unless the wavelengths are finite and strictly increase, at least one
std::vector<Vec3d> rec709_weights(const std::vector<double>& wavelengths_nm);

/// Three smooth spectra b_j >= 0 from 360 to 780 nm, red, green and blue, with b_1 + b_2 + b_3 = 1,
/// whose colours under D65 are the units of linear Rec. 709. So
///
///     rgb -> sum_j rgb_j b_j
///
/// is linear, gives back the same colour by rec709_weights() to kRec709BasisError per unit of the
/// components, turns greys into constants, and colours within [0, 1] into reflectances within
/// [0, 1]. Of all such triples on a grid of 10 nm it has the least sum of squared slopes.
///                                                               [mallett-yuksel-2019]
/// Colours outside the gamut have spectra that may be negative somewhere. The product of two such
/// spectra does not have the product of their colours. The table is data/rec709_basis.csv as it was
/// when this was compiled.
const std::array<Spectrum, 3>& linear_rec709_basis();

inline constexpr double kRec709BasisError = 1e-12;

/// "#rrggbb" of a colour encoded as sRGB, components in [0, 1]; what lies outside is clipped, NaN
/// to 0. From linear Rec. 709, encode first: srgb_encode.
std::string css_colour(const Vec3d& srgb);

}  // namespace nacre::spectra
