#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/measure/instrument.h"

// Only for tests: BRDFs in closed form.

namespace nacre::measure::testing {

/// Wavelengths of the tables, and eight at and between them at which they are read.
inline const std::vector<double> kThree = {450, 550, 650};
inline constexpr bsdf::Wavelengths kLanesAt = {450, 450, 500, 550, 550, 600, 650, 650};

inline Brdf lambertian(std::vector<double> reflectance) {
    return [reflectance](double, double, double) {
        std::vector<double> f = reflectance;
        for (double& x : f) x /= std::numbers::pi;
        return f;
    };
}

/// Microfacets of the GGX distribution with Smith's uncorrelated masking; `reflectance` in the
/// place of Fresnel's.                                     [walter-2007, eq. 20, 33 and 34]
inline Brdf ggx(double alpha, std::vector<double> reflectance) {
    return [alpha, reflectance](double theta_i, double theta_o, double phi) {
        const double si = std::sin(theta_i), ci = std::cos(theta_i), so = std::sin(theta_o),
                     co = std::cos(theta_o);
        const double x = si + so * std::cos(phi), y = so * std::sin(phi), z = ci + co;
        const double tan2 = (x * x + y * y) / (z * z), cos2 = 1 / (1 + tan2);
        const double a2 = alpha * alpha, pi = std::numbers::pi;
        const double d = a2 / (pi * cos2 * cos2 * (a2 + tan2) * (a2 + tan2));
        const auto masking = [&](double c, double s) {
            return 2 / (1 + std::sqrt(1 + a2 * s * s / (c * c)));
        };
        const double f = d * masking(ci, si) * masking(co, so) / (4 * ci * co);
        std::vector<double> values;
        for (const double r : reflectance) values.push_back(r * f);
        return values;
    };
}

}  // namespace nacre::measure::testing
