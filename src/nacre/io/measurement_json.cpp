#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/core/version.h"
#include "nacre/io/colour_agreement.h"
#include "nacre/io/measurement_columns.h"
#include "nacre/io/measurement_file.h"
#include "nacre/measure/measurement.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/observer.h"
#include "nacre/spectra/rgb.h"

// The JSON of io/measurement_file.h.

namespace nacre::io {
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

}  // namespace nacre::io
