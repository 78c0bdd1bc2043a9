#include "nacre/measure/colour_of_brdf.h"

#include <algorithm>

#include "nacre/core/error.h"
#include "nacre/core/range.h"
#include "nacre/spectra/rgb.h"
#include "nacre/spectra/rgb_basis.h"

namespace nacre::measure {

SpectrumColour::SpectrumColour(const std::vector<double>& wavelengths_nm)
    : weights_(spectra::rec709_weights(wavelengths_nm)) {}

spectra::Vec3 SpectrumColour::sum(const std::vector<double>& values) const {
    if (values.size() != weights_.size()) {
        throw DomainError(fmt::format("a BRDF gives {} values at {} wavelengths", values.size(),
                                      weights_.size()));
    }
    // As much as files in single precision take.
    constexpr Range kValue{0, 1e30, "1/sr"};
    spectra::Vec3 rgb{};
    for (std::size_t w = 0; w < values.size(); ++w) {
        if (!kValue.contains(values[w])) {
            throw DomainError(
                fmt::format("a BRDF gives {}: must be a number in {}", values[w], kValue.text()));
        }
        for (int c = 0; c < 3; ++c) rgb[c] += weights_[w][c] * values[w];
    }
    return rgb;
}

std::vector<double> SpectrumColour::rgb(const std::vector<double>& values) const {
    const spectra::Vec3 rgb = sum(values);
    return {std::max(0.0, rgb[0]), std::max(0.0, rgb[1]), std::max(0.0, rgb[2])};
}

double SpectrumColour::luminance(const std::vector<double>& values) const {
    return std::max(0.0, spectra::linear_rec709_to_xyz(sum(values))[1]);
}

}  // namespace nacre::measure
