#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace nacre::optics {

/// A real function of wavelength, linear between its samples. Wavelengths increase.
struct SampledFunction {
    std::vector<double> wavelengths_nm, values;

    /// Needs at least two samples; beyond the first and last it goes on in a straight line.
    double at(double wavelength_nm) const;
};

/// Samples f on [first_nm, last_nm] so finely that linear interpolation errs by less than `error`,
/// by halving intervals; f is taken to be smooth on the scale of a 64th of the range.
/// @throws DomainError if that takes more than `most` samples; whatever f throws
SampledFunction sample_smooth(const std::function<double(double)>& f, double first_nm,
                              double last_nm, double error, std::size_t most);

}  // namespace nacre::optics
