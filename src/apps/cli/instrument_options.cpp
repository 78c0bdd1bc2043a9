#include "apps/cli/instrument_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <set>

#include "apps/cli/options.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/geometry_file.h"
#include "nacre/paint/recipe.h"

namespace nacre::cli {

namespace {

constexpr const char* kDefaultSet = "byk-mac";

std::vector<std::string> set_names() {
    std::vector<std::string> names;
    for (const measure::GeometrySet& set : measure::geometry_sets()) names.push_back(set.name);
    return names;
}

/// Whether a text is meant as geometries rather than as the name of a set: it starts with a digit.
bool looks_like_list(const std::string& text) {
    return !text.empty() && text[0] >= '0' && text[0] <= '9';
}

std::vector<measure::Geometry> parse_list(const std::string& text) {
    std::vector<std::string> names;
    for (const std::string& part : split(text, ',')) {
        // The comma of "45to30,90" separates theta and phi.
        if (!names.empty() && names.back().find("to") != std::string::npos &&
            names.back().find(',') == std::string::npos) {
            names.back() += "," + part;
        } else {
            names.push_back(part);
        }
    }
    std::vector<measure::Geometry> geometries;
    std::set<std::string> seen;
    for (const std::string& name : names) {
        try {
            geometries.push_back(measure::parse_geometry(name));
        } catch (const DomainError& error) {
            throw UsageError(fmt::format("--geometry = {}: {}", text, error.what()));
        }
        if (!seen.insert(geometries.back().name).second) {
            throw UsageError(
                fmt::format("--geometry = {}: {} appears twice", text, geometries.back().name));
        }
    }
    return geometries;
}

measure::Aperture parse_aperture(const std::string& text) {
    const std::vector<std::string> parts = split(text, ',');
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

measure::Conditions InstrumentRequest::conditions() const {
    measure::Conditions conditions;
    conditions.illuminant = illuminant.value_or(conditions.illuminant);
    conditions.observer = observer.value_or(conditions.observer);
    conditions.aperture = aperture.value_or(conditions.aperture);
    return conditions;
}

std::vector<measure::Geometry> InstrumentRequest::geometries_or_default() const {
    return geometries ? *geometries : measure::find_geometry_set(kDefaultSet)->geometries;
}

void add_instrument_options(CLI::App& command, InstrumentOptions& options) {
    command.add_option("--geometry", options.geometry,
                       fmt::format("Set of angles: {}; a TOML file of a set; or a list as in "
                                   "45as15,45as110,45as25az90 [{}]",
                                   fmt::join(set_names(), ", "), kDefaultSet));
    command.add_option("--illuminant", options.illuminant, "A, D50, D65, FL2, FL11 or E [D65]");
    command.add_option("--observer", options.observer, "2 or 10 degrees [10]");
    command.add_option("--aperture", options.aperture,
                       "Half angles of the cones of lamp and detector, deg, as in 2,3; 0 is a "
                       "point [0,0]");
    command.add_option("--wavelength", options.wavelengths,
                       "Vacuum wavelengths in equal steps, nm [those of a solved paint, else "
                       "400:700:10]");
}

std::vector<measure::Geometry> parse_geometries(const std::string& text) {
    if (const measure::GeometrySet* set = measure::find_geometry_set(text)) return set->geometries;
    if (std::filesystem::path(text).extension() == ".toml") {
        return io::read_geometry_set(text).geometries;
    }
    if (looks_like_list(text)) return parse_list(text);
    throw UsageError(fmt::format(
        "--geometry = {}: is no set{}; there are {}; or give a .toml file, or a list as in "
        "45as15,45as110",
        text, did_you_mean(text, set_names()), fmt::join(set_names(), ", ")));
}

InstrumentRequest parse_instrument(const InstrumentOptions& options) {
    InstrumentRequest request;
    if (!options.geometry.empty()) request.geometries = parse_geometries(options.geometry);
    if (!options.illuminant.empty()) {
        request.illuminant =
            parse_word("--illuminant", options.illuminant, spectra::parse_illuminant);
    }
    if (!options.observer.empty()) {
        request.observer = parse_word("--observer", options.observer, spectra::parse_observer);
    }
    if (!options.aperture.empty()) request.aperture = parse_aperture(options.aperture);
    if (!options.wavelengths.empty()) {
        request.wavelengths_nm = parse_wavelengths(options.wavelengths);
    }
    return request;
}

}  // namespace nacre::cli
