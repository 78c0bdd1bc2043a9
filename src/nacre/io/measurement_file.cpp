#include "nacre/io/measurement_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/io/colour_agreement.h"
#include "nacre/io/measurement_columns.h"
#include "nacre/io/measurement_formats.h"
#include "nacre/measure/measurement.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/observer.h"

namespace nacre::io {

namespace {

// Exporters round angles to a tenth of a degree.
constexpr double kSameAngle_deg = 0.1;

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
                              *stated, excerpt(row.name), found));
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
                                  excerpt(row.name), separation));
        }
    }
    return geometry;
}

/// Whether a name says an angle in fewer words than instruments do, so that theirs is given to it.
bool is_shorthand(const std::string& name) {
    return lowercase(name).starts_with("as") || name.find_first_of("/:") != std::string::npos ||
           name.find("\u00b0") != std::string::npos;
}

measure::Geometry geometry_of(const MeasurementRow& row) {
    measure::Geometry geometry;
    std::string name = row.name;
    try {
        if (row.theta_i_deg && row.theta_o_deg) {
            geometry = by_directions(row);
        } else if (const auto named = named_geometry(row.name)) {
            require_agreement(row, "theta_i", row.theta_i_deg, named->theta_i_deg);
            require_agreement(row, "aspecular_deg", row.aspecular_deg, named->aspecular_deg);
            geometry = *named;
            if (is_shorthand(name)) name.clear();
        } else if (const auto angle = parse_number(row.name)) {
            require_agreement(row, "aspecular_deg", row.aspecular_deg, *angle);
            geometry = measure::in_plane(row.theta_i_deg.value_or(measure::kUsualLamp_deg), *angle);
            name.clear();
        } else if (row.theta_i_deg && row.aspecular_deg) {
            geometry = measure::in_plane(*row.theta_i_deg, *row.aspecular_deg);
        } else if (!row.name.empty()) {
            measure::parse_geometry(row.name);  // says what a name looks like
        } else {
            fail(row,
                 "geometry: is missing; a column of angles is needed (geometry: 45as15 or 15), or "
                 "theta_i and aspecular_deg, or the angle in each name (L 15, a 15, b 15)");
        }
    } catch (const DomainError& error) {
        fail(row, error.what());
    }
    if (!name.empty()) geometry.name = name;
    return geometry;
}

measure::Reading reading_of(const MeasurementRow& row, const std::vector<double>& wavelengths_nm,
                            const measure::Conditions& conditions) {
    measure::Reading reading;
    const Vec3d white = measure::white_point(
        row.reflectance_factor.empty() ? std::vector<double>{} : wavelengths_nm, conditions);
    if (!row.reflectance_factor.empty()) {
        reading = measure::coloured({}, wavelengths_nm, row.reflectance_factor, conditions);
        const double error = row.lab ? spectra::delta_e_2000(*row.lab, reading.lab) : 0;
        if (!(error <= kMaxColourError)) {
            fail(row,
                 fmt::format(
                     "L = {}, a = {}, b = {}: differ from those of the spectrum under {} and "
                     "{} degrees, {:.2f}, {:.2f}, {:.2f}, by Delta E 2000 = {:.1f}; illuminant "
                     "and observer must be those of the colours, and reflectance a factor, "
                     "of which 1 is the perfect diffuser",
                     (*row.lab)[0], (*row.lab)[1], (*row.lab)[2],
                     spectra::name(conditions.illuminant), spectra::name(conditions.observer),
                     reading.lab[0], reading.lab[1], reading.lab[2], error));
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

double last_digit(std::string_view text) {
    const std::size_t mark = text.find_first_of(".,"), exponent = text.find_first_of("eE");
    std::size_t decimals = 0;
    if (mark != std::string_view::npos) {
        const std::string_view after = text.substr(mark + 1);
        decimals = std::min(after.find_first_not_of("0123456789"), after.size());
    }
    const double power = exponent == std::string_view::npos
                             ? 0
                             : parse_number(text.substr(exponent + 1)).value_or(0);
    return std::pow(10.0, power - static_cast<double>(decimals));
}

std::optional<std::string> note_of_light(const std::string& filename, bool states_illuminant,
                                         bool states_observer,
                                         const measure::Conditions& conditions) {
    if (states_illuminant && states_observer) return std::nullopt;
    return fmt::format("{}: does not state {}; taken as {} and {} degrees", filename,
                       states_illuminant ? "the observer"
                       : states_observer ? "the illuminant"
                                         : "illuminant and observer",
                       spectra::name(conditions.illuminant), spectra::name(conditions.observer));
}

measure::Measurement assemble_measurement(std::string name, const measure::Conditions& conditions,
                                          std::vector<double> wavelengths_nm,
                                          const std::vector<MeasurementRow>& rows,
                                          ColourAgreement& agreement) {
    measure::Measurement measurement{std::move(name), conditions, {}, {}};
    std::set<std::tuple<double, double, double>> seen;
    bool has_spectra = false;
    for (const MeasurementRow& row : rows) {
        try {
            measurement.readings.push_back(reading_of(row, wavelengths_nm, conditions));
            agreement.check(row, wavelengths_nm, conditions);
        } catch (const DomainError& error) {  // wavelengths that are no grid
            fail(row, error.what());
        }
        const measure::Reading& reading = measurement.readings.back();
        const measure::Geometry& g = reading.geometry;
        if (!seen.insert({g.theta_i_deg, g.theta_o_deg, g.phi_deg}).second) {
            fail(row, fmt::format("geometry = {}: has been read before", excerpt(g.name)));
        }
        has_spectra = has_spectra || !reading.reflectance_factor.empty();
    }
    if (has_spectra) measurement.wavelengths_nm = std::move(wavelengths_nm);
    return measurement;
}

namespace {

bool starts_like_json(std::string_view text) {
    text = without_byte_order_mark(text);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{';
}

}  // namespace

MeasurementFile parse_measurement_file(std::string_view text, const std::string& filename,
                                       const measure::Conditions& defaults) {
    if (starts_like_json(text)) {
        require_utf8(text, filename);
        return parse_measurement_json(text, filename, defaults);
    }
    if (looks_like_cxf(text)) return parse_measurement_cxf(text, filename, defaults);
    return looks_like_cgats(text) ? parse_measurement_cgats(text, filename, defaults)
                                  : parse_measurement_csv(text, filename, defaults);
}

const measure::Measurement& sample_called(const MeasurementFile& file, std::string_view name,
                                          const std::string& filename) {
    constexpr std::size_t kMaxNamed = 12;
    const std::vector<measure::Measurement>& samples = file.samples;
    if (name.empty() && samples.size() == 1) return samples[0];
    std::vector<std::string> names;
    const measure::Measurement* found = nullptr;
    std::size_t count = 0;
    for (const measure::Measurement& sample : samples) {
        names.push_back(sample.name);
        if (name.empty() || sample.name != name) continue;
        found = &sample;
        ++count;
    }
    if (count == 1) return *found;
    const auto number = name.empty() ? std::nullopt : parse_number(name);
    for (std::size_t i = 0; count == 0 && number && i < samples.size(); ++i) {
        if (*number == static_cast<double>(i + 1)) return samples[i];
    }
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kMaxNamed); ++i) {
        list += fmt::format("{}'{}'", i == 0 ? "" : ", ", excerpt(names[i]));
    }
    if (names.size() > kMaxNamed) list += ", ...";
    if (count > 1) {
        throw InputError(
            fmt::format("{}: {} samples are called '{}'; say which by its number, 1 to {}",
                        filename, count, excerpt(name), samples.size()));
    }
    if (name.empty()) {
        throw InputError(fmt::format(
            "{}: holds {} samples: {}; say which, by its name or its number, as in '{}#{}'",
            filename, samples.size(), list, filename, names[0].empty() ? "1" : excerpt(names[0])));
    }
    throw InputError(fmt::format("{}: has no sample '{}'{}, but {}: {}", filename, excerpt(name),
                                 did_you_mean(name, names), samples.size(), list));
}

measure::Measurement parse_measurement(std::string_view text, const std::string& filename,
                                       const measure::Conditions& defaults,
                                       std::string_view sample) {
    return sample_called(parse_measurement_file(text, filename, defaults), sample, filename);
}

SampleName split_sample_name(const std::filesystem::path& name) {
    const std::string text = name.string();
    const auto is_file = [](const std::string& path) {
        std::error_code none;
        const auto status = std::filesystem::status(path, none);
        return std::filesystem::exists(status) && !std::filesystem::is_directory(status);
    };
    if (is_file(text)) return {name, ""};
    std::size_t first = std::string::npos;                   // of the marks with text on both sides
    const std::size_t folders = text.find_last_of('/') + 1;  // 0 where there are none
    for (std::size_t mark = text.size(); mark-- > 1;) {
        if (text[mark] != '#' || mark + 1 == text.size()) continue;
        // A folder may have a mark in its name, and a sample a slash: where no file decides, it is a folder.
        if (mark > folders || first == std::string::npos) first = mark;
        if (is_file(text.substr(0, mark))) {
            first = mark;
            break;
        }
    }
    if (first == std::string::npos) return {name, ""};
    return {text.substr(0, first), text.substr(first + 1)};
}

measure::Measurement read_measurement(const std::filesystem::path& path,
                                      const measure::Conditions& defaults) {
    const SampleName name = split_sample_name(path);
    return parse_measurement(read_file(name.file), name.file.string(), defaults, name.sample);
}

bool looks_like_measurement(std::string_view text) {
    return starts_like_json(text) || looks_like_cxf(text) || looks_like_cgats(text) ||
           find_measurement_header(text);
}

}  // namespace nacre::io
