#pragma once

#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/measure/brdf.h"

namespace nacre::measure {

/// How a table of a BRDF differs from what it was made of, over incidences from 5 to 80 deg.
struct TableError {
    double flux = 0;  ///< Int |f' - f| cos over Int f cos, mean over incidences and wavelengths
    /// Largest |f' - f| cos over the largest f cos of its incidence and wavelength. The cosine is
    /// that of what such tables hold: near the horizon f itself is its quotient, and uncertain.
    double peak = 0;
};

/// Compared at eight of the wavelengths, at directions that the table itself draws and therefore
/// finds important, off its nodes.
/// @param rgb  the table holds colours: compared with the spectra of the exact ones
/// @throws DomainError as SpectrumColour
TableError table_error(const bsdf::Bsdf& table, const Brdf& exact,
                       const std::vector<double>& wavelengths_nm, bool rgb);

}  // namespace nacre::measure
