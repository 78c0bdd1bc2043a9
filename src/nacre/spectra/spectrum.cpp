#include "nacre/spectra/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/core/error.h"

namespace nacre::spectra {

Spectrum::Spectrum(double constant) : Spectrum({0.0}, {constant}) {}

Spectrum::Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values)
    : wavelengths_nm_(std::move(wavelengths_nm)), values_(std::move(values)) {
    if (wavelengths_nm_.size() != values_.size()) {
        throw DomainError(fmt::format("a spectrum has {} wavelengths but {} values",
                                      wavelengths_nm_.size(), values_.size()));
    }
    if (values_.empty()) throw DomainError("a spectrum needs at least one sample");
    for (std::size_t i = 0; i < values_.size(); ++i) {
        if (!std::isfinite(wavelengths_nm_[i]) || !std::isfinite(values_[i])) {
            throw DomainError(fmt::format("sample {} of a spectrum is not finite: {} at {} nm", i,
                                          values_[i], wavelengths_nm_[i]));
        }
        if (i > 0 && wavelengths_nm_[i] <= wavelengths_nm_[i - 1]) {
            throw DomainError(
                fmt::format("the wavelengths of a spectrum must increase: {} nm "
                            "follows {} nm",
                            wavelengths_nm_[i], wavelengths_nm_[i - 1]));
        }
    }
}

double Spectrum::operator()(double wavelength_nm) const {
    if (std::isnan(wavelength_nm)) return std::numeric_limits<double>::quiet_NaN();
    const auto above =
        std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end(), wavelength_nm);
    if (above == wavelengths_nm_.begin()) return values_.front();
    if (above == wavelengths_nm_.end()) return values_.back();
    const auto i = static_cast<std::size_t>(above - wavelengths_nm_.begin());
    const double t =
        (wavelength_nm - wavelengths_nm_[i - 1]) / (wavelengths_nm_[i] - wavelengths_nm_[i - 1]);
    return std::lerp(values_[i - 1], values_[i], t);
}

double Spectrum::min() const { return *std::min_element(values_.begin(), values_.end()); }
double Spectrum::max() const { return *std::max_element(values_.begin(), values_.end()); }

std::vector<double> default_wavelengths_nm() {
    std::vector<double> w;
    for (int nm = 400; nm <= 700; nm += 10) w.push_back(nm);
    return w;
}

}  // namespace nacre::spectra
