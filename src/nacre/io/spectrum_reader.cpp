#include "nacre/io/spectrum_reader.h"

#include "nacre/core/error.h"
#include "nacre/layers/recipe_limits.h"
#include "nacre/spectra/colour.h"

namespace nacre::io {

namespace limits = layers::limits;

std::vector<double> read_wavelengths(const TableReader& table, std::string_view key) {
    std::vector<double> wavelengths =
        table.numbers(key, limits::kWavelength, 1, limits::kSpectrumSamples);
    for (std::size_t i = 1; i < wavelengths.size(); ++i) {
        if (!(wavelengths[i] > wavelengths[i - 1])) {
            table.fail(key, fmt::format("must increase, but {} nm follows {} nm", wavelengths[i],
                                        wavelengths[i - 1]));
        }
    }
    return wavelengths;
}

spectra::Spectrum read_spectrum(const TableReader& table, std::string_view key,
                                const Range& range) {
    if (!table.is_table(key)) return table.number(key, range);
    const TableReader spectrum = table.table(key, {"wavelengths_nm", "values"});
    std::vector<double> wavelengths = read_wavelengths(spectrum, "wavelengths_nm");
    std::vector<double> values = spectrum.numbers("values", range, 1, limits::kSpectrumSamples);
    if (values.size() != wavelengths.size()) {
        spectrum.fail("values", fmt::format("must have as many entries as wavelengths_nm, {}",
                                            wavelengths.size()));
    }
    return {std::move(wavelengths), std::move(values)};
}

spectra::Spectrum read_spectrum_or(const TableReader& table, std::string_view key,
                                   const spectra::Spectrum& fallback, const Range& range) {
    return table.has(key) ? read_spectrum(table, key, range) : fallback;
}

spectra::Spectrum read_reflectance(const TableReader& table, std::string_view key) {
    if (!table.is_array(key)) return read_spectrum(table, key, limits::kFraction);
    const std::vector<double> rgb = table.numbers(key, limits::kFraction, 3, 3);
    return spectra::reflectance_from_rec709({rgb[0], rgb[1], rgb[2]});
}

}  // namespace nacre::io
