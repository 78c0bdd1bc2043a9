#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "nacre/reference/reference.h"

// What the tests of this folder share: paints written short, and the z-score.

namespace nacre::reference::test {

/// (estimate - expected) in standard errors; the expected value's own error adds in quadrature.
/// Standard normal if the walk is right.
inline double z_score(const Estimate& estimate, double expected, double expected_error = 0) {
    return (estimate.mean - expected) / std::hypot(estimate.standard_error, expected_error);
}
inline double z_score(const Estimate& a, const Estimate& b) {
    return z_score(a, b.mean, b.standard_error);
}

/// A right walk exceeds this in one of 30000 values; seeds are fixed, so a test that passes once
/// passes always, and the bound says how likely it was to be kept although the walk is wrong.
inline constexpr double kWorstZ = 4.2;

inline layers::FlakeSpecies flakes(double area_density_per_um, double alpha,
                                   const spectra::Spectrum& reflectance,
                                   const spectra::Spectrum& transmittance) {
    layers::FlakeSpecies species;
    species.name = "flakes";
    species.amount = layers::AreaDensity{area_density_per_um};
    species.orientation.beckmann_alpha = alpha;
    species.body = layers::PrescribedFlake{reflectance, transmittance, 0.3};
    return species;
}

/// Optical depth `depth` of scattering albedo `albedo` in a layer of 100 um.
inline layers::Layer pigment_layer(double albedo, double depth, double anisotropy) {
    constexpr double kThickness_mm = 0.1;
    layers::Layer layer;
    layer.thickness_um = 1e3 * kThickness_mm;
    layer.pigments.push_back(
        {albedo * depth / kThickness_mm, (1 - albedo) * depth / kThickness_mm, anisotropy});
    return layer;
}

/// Flakes of area density times thickness `beta`, in a layer of 10 um.
inline layers::Layer flake_layer(double beta, double alpha, double reflectance,
                                 double transmittance) {
    layers::Layer layer;
    layer.thickness_um = 10;
    layer.flakes.push_back(flakes(beta / 10, alpha, reflectance, transmittance));
    return layer;
}

inline layers::Recipe paint(double index, std::vector<layers::Layer> layers,
                            double substrate_reflectance = 0) {
    layers::Recipe recipe;
    recipe.name = "test paint";
    recipe.binder = optics::Material(index);
    recipe.layers = std::move(layers);
    recipe.substrate_reflectance = substrate_reflectance;
    return recipe;
}

/// The worked case of the design: n = 1.5, c = 0.1 per um, alpha = 0.1, R = 0.6, T = 0, H = 15 um,
/// nothing below.
inline layers::Recipe worked_paint() {
    layers::Layer layer;
    layer.thickness_um = 15;
    layer.flakes.push_back(flakes(.1, .1, .6, 0));
    return paint(1.5, {layer});
}

inline const std::vector<double> kGreen{550};

inline std::vector<Estimate> brdf(const layers::Recipe& recipe, const Direction& incident,
                                  const std::vector<Direction>& outgoing,
                                  const ReferenceSettings& settings) {
    return reference_brdf(recipe, std::vector{incident}, outgoing, kGreen, settings);
}

inline double degrees_of_cosine(double cosine) {
    return std::acos(cosine) * 180 / std::numbers::pi;
}

}  // namespace nacre::reference::test
