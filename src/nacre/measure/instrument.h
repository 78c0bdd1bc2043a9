#pragma once

#include <span>
#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/measure/brdf.h"
#include "nacre/measure/measurement.h"

namespace nacre::measure {

/// Of a reading with finite cones, relative to its greatest value over wavelengths. Rules of
/// growing size over both cones are tried until the last two agree to this; each is exact for
/// polynomials of a far higher degree than the one before, so that the last errs by less.
inline constexpr double kApertureTolerance = 1e-4;

/// Holds a virtual multi-angle spectrophotometer against a surface.
///
/// With an ideal aperture the reflectance factor is pi times the BRDF at the geometry. With finite
/// cones it is what the instrument compares with a perfect diffuser in its place: the mean of
/// pi f over lamp and detector, weighted with cos theta_i cos theta_o over both solid angles
/// [nicodemus-1977, biconical reflectance factor]; rays below the horizon carry nothing.
/// The mirror of a smooth interface is not part of it, as instruments keep away from the gloss.
///
/// @param wavelengths_nm  those of `brdf`, at least two, in equal steps
/// @param progress  asked after each geometry
/// @throws DomainError if an angle or an aperture is out of range
/// @throws Error if `progress` asks to stop, or the largest rule does not reach kApertureTolerance
Measurement measure(const std::string& name, const Brdf& brdf,
                    const std::vector<double>& wavelengths_nm, std::span<const Geometry> geometries,
                    const Conditions& conditions, const Progress& progress = {});

}  // namespace nacre::measure
