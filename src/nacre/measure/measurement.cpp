#include "nacre/measure/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/math.h"

namespace nacre::measure {

namespace {

/// Encoded sRGB of a colour; with keep_hue divided by its largest component if that is above 1.
Vec3d encoded(const Vec3d& lab, bool keep_hue) {
    // CIELAB is relative to the white of the panel's light; on a display white is the display's.
    Vec3d rgb = spectra::lab_to_linear_rec709(lab);
    const double scale = keep_hue ? std::max({rgb[0], rgb[1], rgb[2], 1.0}) : 1.0;
    for (int c = 0; c < 3; ++c) {
        rgb[c] = spectra::srgb_encode(std::clamp(rgb[c] / scale, 0.0, 1.0));
    }
    return rgb;
}

/// Their emission lines fall between samples at 10 nm.
bool has_lines(spectra::Illuminant illuminant) {
    return illuminant == spectra::Illuminant::FL2 || illuminant == spectra::Illuminant::FL11;
}

}  // namespace

double chroma(const Vec3d& lab) { return std::hypot(lab[1], lab[2]); }

double hue_deg(const Vec3d& lab) {
    // The hue of grey would be that of rounding.
    if (chroma(lab) < 1e-9) return 0;
    return wrapped_deg(std::atan2(lab[2], lab[1]) * 180 / std::numbers::pi);
}

Vec3d srgb_chip(const Vec3d& lab) { return encoded(lab, false); }

Vec3d srgb_chip_at_full_light(const Vec3d& lab) { return encoded(lab, true); }

const Reading* Measurement::find(double theta_i_deg, double aspecular_deg) const {
    constexpr double kSame_deg = 1e-6;
    for (const Reading& reading : readings) {
        const Geometry& g = reading.geometry;
        if (is_in_plane(g) && std::abs(g.theta_i_deg - theta_i_deg) <= kSame_deg &&
            std::abs(g.aspecular_deg - aspecular_deg) <= kSame_deg) {
            return &reading;
        }
    }
    return nullptr;
}

const Reading* find_reading(const Measurement& measurement, const Geometry& geometry) {
    const auto far_apart = [](double a_deg, double b_deg) {
        return std::abs(a_deg - b_deg) > kSameGeometry_deg + 1e-9;
    };
    const Reading* nearest = nullptr;
    double nearest_deg = kSameGeometry_deg;
    for (const Reading& reading : measurement.readings) {
        // Quick test by the polar angles, a lower bound: goniometers make many pairs.
        if (far_apart(reading.geometry.theta_i_deg, geometry.theta_i_deg) ||
            far_apart(reading.geometry.theta_o_deg, geometry.theta_o_deg)) {
            continue;
        }
        const double separation = separation_deg(reading.geometry, geometry);
        if (separation <= nearest_deg && (!nearest || separation < nearest_deg)) {
            nearest = &reading;
            nearest_deg = separation;
        }
    }
    return nearest;
}

Vec3d white_point(const std::vector<double>& wavelengths_nm, const Conditions& conditions) {
    return wavelengths_nm.empty() || has_lines(conditions.illuminant)
               ? spectra::white_point(conditions.illuminant, conditions.observer)
               : spectra::white_point(wavelengths_nm, conditions.illuminant, conditions.observer);
}

Reading coloured(Geometry geometry, const std::vector<double>& wavelengths_nm,
                 std::vector<double> reflectance_factor, const Conditions& conditions) {
    Reading reading{std::move(geometry), std::move(reflectance_factor), {}, {}};
    // These sums come first also where those at 5 nm are used: they check the arguments.
    reading.xyz = spectra::reflectance_to_xyz(wavelengths_nm, reading.reflectance_factor,
                                              conditions.illuminant, conditions.observer);
    if (has_lines(conditions.illuminant)) {
        reading.xyz = spectra::reflectance_to_xyz(
            spectra::Spectrum(wavelengths_nm, reading.reflectance_factor), conditions.illuminant,
            conditions.observer);
    }
    reading.lab = spectra::xyz_to_lab(reading.xyz, white_point(wavelengths_nm, conditions));
    return reading;
}

std::optional<double> flop_index(const Measurement& measurement) {
    const Reading* near = measurement.find(45, 15);
    const Reading* face = measurement.find(45, 45);
    const Reading* far = measurement.find(45, 110);
    if (!near || !face || !far) return std::nullopt;
    const double fall = near->lab[0] - far->lab[0], lightness = face->lab[0];
    if (!(fall >= 0 && lightness > 0)) return std::nullopt;
    return 2.69 * std::pow(fall, 1.11) / std::pow(lightness, 0.86);
}

std::optional<std::string> coarse_spectra_warning(const Measurement& measurement) {
    constexpr double kFirst_nm = 420, kLast_nm = 680, kStep_nm = 30;
    const std::vector<double>& nm = measurement.wavelengths_nm;
    if (nm.empty()) return std::nullopt;
    double step = 0;
    for (std::size_t i = 1; i < nm.size(); ++i) step = std::max(step, nm[i] - nm[i - 1]);
    if (nm.front() <= kFirst_nm && nm.back() >= kLast_nm && step <= kStep_nm) return std::nullopt;
    const auto is_of_spectrum = [&](const Reading& reading) {
        return !reading.reflectance_factor.empty() &&
               reading.lab ==
                   coloured({}, nm, reading.reflectance_factor, measurement.conditions).lab;
    };
    if (std::ranges::none_of(measurement.readings, is_of_spectrum)) return std::nullopt;
    return fmt::format(
        "{}: colours of {} from {:g} to {:g} nm may be far from those of the whole "
        "spectrum; 400 to 700 nm in steps of 20 nm or less are enough",
        measurement.name,
        nm.size() == 1 ? "1 wavelength" : fmt::format("{} wavelengths", nm.size()), nm.front(),
        nm.back());
}

ColourTravel colour_travel(const Measurement& measurement, double theta_i_deg) {
    constexpr double kSame_deg = 1e-6;
    ColourTravel travel;
    for (const Reading& reading : measurement.readings) {
        if (is_in_plane(reading.geometry) &&
            std::abs(reading.geometry.theta_i_deg - theta_i_deg) <= kSame_deg) {
            travel.path.push_back(&reading);
        }
    }
    std::stable_sort(travel.path.begin(), travel.path.end(),
                     [](const Reading* a, const Reading* b) {
                         return a->geometry.aspecular_deg < b->geometry.aspecular_deg;
                     });
    for (std::size_t i = 1; i < travel.path.size(); ++i) {
        const Vec3d &from = travel.path[i - 1]->lab, &to = travel.path[i]->lab;
        travel.length += std::hypot(to[1] - from[1], to[2] - from[2]);
    }
    return travel;
}

}  // namespace nacre::measure
