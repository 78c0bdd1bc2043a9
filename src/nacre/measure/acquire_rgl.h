#pragma once

#include <string>
#include <vector>

#include "nacre/bsdf/rgl_table.h"
#include "nacre/core/progress.h"
#include "nacre/measure/brdf.h"

// A virtual goniophotometer that writes the RGL material database's files: from any BRDF to a
// table in the adaptive parameterization.                                 [dupuy-jakob-2018]

namespace nacre::measure {

struct RglSettings {
    int resolution = 64;       ///< points of the unit square per side, [4, 512]
    int incident = 64;         ///< polar angles of incidence, [2, 256]
    int ndf_resolution = 256;  ///< polar angles of the facets' distribution, [8, 4096]
    bool rgb = false;          ///< linear Rec. 709 instead of a spectrum
};

/// Measures an isotropic surface that is alike on both sides of the plane of incidence, as every
/// one of Nacre's is.
///
/// The distribution of facets D follows from retroreflection, f(m, m) cos(theta_m) =
/// D(m) / (4 sigma(m)) to a factor, with sigma the projected area of D: an eigenvector, found by
/// power iteration [dupuy-jakob-2018, section 5.1]. A fiftieth of it is made even, so that no
/// direction is left without facets. It steers where the table is fine; the values make up for
/// whatever it lacks, and at its nodes the table is exact to single precision.
///
/// Incidences are even from 0 to kMostIncidence. RGB is that of spectra::rec709_weights(), with
/// components outside the gamut cut off at zero.
///
/// @param wavelengths_nm  those of `brdf`, increasing
/// @throws DomainError if a setting is out of range, the table larger than 2 GiB, or the BRDF
/// negative or not finite somewhere
/// @throws Error if `progress` asks to stop
bsdf::RglTable acquire_rgl(const std::string& description, const Brdf& brdf,
                           const std::vector<double>& wavelengths_nm, const RglSettings& settings,
                           const Progress& progress = {});

/// The last incidence; what comes flatter looks like this. In rad: 89 deg.
inline constexpr double kMostIncidence = 1.5533430342749532;

}  // namespace nacre::measure
