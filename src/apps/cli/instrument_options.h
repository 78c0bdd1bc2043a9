#pragma once

#include <string>
#include <vector>

#include "nacre/nacre.h"

namespace CLI {
class App;
}

// --geometry, --illuminant, --observer, --aperture and --wavelength: the instrument that measures a
// paint.

namespace nacre::cli {

/// As the command line has them; empty: not given.
struct InstrumentOptions {
    std::string geometry, illuminant, observer, aperture, wavelengths;
};

/// What they mean. A file of measured values brings its own, so that it matters which were given.
struct InstrumentRequest {
    std::vector<Geometry> geometries;  ///< empty: not given
    MeasureSettings settings;
};

void add_instrument_options(CLI::App& command, InstrumentOptions& options);

/// @throws UsageError, SettingError naming option, value and what is allowed
/// @throws InputError if a file of geometries is wrong
InstrumentRequest parse_instrument(const InstrumentOptions& options);

/// Illuminant and observer, by default where they were not given.
measure::Conditions parse_conditions(const InstrumentOptions& options);

}  // namespace nacre::cli
