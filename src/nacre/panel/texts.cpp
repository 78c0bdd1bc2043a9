#include "nacre/panel/texts.h"

#include <fmt/format.h>

#include "nacre/spectra/names.h"

namespace nacre::panel {

namespace {

std::string with_minus_sign(std::string text) {
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return text;
}

}  // namespace

std::string degrees_text(double angle_deg) {
    return with_minus_sign(fmt::format("{:.4g}°", angle_deg));
}

std::string decimal_text(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    // What rounds to zero has no sign.
    if (text.find_first_not_of("-0.") == std::string::npos && text.starts_with('-'))
        text.erase(0, 1);
    return with_minus_sign(text);
}

std::string conditions_text(const measure::Conditions& conditions) {
    const measure::Aperture& aperture = conditions.aperture;
    const std::string apertures =
        aperture == measure::Aperture{}
            ? "point apertures"
            : fmt::format("cones of half angle {} (lamp) and {} (detector)",
                          degrees_text(aperture.lamp_half_angle_deg),
                          degrees_text(aperture.detector_half_angle_deg));
    return fmt::format("illuminant {}, {}° observer, {}", spectra::name(conditions.illuminant),
                       spectra::name(conditions.observer), apertures);
}

}  // namespace nacre::panel
