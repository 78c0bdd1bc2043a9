#pragma once

#include <vector>

#include "nacre/spectra/observer.h"

namespace nacre::measure {

/// The colour of spectra at some wavelengths, for formats that hold RGB: linear Rec. 709 under D65
/// for the 2 degree observer (spectra::rec709_weights()), components outside the gamut cut off at
/// zero.
class SpectrumColour {
 public:
    /// @throws DomainError as spectra::rec709_weights()
    explicit SpectrumColour(const std::vector<double>& wavelengths_nm);

    /// @throws DomainError if a value is negative or not finite, or their number is another
    std::vector<double> rgb(const std::vector<double>& values) const;
    /// The Y of that colour; 0 if it were negative.
    double luminance(const std::vector<double>& values) const;

 private:
    spectra::Vec3 sum(const std::vector<double>& values) const;

    std::vector<spectra::Vec3> weights_;
};

}  // namespace nacre::measure
