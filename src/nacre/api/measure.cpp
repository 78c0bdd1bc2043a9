#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "nacre/api/state.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/io/geometry_file.h"
#include "nacre/io/measurement_file.h"
#include "nacre/montecarlo/reference.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre {

namespace {

/// A setting that is not given is taken from `otherwise`.
measure::Conditions conditions_of(const MeasureSettings& settings,
                                  const measure::Conditions& otherwise = {}) {
    return {settings.illuminant.value_or(otherwise.illuminant),
            settings.observer.value_or(otherwise.observer),
            settings.aperture.value_or(otherwise.aperture)};
}

std::vector<Geometry> or_default(const std::vector<Geometry>& geometries) {
    return geometries.empty() ? measure::find_geometry_set(kDefaultGeometries)->geometries
                              : geometries;
}

/// Keeps the readings of a file that were asked for.
void pick(Measurement& measurement, const std::vector<Geometry>& geometries,
          const std::string& file) {
    std::vector<measure::Reading> picked;
    for (const Geometry& wanted : geometries) {
        const measure::Reading* found = measure::find_reading(measurement, wanted);
        if (!found) {
            throw InputError(fmt::format("{}: has no reading at {}", file, wanted.name));
        }
        picked.push_back(*found);
    }
    measurement.readings = std::move(picked);
}

/// Computes the colours from the spectra for the illuminant and observer that were asked for.
void recolour(Measurement& measurement, const MeasureSettings& settings, const std::string& file) {
    const measure::Conditions conditions = conditions_of(settings, measurement.conditions);
    if (!(conditions.aperture == measurement.conditions.aperture)) {
        throw InputError(fmt::format(
            "{}: was measured with half angles of {} and {} deg; another aperture cannot be "
            "asked for",
            file, measurement.conditions.aperture.lamp_half_angle_deg,
            measurement.conditions.aperture.detector_half_angle_deg));
    }
    if (conditions == measurement.conditions) return;
    for (measure::Reading& reading : measurement.readings) {
        if (reading.reflectance_factor.empty()) {
            throw InputError(fmt::format(
                "{}: {} has no spectrum, so that it cannot be stated under another light", file,
                reading.geometry.name));
        }
        reading = measure::coloured(reading.geometry, measurement.wavelengths_nm,
                                    reading.reflectance_factor, conditions);
    }
    measurement.conditions = conditions;
}

Readings readings_of(const MeasuredColours& colours, const std::vector<Geometry>& geometries,
                     const MeasureSettings& settings, const std::string& file) {
    Measurement measurement = colours.measurement;
    // The colours of spectra can be computed for another illuminant, but not for another aperture:
    // one that is asked for is only a default where the file states none.
    if (settings.aperture && !(*settings.aperture == measurement.conditions.aperture)) {
        measure::Conditions defaults;
        defaults.aperture = *settings.aperture;
        measurement = io::parse_measurement(colours.text, file, defaults, colours.sample);
    }
    if (!settings.wavelengths_nm.empty()) {
        throw InputError(
            fmt::format("{}: was measured at wavelengths of its own; others cannot be "
                        "asked for",
                        file));
    }
    if (measurement.name.empty()) {
        measurement.name = std::filesystem::path(file).stem().string();
    }
    if (!geometries.empty()) pick(measurement, geometries, file);
    recolour(measurement, settings, file);
    return {std::move(measurement)};
}

/// Positions of the geometries by lamp: the views of one lamp share their walks.
std::map<double, std::vector<std::size_t>> by_lamp(const std::vector<Geometry>& all) {
    std::map<double, std::vector<std::size_t>> lamps;
    for (std::size_t i = 0; i < all.size(); ++i) lamps[all[i].theta_i_deg].push_back(i);
    return lamps;
}

/// By the reference's random walk: estimates that are independent of the solver.
Readings estimated(const std::string& name, const paint::Recipe& recipe,
                   const std::vector<Geometry>& geometries, const MeasureSettings& settings,
                   const Progress& progress) {
    const measure::Conditions conditions = conditions_of(settings);
    if (!(conditions.aperture == Aperture{})) {
        throw SettingError("aperture", fmt::format("the model {} reads with points only",
                                                   settings.model->info().name));
    }
    const std::vector<double> nm = settings.wavelengths_nm.empty()
                                       ? spectra::default_wavelengths_nm()
                                       : settings.wavelengths_nm;
    Readings readings;
    readings.measurement = {name, conditions, nm, std::vector<measure::Reading>(geometries.size())};
    readings.standard_error.resize(geometries.size());
    const auto lamps = by_lamp(geometries);
    double done = 0;
    for (const auto& [lamp_deg, positions] : lamps) {
        const std::vector<montecarlo::Direction> incident = {{lamp_deg, 0}};
        std::vector<montecarlo::Direction> outgoing;
        for (std::size_t i : positions) {
            outgoing.push_back({geometries[i].theta_o_deg, geometries[i].phi_deg});
        }
        const auto estimates = montecarlo::reference_brdf(
            recipe, incident, outgoing, nm, {settings.walks, settings.seed, Part::total},
            [&](double fraction) {
                return !progress || progress((done + fraction) / static_cast<double>(lamps.size()));
            });
        done += 1;
        for (std::size_t view = 0; view < positions.size(); ++view) {
            std::vector<double> mean(nm.size()), error(nm.size());
            for (std::size_t i = 0; i < nm.size(); ++i) {
                const Estimate& estimate = estimates[view * nm.size() + i];
                mean[i] = std::numbers::pi * estimate.value;
                error[i] = std::numbers::pi * estimate.standard_error;
            }
            const std::size_t position = positions[view];
            readings.measurement.readings[position] =
                measure::coloured(geometries[position], nm, std::move(mean), conditions);
            readings.standard_error[position] = std::move(error);
        }
    }
    return readings;
}

}  // namespace

std::string Readings::csv() const { return io::measurement_csv(measurement, standard_error); }

std::vector<Geometry> geometries(const std::string& text) {
    if (const measure::GeometrySet* set = measure::find_geometry_set(text)) return set->geometries;
    if (is_stream(text) || std::filesystem::path(text).extension() == ".toml") {
        return io::read_geometry_set(text).geometries;
    }
    if (!text.empty() && text[0] >= '0' && text[0] <= '9') {
        try {
            return measure::parse_geometries(text);
        } catch (const DomainError& error) {
            throw SettingError("geometry", error.what(), text);
        }
    }
    std::vector<std::string> names;
    for (const measure::GeometrySet& set : measure::geometry_sets()) names.push_back(set.name);
    throw SettingError(
        "geometry",
        fmt::format("is no set{}; there are {}; or give a .toml file, or a list as in "
                    "45as15,45as110",
                    did_you_mean(text, names), fmt::join(names, ", ")),
        text);
}

Readings Paint::measure(const std::vector<Geometry>& geometries, const MeasureSettings& settings,
                        const Progress& progress) const {
    if (const auto* colours = std::get_if<MeasuredColours>(&state_->contents)) {
        return readings_of(*colours, geometries, settings, state_->label());
    }
    if (settings.model && settings.model->info().can.estimated_values) {
        return estimated(name(), recipe(), or_default(geometries), settings, progress);
    }
    const PaintBrdf values =
        brdf({.model = settings.model, .wavelengths_nm = settings.wavelengths_nm},
             cancel_only(progress));
    return {measure::measure(name(), values, values.wavelengths_nm(), or_default(geometries),
                             conditions_of(settings), progress)};
}

std::pair<Readings, Readings> measure_alike(const Paint& sample, const Paint& standard,
                                            const std::vector<Geometry>& geometries,
                                            const MeasureSettings& settings,
                                            const Progress& progress) {
    const auto is = [](const Paint& paint, Kind kind) { return paint.kind() == kind; };
    // A measured BRDF leaves the model to the paint beside it.
    const auto settings_for = [&](const Paint& paint, const Paint& other) {
        MeasureSettings own = settings;
        if (is(paint, Kind::measured_brdf) && !is(other, Kind::measured_brdf)) own.model.reset();
        return own;
    };
    if (is(sample, Kind::measured_colours) == is(standard, Kind::measured_colours)) {
        Readings first = sample.measure(geometries, settings_for(sample, standard), progress);
        return {std::move(first),
                standard.measure(geometries, settings_for(standard, sample), progress)};
    }
    const bool standard_was_read = is(standard, Kind::measured_colours);
    const Paint& read = standard_was_read ? standard : sample;
    const Paint& paint = standard_was_read ? sample : standard;
    MeasureSettings own = settings;
    own.wavelengths_nm.clear();  // are the paint's
    Readings colours = read.measure(geometries, own, progress);

    std::vector<Geometry> alike = geometries;
    if (alike.empty()) {
        for (const measure::Reading& r : colours.measurement.readings) alike.push_back(r.geometry);
    }
    own = settings_for(paint, read);
    own.illuminant = colours.measurement.conditions.illuminant;
    own.observer = colours.measurement.conditions.observer;
    own.aperture = colours.measurement.conditions.aperture;
    Readings computed = paint.measure(alike, own, progress);
    if (standard_was_read) return {std::move(computed), std::move(colours)};
    return {std::move(colours), std::move(computed)};
}

}  // namespace nacre
