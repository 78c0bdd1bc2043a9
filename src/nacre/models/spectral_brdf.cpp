#include "nacre/models/spectral_brdf.h"

#include <algorithm>
#include <cmath>

#include "nacre/bsdf/leaning_flakes.h"
#include "nacre/core/parallel.h"

namespace nacre::models {

SpectralBrdf::SpectralBrdf(const bsdf::Bsdf& surface, std::vector<double> wavelengths_nm)
    : wavelengths_nm_(std::move(wavelengths_nm)) {
    bound_.resize((wavelengths_nm_.size() + kLanes - 1) / kLanes);
    parallel_for(0, bound_.size(), [&](std::size_t block) {
        bsdf::Wavelengths eight;
        for (int i = 0; i < kLanes; ++i) {
            eight[i] = wavelengths_nm_[std::min(block * kLanes + i, wavelengths_nm_.size() - 1)];
        }
        bound_[block] = bsdf::bind_with_lean(surface, eight);
    });
}

std::vector<double> SpectralBrdf::operator()(double theta_i, double theta_o, double phi,
                                             const std::optional<bsdf::Patch>& patch) const {
    const auto direction = [](double theta, double azimuth) {
        return Vec3f{static_cast<float>(std::sin(theta) * std::cos(azimuth)),
                     static_cast<float>(std::sin(theta) * std::sin(azimuth)),
                     static_cast<float>(std::cos(theta))};
    };
    const Vec3f wi = direction(theta_i, 0), wo = direction(theta_o, phi);
    std::vector<double> values;
    values.reserve(wavelengths_nm_.size());
    for (const auto& bound : bound_) {
        const FloatLanes f = patch ? bound->evaluate_on(*patch, wi, wo).f : bound->eval(wi, wo);
        for (int i = 0; i < kLanes && values.size() < wavelengths_nm_.size(); ++i) {
            values.push_back(f[i]);
        }
    }
    return values;
}

}  // namespace nacre::models
