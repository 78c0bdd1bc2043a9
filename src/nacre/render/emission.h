#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/lanes.h"
#include "nacre/spectra/colour.h"
#include "nacre/spectra/spectrum.h"

// The wavelengths of a pass, and their weights in CIE XYZ.

namespace nacre::render {

inline constexpr double kFilmFirst_nm = 400;
inline constexpr double kFilmLast_nm = 700;

/// Eight wavelengths with even spacing, offset as a whole. The offsets of all passes are evenly spaced
/// too, and those of the passes up to any one nearly so, as they follow one another by the golden ratio,
/// or what is next to it of such a lattice: the lines of a lamp have their light in full. All pixels share
/// those of a pass: surfaces are bound to wavelengths once for a whole pass over the picture, and colour
/// noise from the choice of wavelengths is absent.
/// @param pass  in [0, passes)
/// @param passes  >= 1; as many as a picture has in all, or of those that draw from flakes, or of the others
bsdf::Wavelengths film_wavelengths(std::uint32_t pass, std::uint32_t passes);

/// Weights that turn radiance at `wavelengths_nm` into an estimate of X, Y and Z (CIE 1931, 2 deg),
/// such that a constant radiance of 1 has Y = 1 on average.
using XyzWeights = std::array<FloatLanes, 3>;
XyzWeights film_xyz_weights(const bsdf::Wavelengths& wavelengths_nm);

/// Luminance of a spectral radiance on the same scale, by 1 nm steps over the film's range.
double film_luminance(const spectra::Spectrum& radiance);

// Spectra of light. The light of every emitter is a linear combination of a few basis spectra with
// coefficients that depend on direction alone, so a pass evaluates each of them once at its eight
// wavelengths, and a look-up into a sky or a picture costs three multiplications.

/// The basis spectra of one scene.
class EmissionBasis {
 public:
    /// Index of the spectrum; adds it if it is new.
    int add(const spectra::Spectrum& spectrum);
    int size() const { return static_cast<int>(spectra_.size()); }
    const spectra::Spectrum& operator[](int i) const { return spectra_[i]; }
    /// Every spectrum at the wavelengths of a pass.
    std::vector<FloatLanes> at(const bsdf::Wavelengths& wavelengths_nm) const;

 private:
    std::vector<spectra::Spectrum> spectra_;
};

/// An illuminant scaled to luminance 1 on the film.
spectra::Spectrum unit_illuminant(spectra::Illuminant illuminant);

/// Three smooth spectra whose combination R, G, B has, as light, the colour R, G, B in linear
/// Rec. 709: the reflectances of the three primaries under D65. Non-negative, so that any picture
/// without negative values gives light that is nowhere negative.
std::vector<spectra::Spectrum> rec709_light_basis();

/// The basis S0, S1, S2 of the phases of daylight.              [cie-15-2018, table T.2 (10 nm)]
std::vector<spectra::Spectrum> daylight_basis();

}  // namespace nacre::render
