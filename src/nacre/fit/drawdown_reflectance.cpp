#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/fit/drawdown.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/solver.h"

// What instruments read on paints whose composition is known, and on bare grounds.

namespace nacre::fit {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSphere_rad = 8 * kPi / 180;
constexpr double kLamp_rad = 45 * kPi / 180;
/// Nodes over the polar angle, and over half a turn: the error of a hemispherical reflectance is
/// below 1e-6 (a test compares with twice as many).
constexpr int kPolarNodes = 24;
constexpr int kAzimuths = 8;

double surface_reflectance(double ior, double theta) {
    return optics::fresnel_dielectric(ior, std::cos(theta));
}

/// Fraction of diffuse light inside the binder that its surface sends back: Int R(mu) 2 mu dmu.
double internal_reflectance(double ior) {
    const double critical = ior > 1 ? std::sqrt(1 - 1 / (ior * ior)) : 0.0;
    // Beyond the critical angle all of it; up to there an integral in the angle outside, where it
    // is smooth: mu_i dmu_i = mu_o dmu_o / n^2.
    const Quadrature rule = gauss_legendre(64, 0, kPi / 2);
    double sum = critical * critical;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double theta = rule.nodes[k];
        sum += rule.weights[k] * 2 * std::sin(theta) * std::cos(theta) *
               surface_reflectance(ior, theta) / (ior * ior);
    }
    return sum;
}

/// Whether all that scatters does so alike in all directions.
bool scatters_isotropically(const paint::Recipe& recipe) {
    return std::all_of(recipe.layers.begin(), recipe.layers.end(), [](const paint::Layer& layer) {
        return layer.flakes.empty() &&
               std::all_of(layer.pigments.begin(), layer.pigments.end(), [](const auto& pigment) {
                   const auto given = pigment.layer_coefficients();
                   return given && given->anisotropy == 0;
               });
    });
}

/// Of a Lambertian ground of reflectance R under a smooth surface an instrument reads
/// gloss + gain R / (1 - back R).
struct SurfaceOverGround {
    double gloss, gain, back;

    SurfaceOverGround(double ior, DrawdownGeometry geometry) : back(internal_reflectance(ior)) {
        const double lamp = geometry == DrawdownGeometry::angle_45_0 ? kLamp_rad : kSphere_rad;
        const double in = 1 - surface_reflectance(ior, lamp);
        gloss = geometry == DrawdownGeometry::diffuse_8_included ? 1 - in : 0;
        gain = geometry == DrawdownGeometry::angle_45_0
                   ? in * (1 - surface_reflectance(ior, 0)) / (ior * ior)
                   : in * (1 - back);
    }
    double inside(double measured) const {
        const double x = (measured - gloss) / gain;
        return x / (1 + back * x);
    }
};

}  // namespace

std::vector<double> ground_inside(const std::vector<double>& measured,
                                  const std::vector<double>& wavelengths_nm,
                                  const optics::Material& binder, DrawdownGeometry geometry) {
    std::vector<double> inside;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const SurfaceOverGround surface(binder.index(wavelengths_nm[i]).real(), geometry);
        const double value = surface.inside(measured[i]);
        // A glossy black below the gloss of its own surface by less than an instrument's error is
        // black.
        constexpr double kInstrumentError = 0.01;
        if (value < -kInstrumentError || value > 1 + kInstrumentError) {
            throw DomainError(fmt::format(
                "reflectance = {} of the bare ground at {} nm: under a surface of the binder's "
                "index {:.4g} it would take a ground of {:.4g}, which must be in [0, 1]; was the "
                "ground read without a surface (matt), or by another geometry?",
                measured[i], wavelengths_nm[i], binder.index(wavelengths_nm[i]).real(), value));
        }
        inside.push_back(std::clamp(value, 0.0, 1.0));
    }
    return inside;
}

std::vector<double> drawdown_reflectance(const paint::Recipe& recipe,
                                         const std::vector<double>& wavelengths_nm,
                                         DrawdownGeometry geometry, const Progress& progress) {
    // Seen along the normal, or from all sides, only the mean over azimuth shows: the first of the
    // solver's orders. Light that was scattered once has a closed form.
    solver::SolverSettings mean_over_azimuth;
    mean_over_azimuth.max_orders = 1;
    const solver::SolvedPaint paint =
        solver::solve(recipe, wavelengths_nm, mean_over_azimuth, nullptr, progress);
    std::vector<double> factor(wavelengths_nm.size(), 0.0);
    if (geometry == DrawdownGeometry::angle_45_0) {
        factor = paint.brdf(kLamp_rad, 0, kPi);
        for (double& value : factor) value *= kPi;
        return factor;
    }
    // What a lamp at 8 deg sends into all directions: by reciprocity what a sphere sends to 8 deg.
    static const Quadrature rule = gauss_legendre(kPolarNodes, 0, kPi / 2);
    const int azimuths = scatters_isotropically(recipe) ? 1 : kAzimuths;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double theta = rule.nodes[k];
        const double weight =
            rule.weights[k] * 2 * kPi * std::sin(theta) * std::cos(theta) / azimuths;
        for (int j = 0; j < azimuths; ++j) {
            const std::vector<double> f =
                paint.brdf(kSphere_rad, theta, kPi * (j + 0.5) / azimuths);
            for (std::size_t i = 0; i < factor.size(); ++i) factor[i] += weight * f[i];
        }
    }
    if (geometry == DrawdownGeometry::diffuse_8_included) {
        for (std::size_t i = 0; i < factor.size(); ++i) {
            factor[i] +=
                surface_reflectance(recipe.binder.index(wavelengths_nm[i]).real(), kSphere_rad);
        }
    }
    return factor;
}

}  // namespace nacre::fit
