#include "nacre/io/measurement_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "nacre/core/error.h"
#include "nacre/optics/number_text.h"
#include "nacre/spectra/delta_e.h"
#include "nacre/spectra/lab.h"

namespace nacre::io {

namespace {

// Exporters round angles to a tenth of a degree.
constexpr double kSameAngle_deg = 0.1;
// What tables of weights and intervals make of the same spectrum differs by less than 1, a wrong
// light or scale makes far more.
constexpr double kMostColourError = 5;

[[noreturn]] void fail(const MeasurementRow& row, const std::string& why) {
    throw InputError(row.place + why);
}

std::optional<measure::Geometry> named_geometry(const std::string& name) {
    if (name.empty()) return std::nullopt;
    try {
        return measure::parse_geometry(name);
    } catch (const DomainError&) {
        return std::nullopt;  // a label of somebody's own
    }
}

void require_agreement(const MeasurementRow& row, const char* key,
                       const std::optional<double>& stated, double found) {
    if (stated && !(std::abs(*stated - found) <= kSameAngle_deg)) {
        fail(row, fmt::format("{} = {}: contradicts the geometry '{}', for which it is {:.6g}", key,
                              *stated, optics::excerpt(row.name), found));
    }
}

/// From the directions themselves.
measure::Geometry by_directions(const MeasurementRow& row) {
    if (*row.theta_o_deg != 0 && !row.phi_deg) fail(row, "phi: is missing beside theta_o");
    measure::Geometry geometry =
        measure::towards(*row.theta_i_deg, *row.theta_o_deg, row.phi_deg.value_or(180));
    if (row.aspecular_deg) {
        require_agreement(row, "aspecular_deg", row.aspecular_deg, geometry.aspecular_deg);
        geometry.aspecular_deg = *row.aspecular_deg;  // with the digits that the file has
    }
    if (const auto named = named_geometry(row.name)) {
        const double separation = measure::separation_deg(*named, geometry);
        if (separation > kSameAngle_deg) {
            fail(row, fmt::format("geometry = {}: is {:.3g} deg off theta_i, theta_o and phi",
                                  optics::excerpt(row.name), separation));
        }
    }
    return geometry;
}

measure::Geometry geometry_of(const MeasurementRow& row) {
    measure::Geometry geometry;
    try {
        if (row.theta_i_deg && row.theta_o_deg) {
            geometry = by_directions(row);
        } else if (const auto named = named_geometry(row.name)) {
            require_agreement(row, "theta_i", row.theta_i_deg, named->theta_i_deg);
            require_agreement(row, "aspecular_deg", row.aspecular_deg, named->aspecular_deg);
            geometry = *named;
        } else if (row.theta_i_deg && row.aspecular_deg) {
            geometry = measure::in_plane(*row.theta_i_deg, *row.aspecular_deg);
        } else if (!row.name.empty()) {
            measure::parse_geometry(row.name);  // says what a name looks like
        } else {
            fail(row,
                 "geometry: is missing; either its name or theta_i and aspecular_deg are "
                 "needed");
        }
    } catch (const DomainError& error) {
        fail(row, error.what());
    }
    if (!row.name.empty()) geometry.name = row.name;
    return geometry;
}

measure::Reading reading_of(const MeasurementRow& row, const std::vector<double>& wavelengths_nm,
                            const measure::Conditions& conditions) {
    measure::Reading reading;
    const spectra::Vec3 white = measure::white_point(
        row.reflectance_factor.empty() ? std::vector<double>{} : wavelengths_nm, conditions);
    if (!row.reflectance_factor.empty()) {
        reading = measure::coloured({}, wavelengths_nm, row.reflectance_factor, conditions);
        const double error = row.lab ? spectra::delta_e_2000(*row.lab, reading.lab) : 0;
        if (!(error <= kMostColourError)) {
            fail(row,
                 fmt::format("L = {}, a = {}, b = {}: differ from those of the spectrum under the "
                             "stated light, {:.2f}, {:.2f}, {:.2f}, by Delta E 2000 = {:.1f}; "
                             "reflectance must be a factor, of which 1 is the perfect diffuser",
                             (*row.lab)[0], (*row.lab)[1], (*row.lab)[2], reading.lab[0],
                             reading.lab[1], reading.lab[2], error));
        }
    } else if (!row.lab && !row.xyz) {
        fail(row, "no colour: L, a, b, or X, Y, Z, or a spectrum is needed");
    }
    if (row.lab) {
        reading.lab = *row.lab;
        reading.xyz = row.xyz ? *row.xyz : spectra::lab_to_xyz(*row.lab, white);
    } else if (row.reflectance_factor.empty()) {
        reading.xyz = *row.xyz;
        reading.lab = spectra::xyz_to_lab(*row.xyz, white);
    }
    for (int c = 0; c < 3; ++c) {  // what was computed must be readable again
        if (!kMeasuredColour.contains(reading.lab[c]) ||
            !kMeasuredTristimulus.contains(reading.xyz[c])) {
            fail(row, fmt::format("the colour, X = {:.3g}, Y = {:.3g}, Z = {:.3g}, is out of range",
                                  reading.xyz[0], reading.xyz[1], reading.xyz[2]));
        }
    }
    reading.geometry = geometry_of(row);
    return reading;
}

}  // namespace

measure::Measurement assemble_measurement(std::string name, const measure::Conditions& conditions,
                                          std::vector<double> wavelengths_nm,
                                          const std::vector<MeasurementRow>& rows) {
    measure::Measurement measurement{std::move(name), conditions, {}, {}};
    std::set<std::tuple<double, double, double>> seen;
    bool has_spectra = false;
    for (const MeasurementRow& row : rows) {
        try {
            measurement.readings.push_back(reading_of(row, wavelengths_nm, conditions));
        } catch (const DomainError& error) {  // wavelengths that are no grid
            fail(row, error.what());
        }
        const measure::Reading& reading = measurement.readings.back();
        const measure::Geometry& g = reading.geometry;
        if (!seen.insert({g.theta_i_deg, g.theta_o_deg, g.phi_deg}).second) {
            fail(row, fmt::format("geometry = {}: has been read before", optics::excerpt(g.name)));
        }
        has_spectra = has_spectra || !reading.reflectance_factor.empty();
    }
    if (has_spectra) measurement.wavelengths_nm = std::move(wavelengths_nm);
    return measurement;
}

}  // namespace nacre::io
