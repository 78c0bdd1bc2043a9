#include "apps/cli/instrument_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "apps/cli/options.h"
#include "nacre/core/error.h"
#include "nacre/paint/recipe.h"

namespace nacre::cli {

namespace {

std::vector<std::string> set_names() {
    std::vector<std::string> names;
    for (const measure::GeometrySet& set : measure::geometry_sets()) names.push_back(set.name);
    return names;
}

measure::Aperture parse_aperture(const std::string& text) {
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() != 2) {
        throw UsageError(fmt::format(
            "--aperture = {}: must be the half angles of lamp and detector, as in 2,3", text));
    }
    return {parse_number("--aperture", parts[0], measure::kHalfAngle),
            parse_number("--aperture", parts[1], measure::kHalfAngle)};
}

std::vector<double> parse_wavelengths(const std::string& text) {
    std::vector<double> nm = parse_numbers("--wavelength", text, paint::limits::kWavelength);
    const double step = nm.size() > 1 ? nm[1] - nm[0] : 0;
    bool equal = step > 0;
    for (std::size_t i = 1; i < nm.size(); ++i) {
        equal = equal && std::abs(nm[i] - nm[i - 1] - step) < 1e-6 * step;
    }
    if (!equal) {
        throw UsageError(fmt::format(
            "--wavelength = {}: must be at least two that increase in equal steps, as in "
            "380:780:5",
            text));
    }
    return nm;
}

template <class Parse>
auto parse_word(const char* option, const std::string& text, const Parse& parse) {
    try {
        return parse(text);
    } catch (const InputError& error) {
        throw UsageError(fmt::format("{} = {}: {}", option, text, error.what()));
    }
}

}  // namespace

void add_instrument_options(CLI::App& command, InstrumentOptions& options) {
    command.add_option("--geometry", options.geometry,
                       fmt::format("Set of angles: {}; a TOML file of a set; or a list as in "
                                   "45as15,45as110,45as25az90 [{}]",
                                   fmt::join(set_names(), ", "), kDefaultGeometries));
    command.add_option("--illuminant", options.illuminant, "A, D50, D65, FL2, FL11 or E [D65]");
    command.add_option("--observer", options.observer, "2 or 10 degrees [10]");
    command.add_option("--aperture", options.aperture,
                       "Half angles of the cones of lamp and detector, deg, as in 2,3; 0 is a "
                       "point [0,0]");
    command.add_option("--wavelength", options.wavelengths,
                       "Vacuum wavelengths in equal steps, nm [those of a solved paint, else "
                       "400:700:10]");
}

InstrumentRequest parse_instrument(const InstrumentOptions& options) {
    InstrumentRequest request;
    MeasureSettings& settings = request.settings;
    if (!options.geometry.empty()) request.geometries = geometries(options.geometry);
    if (!options.illuminant.empty()) {
        settings.illuminant =
            parse_word("--illuminant", options.illuminant, spectra::parse_illuminant);
    }
    if (!options.observer.empty()) {
        settings.observer = parse_word("--observer", options.observer, spectra::parse_observer);
    }
    if (!options.aperture.empty()) settings.aperture = parse_aperture(options.aperture);
    if (!options.wavelengths.empty()) {
        settings.wavelengths_nm = parse_wavelengths(options.wavelengths);
    }
    return request;
}

measure::Conditions parse_conditions(const InstrumentOptions& options) {
    const MeasureSettings settings = parse_instrument(options).settings;
    measure::Conditions conditions;
    conditions.illuminant = settings.illuminant.value_or(conditions.illuminant);
    conditions.observer = settings.observer.value_or(conditions.observer);
    return conditions;
}

}  // namespace nacre::cli
