#include "nacre/spectra/xyz.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/spectra/observer.h"

namespace nacre::spectra {
namespace {

void require_equal_steps(std::span<const double> wavelengths_nm) {
    const std::size_t count = wavelengths_nm.size();
    if (count < 2) {
        throw DomainError(fmt::format("a colour needs at least 2 wavelengths, {} given", count));
    }
    const double step = (wavelengths_nm[count - 1] - wavelengths_nm[0]) / (count - 1.0);
    if (!(std::isfinite(step) && step > 0)) {
        throw DomainError(fmt::format("wavelengths from {} to {} nm do not increase",
                                      wavelengths_nm[0], wavelengths_nm[count - 1]));
    }
    for (std::size_t i = 1; i < count; ++i) {
        const double expected = wavelengths_nm[0] + step * static_cast<double>(i);
        if (!(std::abs(wavelengths_nm[i] - expected) < 1e-6 * step * static_cast<double>(count))) {
            throw DomainError(
                fmt::format("wavelengths have unequal steps: {} nm follows {} nm, "
                            "the mean step being {} nm",
                            wavelengths_nm[i], wavelengths_nm[i - 1], step));
        }
    }
}

}  // namespace

Vec3d reflectance_to_xyz(std::span<const double> wavelengths_nm,
                         std::span<const double> reflectance, Illuminant illuminant,
                         Observer observer) {
    require_equal_steps(wavelengths_nm);
    if (reflectance.size() != wavelengths_nm.size()) {
        throw DomainError(fmt::format("{} reflectances are given for {} wavelengths",
                                      reflectance.size(), wavelengths_nm.size()));
    }
    Vec3d sum{};
    double white = 0;
    for (std::size_t i = 0; i < reflectance.size(); ++i) {
        if (!std::isfinite(reflectance[i])) {
            throw DomainError(fmt::format("the reflectance at {} nm is not finite: {}",
                                          wavelengths_nm[i], reflectance[i]));
        }
        const double power = illuminant_power(illuminant, wavelengths_nm[i]);
        const Vec3d matching = colour_matching(observer, wavelengths_nm[i]);
        for (int c = 0; c < 3; ++c) sum[c] += power * matching[c] * reflectance[i];
        white += power * matching[1];
    }
    if (!(white > 0)) {
        throw DomainError(fmt::format("no light is seen at any of the wavelengths from {} to {} nm",
                                      wavelengths_nm.front(), wavelengths_nm.back()));
    }
    return (100 / white) * sum;
}

Vec3d white_point(std::span<const double> wavelengths_nm, Illuminant illuminant,
                  Observer observer) {
    const std::vector<double> ones(wavelengths_nm.size(), 1.0);
    return reflectance_to_xyz(wavelengths_nm, ones, illuminant, observer);
}

Vec3d reflectance_to_xyz(const Spectrum& reflectance, Illuminant illuminant, Observer observer) {
    std::array<double, kIlluminantRows> wavelengths_nm, values;
    for (int i = 0; i < kIlluminantRows; ++i) {
        wavelengths_nm[i] = kIlluminantTable[i].wavelength_nm;
        values[i] = reflectance(wavelengths_nm[i]);
    }
    return reflectance_to_xyz(wavelengths_nm, values, illuminant, observer);
}

Vec3d white_point(Illuminant illuminant, Observer observer) {
    return reflectance_to_xyz(Spectrum(1.0), illuminant, observer);
}

}  // namespace nacre::spectra
