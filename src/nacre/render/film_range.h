#pragma once

#include <array>
#include <cstdint>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/lanes.h"
#include "nacre/spectra/spectrum.h"

// The wavelengths at which the film looks, and what they mean to the eye.

namespace nacre::render {

inline constexpr double kFilmFirstNm = 400;
inline constexpr double kFilmLastNm = 700;

/// Eight wavelengths with even spacing, offset as a whole by a golden-ratio sequence over the
/// sample index. All pixels share those of a sample: surfaces are bound to wavelengths once for a
/// whole pass over the picture, and colour noise from the choice of wavelengths is absent.
bsdf::Wavelengths film_wavelengths(std::uint32_t sample_index);

/// Weights that turn radiance at `wavelengths_nm` into an estimate of X, Y and Z (CIE 1931, 2 deg),
/// such that a constant radiance of 1 has Y = 1 on average.
using XyzWeights = std::array<FloatLanes, 3>;
XyzWeights film_xyz_weights(const bsdf::Wavelengths& wavelengths_nm);

/// Luminance of a spectral radiance on the same scale, by 1 nm steps over the film's range.
double film_luminance(const spectra::Spectrum& radiance);

}  // namespace nacre::render
