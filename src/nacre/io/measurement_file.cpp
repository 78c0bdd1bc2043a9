#include "nacre/io/measurement_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/core/version.h"
#include "nacre/io/cgats.h"
#include "nacre/io/colour_agreement.h"
#include "nacre/io/cxf.h"
#include "nacre/io/measurement_columns.h"
#include "nacre/io/measurement_csv.h"
#include "nacre/measure/measurement.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/observer.h"
#include "nacre/spectra/rgb.h"

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

using nlohmann::json;

/// A JSON object and its place in the file, for messages.
class Member {
 public:
    Member(const json& object, std::string place, std::string path)
        : object_(object), place_(std::move(place)), path_(std::move(path)) {
        if (!object_.is_object()) fail("", "must be an object");
    }

    const json* find(const char* key) const {
        const auto found = object_.find(key);
        return found == object_.end() || found->is_null() ? nullptr : &*found;
    }
    const json& require(const char* key) const {
        const json* found = find(key);
        if (!found) fail(key, "is missing");
        return *found;
    }
    std::string text_or(const char* key, std::string fallback) const {
        const json* found = find(key);
        if (!found) return fallback;
        if (!found->is_string()) fail(key, "must be text");
        const std::string text = found->get<std::string>();
        // Which no table holds.
        if (text.find('\0') != std::string::npos) fail(key, "must not hold the character NUL");
        return text;
    }
    std::optional<double> number(const char* key, const Range& range) const {
        const json* found = find(key);
        return found ? std::optional(as_number(*found, key, range)) : std::nullopt;
    }
    std::vector<double> numbers(const char* key, const Range& range, std::size_t max_size) const {
        std::vector<double> values;
        const json* found = find(key);
        if (!found) return values;
        if (!found->is_array() || found->size() > max_size) {
            fail(key, fmt::format("must be an array of at most {} numbers", max_size));
        }
        for (const json& value : *found) values.push_back(as_number(value, key, range));
        return values;
    }
    std::optional<WrittenColour> triple(const char* key, const Range& range) const {
        const std::vector<double> values = numbers(key, range, 3);
        const json* found = find(key);
        if (!found) return std::nullopt;
        if (values.size() != 3) fail(key, "must have three numbers");
        double unit = 1;  // of all three: zeros at the end of one are left out
        for (const json& value : *found) unit = std::min(unit, last_digit(value.dump()));
        return WrittenColour{{values[0], values[1], values[2]}, {unit, unit, unit}};
    }

    const std::string& place() const { return place_; }
    std::string path_of(const std::string& key) const {
        return path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
    }
    [[noreturn]] void fail(const std::string& key, const std::string& why) const {
        throw InputError(fmt::format("{}: {}: {}", place_, path_of(key), why));
    }

 private:
    double as_number(const json& value, const char* key, const Range& range) const {
        const double number = value.is_number() ? value.get<double>() : std::nan("");
        if (!range.contains(number)) {
            fail(key, "must be a number in " + range.text() + ", not " +
                          excerpt(value.dump(-1, ' ', true, json::error_handler_t::replace)));
        }
        return number;
    }

    const json& object_;
    std::string place_, path_;
};

template <class Parse>
auto parsed(const Member& member, const char* key, const std::string& text, const Parse& parse) {
    try {
        return parse(text);
    } catch (const InputError& error) {
        member.fail(key, error.what());
    }
}

measure::Conditions read_conditions(const Member& file, measure::Conditions conditions) {
    if (file.find("illuminant")) {
        conditions.illuminant =
            parsed(file, "illuminant", file.text_or("illuminant", ""), spectra::parse_illuminant);
    }
    if (file.find("observer")) {
        conditions.observer =
            parsed(file, "observer", file.text_or("observer", ""), spectra::parse_observer);
    }
    measure::Aperture& aperture = conditions.aperture;
    aperture.lamp_half_angle_deg = file.number("lamp_half_angle_deg", measure::kHalfAngle)
                                       .value_or(aperture.lamp_half_angle_deg);
    aperture.detector_half_angle_deg = file.number("detector_half_angle_deg", measure::kHalfAngle)
                                           .value_or(aperture.detector_half_angle_deg);
    return conditions;
}

MeasurementRow read_reading(const Member& reading, std::size_t wavelengths) {
    MeasurementRow row;
    row.place = fmt::format("{}: {}: ", reading.place(), reading.path_of(""));
    row.name = reading.text_or("geometry", "");
    row.theta_i_deg = reading.number("theta_i_deg", kMeasuredAngle);
    row.aspecular_deg = reading.number("aspecular_deg", kMeasuredAngle);
    row.theta_o_deg = reading.number("theta_o_deg", kMeasuredAngle);
    row.phi_deg = reading.number("phi_deg", kMeasuredAngle);
    row.reflectance_factor =
        reading.numbers("reflectance_factor", kMeasuredReflectance, kMaxMeasuredWavelengths);
    if (!row.reflectance_factor.empty() && row.reflectance_factor.size() != wavelengths) {
        reading.fail("reflectance_factor", fmt::format("has {} values for {} wavelengths",
                                                       row.reflectance_factor.size(), wavelengths));
    }
    if (const auto xyz = reading.triple("xyz", kMeasuredTristimulus)) {
        row.xyz = xyz->values;
        row.xyz_unit = xyz->unit;
    }
    if (const auto lab = reading.triple("lab", kMeasuredColour)) {
        row.lab = lab->values;
        row.lab_unit = lab->unit;
    }
    return row;
}

}  // namespace

MeasurementFile parse_measurement_json(std::string_view text, const std::string& filename,
                                       const measure::Conditions& defaults) {
    // Nacre's own files need 4; members that others add may be nested deeper.
    constexpr int kMaxDepth = 64;
    if (json_nesting(text) > kMaxDepth) {
        throw InputError(
            fmt::format("{}: lists and objects are nested deeper than {}", filename, kMaxDepth));
    }
    json document;
    try {
        document = json::parse(text);
    } catch (const json::exception& error) {
        throw InputError(fmt::format("{}: {}", filename, error.what()));
    }
    const Member file(document, filename, "");
    if (file.text_or("format", "") != kMeasurementFormat) {
        file.fail("format", fmt::format("must be \"{}\"", kMeasurementFormat));
    }
    const json& version = file.require("format_version");
    if (!version.is_number_integer() || version != kMeasurementFormatVersion) {
        file.fail("format_version", fmt::format("must be {}", kMeasurementFormatVersion));
    }
    const std::vector<double> wavelengths =
        file.numbers("wavelengths_nm", kMeasuredWavelength, kMaxMeasuredWavelengths);
    const json& readings = file.require("readings");
    if (!readings.is_array() || readings.empty() || readings.size() > kMaxReadings) {
        file.fail("readings", fmt::format("must be an array of 1 to {} objects", kMaxReadings));
    }
    std::vector<MeasurementRow> rows;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        rows.push_back(read_reading(Member(readings[i], filename, fmt::format("readings[{}]", i)),
                                    wavelengths.size()));
    }
    ColourAgreement agreement;
    const measure::Conditions conditions = read_conditions(file, defaults);
    MeasurementFile read{{assemble_measurement(file.text_or("sample", ""), conditions, wavelengths,
                                               rows, agreement)}};
    if (std::ranges::any_of(rows, states_colour)) {
        if (const auto note = note_of_light(filename, file.find("illuminant") != nullptr,
                                            file.find("observer") != nullptr, conditions)) {
            read.notes.push_back(*note);
        }
    }
    read.contradictions = {agreement.contradictions()};
    return read;
}

json measurement_json(const measure::Measurement& measurement) {
    json readings = json::array();
    for (const measure::Reading& reading : measurement.readings) {
        const measure::Geometry& g = reading.geometry;
        json entry = {{"geometry", g.name},
                      {"theta_i_deg", g.theta_i_deg},
                      {"aspecular_deg", g.aspecular_deg},
                      {"theta_o_deg", g.theta_o_deg},
                      {"phi_deg", g.phi_deg},
                      {"xyz", reading.xyz},
                      {"lab", reading.lab},
                      {"chroma", measure::chroma(reading.lab)},
                      {"hue_deg", measure::hue_deg(reading.lab)},
                      {"chip", spectra::css_colour(measure::srgb_chip(reading.lab))}};
        if (!reading.reflectance_factor.empty()) {
            entry["reflectance_factor"] = reading.reflectance_factor;
        }
        readings.push_back(std::move(entry));
    }
    json document = {
        {"format", kMeasurementFormat},
        {"format_version", kMeasurementFormatVersion},
        {"nacre_version", version()},
        {"sample", measurement.name},
        {"illuminant", spectra::name(measurement.conditions.illuminant)},
        {"observer", spectra::name(measurement.conditions.observer)},
        {"lamp_half_angle_deg", measurement.conditions.aperture.lamp_half_angle_deg},
        {"detector_half_angle_deg", measurement.conditions.aperture.detector_half_angle_deg},
        {"wavelengths_nm", measurement.wavelengths_nm},
        {"readings", std::move(readings)}};
    const auto flop = measure::flop_index(measurement);
    document["flop_index"] = flop ? json(*flop) : json(nullptr);
    const measure::ColourTravel travel = measure::colour_travel(measurement);
    json path = json::array();
    for (const measure::Reading* reading : travel.path) {
        path.push_back(
            {{"geometry", reading->geometry.name}, {"a", reading->lab[1]}, {"b", reading->lab[2]}});
    }
    document["colour_travel"] = {
        {"theta_i_deg", 45}, {"length", travel.length}, {"path", std::move(path)}};
    return document;
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
