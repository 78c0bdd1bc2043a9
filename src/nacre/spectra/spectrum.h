#pragma once

#include <vector>

namespace nacre::spectra {

/// A real function of wavelength: linear between its samples, constant beyond the first and the
/// last. A single sample is a constant. Wavelengths in nm, strictly increasing.
class Spectrum {
 public:
    Spectrum(double constant = 0.0);  // NOLINT: a number is a spectrum
    /// @throws DomainError if sizes differ, are zero, wavelengths do not increase or a value is
    /// not finite.
    Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values);

    double operator()(double wavelength_nm) const;

    bool is_constant() const { return values_.size() == 1; }
    double min() const;
    double max() const;
    const std::vector<double>& wavelengths_nm() const { return wavelengths_nm_; }
    const std::vector<double>& values() const { return values_; }

    friend bool operator==(const Spectrum&, const Spectrum&) = default;

 private:
    std::vector<double> wavelengths_nm_;
    std::vector<double> values_;
};

/// The default wavelengths at which a paint is solved and evaluated: 400 to 700 nm by 10.
std::vector<double> default_wavelengths_nm();

}  // namespace nacre::spectra
