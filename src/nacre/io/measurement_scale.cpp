#include "nacre/io/measurement_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/measure/geometry.h"
#include "nacre/spectra/lab.h"

namespace nacre::io {

namespace {

constexpr double kFarFromGloss_deg = 45;

double largest_of(const MeasurementRow& row) {
    return *std::max_element(row.reflectance_factor.begin(), row.reflectance_factor.end());
}

bool is_far_from_gloss(const MeasurementRow& row) {
    if (row.aspecular_deg) return std::abs(*row.aspecular_deg) >= kFarFromGloss_deg;
    try {
        return std::abs(measure::parse_geometry(row.name).aspecular_deg) >= kFarFromGloss_deg;
    } catch (const DomainError&) {
        return false;
    }
}

/// Delta E 2000 between the colour that a row states and that of its spectrum.
double colour_error(const MeasurementRow& row, double scale,
                    const std::vector<double>& wavelengths_nm,
                    const measure::Conditions& conditions) {
    std::vector<double> factors = row.reflectance_factor;
    for (double& value : factors) value *= scale;
    const Vec3d stated =
        row.lab ? *row.lab
                : spectra::xyz_to_lab(*row.xyz, measure::white_point(wavelengths_nm, conditions));
    return spectra::delta_e_2000(
        stated, measure::coloured({}, wavelengths_nm, std::move(factors), conditions).lab);
}

}  // namespace

MeasurementScale measurement_scale(const std::vector<MeasurementRow>& rows,
                                   const std::vector<double>& wavelengths_nm,
                                   const measure::Conditions& conditions,
                                   const std::string& filename) {
    const MeasurementRow* brightest = nullptr;  // of those with a colour
    double most = 0, max_far = 0, least = INFINITY;
    for (const MeasurementRow& row : rows) {
        if (row.reflectance_factor.empty()) continue;
        const double largest = largest_of(row);
        most = std::max(most, largest);
        if (is_far_from_gloss(row)) max_far = std::max(max_far, largest);
        least = std::min(
            least, *std::min_element(row.reflectance_factor.begin(), row.reflectance_factor.end()));
        if (states_colour(row) && (!brightest || largest > largest_of(*brightest)))
            brightest = &row;
    }
    const std::string percent =
        fmt::format("{}: reflectances of up to {:.4g} are taken as percent", filename, most);
    if (brightest) {
        try {
            const auto error_at = [&](double scale) {
                return colour_error(*brightest, scale, wavelengths_nm, conditions);
            };
            const double as_factors = error_at(1), as_percent = error_at(0.01);
            if (as_factors <= kMaxColourError) return {};
            if (as_percent <= kMaxColourError) {
                return {true, percent + ", as the colours beside them say"};
            }
            // Under another light than theirs the colours agree with neither, but less with the wrong one.
            constexpr double kFarther = 2;
            if (kFarther * as_factors < as_percent) return {};
            if (kFarther * as_percent < as_factors) {
                return {true, percent + ", to which the colours beside them are nearer"};
            }
        } catch (const DomainError&) {
            return {};  // wavelengths that are no grid: whoever reads the rows says so
        }
    }
    if (max_far > kMaxFactorFarFromGloss || most > kMaxFactor) {
        return {true, percent + "; write R400 [1] in the header where they are factors"};
    }
    if (most <= kMaxFactorFarFromGloss || least < kMinPercent) return {};
    throw InputError(
        fmt::format("{}: reflectances from {:.4g} to {:.4g} may be factors, of which 1 is the "
                    "perfect diffuser, "
                    "or percent; call the columns R400 [%] or R400 [1], or add L, a and b",
                    filename, least, most));
}

}  // namespace nacre::io
