#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "nacre/measure/geometry.h"
#include "nacre/measure/measurement.h"

namespace CLI {
class App;
}

// --geometry, --illuminant, --observer and --aperture: how an instrument is held against a paint.

namespace nacre::cli {

/// As the command line has them; empty: not given.
struct InstrumentOptions {
    std::string geometry, illuminant, observer, aperture, wavelengths;
};

/// What they mean. A file of measured values brings its own, so that it matters which were given.
struct InstrumentRequest {
    std::optional<std::vector<measure::Geometry>> geometries;
    std::optional<spectra::Illuminant> illuminant;
    std::optional<spectra::Observer> observer;
    std::optional<measure::Aperture> aperture;
    std::optional<std::vector<double>> wavelengths_nm;
    std::uint64_t walks = std::uint64_t{1} << 18;  ///< per lamp, of the model walk

    /// With those that were not given as they are by default.
    measure::Conditions conditions() const;
    /// byk-mac by default.
    std::vector<measure::Geometry> geometries_or_default() const;
};

void add_instrument_options(CLI::App& command, InstrumentOptions& options);

/// @throws UsageError naming option, value and what is allowed
/// @throws InputError if a file of geometries is wrong
InstrumentRequest parse_instrument(const InstrumentOptions& options);

/// A set that is built in, a file of a set, or a list as in 45as15,45as25az90,45to30,90.
/// @throws as parse_instrument()
std::vector<measure::Geometry> parse_geometries(const std::string& text);

}  // namespace nacre::cli
