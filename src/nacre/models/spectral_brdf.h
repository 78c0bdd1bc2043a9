#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"

namespace nacre::models {

/// A surface at any number of wavelengths, eight by eight: for plots and tables rather than for
/// rendering.
class SpectralBrdf {
 public:
    /// @param wavelengths_nm  at least one
    SpectralBrdf(const bsdf::Bsdf& surface, std::vector<double> wavelengths_nm);

    const std::vector<double>& wavelengths_nm() const { return wavelengths_nm_; }
    /// The BRDF in 1/sr at each wavelength, without the specular lobe of a smooth interface; angles
    /// in rad, phi = phi_o - phi_i, pi being the mirror side. Of one patch where one is given, else
    /// the mean over the surface.
    std::vector<double> operator()(double theta_i, double theta_o, double phi,
                                   const std::optional<bsdf::Patch>& patch = {}) const;

 private:
    std::vector<double> wavelengths_nm_;
    std::vector<std::unique_ptr<const bsdf::BoundBsdf>> bound_;
};

}  // namespace nacre::models
