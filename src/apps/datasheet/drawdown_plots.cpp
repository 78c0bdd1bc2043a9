#include "apps/datasheet/drawdown_plots.h"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>

namespace nacre::datasheet {

namespace {

report::Series coefficient(const std::string& name, const fit::PigmentEstimate& estimate,
                           const std::vector<double>& values,
                           const std::vector<std::optional<double>>& errors) {
    report::Series series{.name = name, .x = estimate.wavelengths_nm, .y = values, .dots = true};
    for (const std::optional<double>& error : errors) {
        series.y_error.push_back(error.value_or(std::numeric_limits<double>::infinity()));
    }
    return series;
}

}  // namespace

std::vector<NamedPlot> drawdown_plots(const fit::PigmentEstimate& estimate) {
    report::Plot coefficients{
        .title = "Coefficients of the pigment",
        .caption = "For a volume fraction of 1; bars are standard errors.",
        .x = {.label = "wavelength, nm"},
        .y = {.label = "coefficient, 1/mm", .logarithmic = true},
        .series = {coefficient("scattering", estimate, estimate.scattering_per_mm,
                               estimate.scattering_error),
                   coefficient("absorption", estimate, estimate.absorption_per_mm,
                               estimate.absorption_error)}};
    report::Plot reflectance{.title = "Reflectance of the drawdowns",
                             .caption = "Dots as measured, lines by the coefficients.",
                             .x = {.label = "wavelength, nm"},
                             .y = {.label = "reflectance factor", .lo = 0}};
    for (std::size_t i = 0; i < estimate.residuals.size(); ++i) {
        const fit::DrawdownResidual& r = estimate.residuals[i];
        const std::string colour = report::look_of({}, i).colour;
        reflectance.series.push_back({.name = fmt::format("{}, {:.4g} %{}", r.thickness_text("µm"),
                                                          100 * r.volume_fraction, r.place_text()),
                                      .x = estimate.wavelengths_nm,
                                      .y = r.modelled,
                                      .colour = colour});
        reflectance.series.push_back({.x = estimate.wavelengths_nm,
                                      .y = r.measured,
                                      .colour = colour,
                                      .line = false,
                                      .dots = true});
    }
    return {{"coefficients", std::move(coefficients)}, {"reflectance", std::move(reflectance)}};
}

}  // namespace nacre::datasheet
