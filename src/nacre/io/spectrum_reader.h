#pragma once

#include <string_view>

#include "nacre/core/range.h"
#include "nacre/io/table_reader.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::io {

/// A number, or { wavelengths_nm = [...], values = [...] }; every value in the range.
spectra::Spectrum read_spectrum(const TableReader& table, std::string_view key, const Range& range);
spectra::Spectrum read_spectrum_or(const TableReader& table, std::string_view key,
                                   const spectra::Spectrum& fallback, const Range& range);

/// A reflectance in [0, 1]: a spectrum as above, or [r, g, b] in linear Rec. 709, for which a
/// smooth spectrum of that colour is taken (spectra::reflectance_from_rec709).
spectra::Spectrum read_reflectance(const TableReader& table, std::string_view key);

/// Wavelengths in nm that increase from each to the next.
std::vector<double> read_wavelengths(const TableReader& table, std::string_view key);

}  // namespace nacre::io
