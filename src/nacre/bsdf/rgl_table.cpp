#include "nacre/bsdf/rgl_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/range.h"

namespace nacre::bsdf {

namespace {

void require_size(const char* field, std::size_t found, std::size_t wanted) {
    if (found != wanted) {
        throw DomainError(fmt::format("{} has {} values, not {}", field, found, wanted));
    }
}

void require_values(const char* field, const std::vector<float>& values, const Range& range) {
    const auto wrong =
        std::find_if(values.begin(), values.end(), [&](float v) { return !range.contains(v); });
    if (wrong != values.end()) {
        throw DomainError(fmt::format("{}[{}] = {}: must be a number in {}", field,
                                      wrong - values.begin(), *wrong, range.text()));
    }
}

void require_increasing(const char* field, const std::vector<float>& values, const Range& range) {
    if (values.empty()) throw DomainError(fmt::format("{} is empty", field));
    require_values(field, values, range);
    const auto wrong = std::adjacent_find(values.begin(), values.end(), std::greater_equal<>());
    if (wrong != values.end()) {
        throw DomainError(fmt::format("{}[{}] = {} follows {}: the values must increase", field,
                                      wrong - values.begin() + 1, *(wrong + 1), *wrong));
    }
}

void require_sides(const char* field, int rows, int columns) {
    if (rows < 2 || columns < 2) {
        throw DomainError(
            fmt::format("{} has {} x {} values: must have 2 x 2 or more", field, rows, columns));
    }
}

std::size_t cells(int rows, int columns) { return static_cast<std::size_t>(rows) * columns; }

void validate_square(const char* field, const SquareTable& table, const Range& range) {
    require_sides(field, table.rows, table.columns);
    require_size(field, table.values.size(), cells(table.rows, table.columns));
    require_values(field, table.values, range);
}

}  // namespace

void validate(const RglTable& table) {
    // Products of these, over the least cosine, are still finite in single precision.
    constexpr float kLargest = 1e9f, kPi = std::numbers::pi_v<float>;
    constexpr Range kDensity{0, kLargest}, kAny{-kLargest, kLargest};
    // Files hold 90 and 180 deg as rounded floats.
    constexpr Range kTheta{0, 0.5 * kPi * 1.00001, "rad"},
        kPhi{-kPi * 2.00001, kPi * 2.00001, "rad"};
    constexpr float kMostOff = 0.2f;  // rad: a first azimuth half a step inside
    require_increasing("phi_i", table.phi_i, kPhi);
    require_increasing("theta_i", table.theta_i, kTheta);
    if (!table.isotropic()) {
        const float parts = 2 * kPi / (table.phi_i.back() - table.phi_i.front());
        const float whole = std::round(parts);
        if (whole != 1 && whole != 2 && whole != 4) {
            throw DomainError(
                fmt::format("phi_i spans {} rad: an anisotropic surface must have pi/2, pi or 2 pi",
                            table.phi_i.back() - table.phi_i.front()));
        }
        // Incident directions are turned there; a table of others would be read at its edges.
        if (std::abs(table.phi_i.front() + kPi) > kMostOff) {
            throw DomainError(fmt::format(
                "phi_i begins at {} rad: those of an anisotropic surface must begin at -pi",
                table.phi_i.front()));
        }
    }
    validate_square("ndf", table.ndf, kDensity);
    validate_square("sigma", table.sigma, Range{1e-9, kLargest});
    require_sides("vndf", table.vndf_rows, table.vndf_columns);
    require_size("vndf", table.vndf.size(),
                 table.slices() * cells(table.vndf_rows, table.vndf_columns));
    require_values("vndf", table.vndf, kDensity);
    require_sides("luminance", table.resolution, table.resolution);
    const std::size_t square = cells(table.resolution, table.resolution);
    require_size("luminance", table.luminance.size(), table.slices() * square);
    require_values("luminance", table.luminance, kDensity);
    if (!table.is_rgb()) {
        if (table.wavelengths.size() > kMostRglWavelengths) {
            throw DomainError(fmt::format("wavelengths has {} values: must have at most {}",
                                          table.wavelengths.size(), kMostRglWavelengths));
        }
        require_increasing("wavelengths", table.wavelengths, Range{1, 1e6, "nm"});
    }
    const char* values = table.is_rgb() ? "rgb" : "spectra";
    require_size(values, table.spectra.size(), table.slices() * table.channels() * square);
    require_values(values, table.spectra, kAny);
}

}  // namespace nacre::bsdf
