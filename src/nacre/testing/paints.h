#pragma once

#include <utility>
#include <vector>

#include "nacre/optics/material.h"
#include "nacre/paint/recipe.h"

// Only for tests: paints written short.

namespace nacre::test {

/// Flakes that reflect and pass the given fractions at all angles.
inline paint::FlakeSpecies flakes(double area_density_per_um, double alpha,
                                  const spectra::Spectrum& reflectance,
                                  const spectra::Spectrum& transmittance = 0.0) {
    paint::FlakeSpecies species;
    species.name = "flakes";
    species.amount = paint::AreaDensity{area_density_per_um};
    species.orientation.beckmann_alpha = alpha;
    species.body = paint::PrescribedFlake{reflectance, transmittance, 0.3};
    return species;
}

/// Flakes of area density times thickness `beta`, in a layer of 10 um.
inline paint::Layer flake_layer(double beta, double alpha, const spectra::Spectrum& reflectance,
                                const spectra::Spectrum& transmittance) {
    return {10, {flakes(beta / 10, alpha, reflectance, transmittance)}, {}};
}

/// Optical depth `depth` of scattering albedo `albedo` in a layer of 100 um.
inline paint::Layer pigment_layer(double albedo, double depth, double anisotropy) {
    constexpr double kThickness_mm = 0.1;
    return {1e3 * kThickness_mm,
            {},
            {{paint::PigmentCoefficients{albedo * depth / kThickness_mm,
                                         (1 - albedo) * depth / kThickness_mm, anisotropy}}}};
}

inline paint::Recipe paint_of(double ior, std::vector<paint::Layer> layers,
                              const spectra::Spectrum& substrate_reflectance = 0.0) {
    paint::Recipe recipe;
    recipe.name = "test paint";
    recipe.binder = optics::Material(ior);
    recipe.layers = std::move(layers);
    recipe.substrate_reflectance = substrate_reflectance;
    return recipe;
}

/// Flakes of c = 0.1 per um in one layer over black: two deep.
inline paint::Recipe metallic(double alpha, const spectra::Spectrum& reflectance) {
    return paint_of(1.5, {{20, {flakes(0.1, alpha, reflectance)}, {}}});
}

/// The worked case of the design: n = 1.5, c = 0.1 per um, alpha = 0.1, R = 0.6, T = 0, H = 15 um,
/// nothing below.
inline paint::Recipe worked_paint() { return paint_of(1.5, {{15, {flakes(0.1, 0.1, 0.6)}, {}}}); }

/// The first parameter set of the comparison of 2022: P_inc = 570 nm.    [mir-2022]
inline paint::Recipe violet(double alpha = 0.07,
                            paint::FacetDistribution law = paint::FacetDistribution::beckmann) {
    paint::Recipe recipe;
    recipe.microfacet = paint::Microfacet{alpha, law, 1.8, 158.333, 1.08, 0.51, {}};
    return recipe;
}

/// One of everything that a recipe may have.
inline paint::Recipe full_recipe() {
    using namespace paint;
    Recipe recipe;
    recipe.binder = optics::Material(1.5);
    recipe.clearcoat = Clearcoat{40, spectra::Spectrum({400, 700}, {2.0, 8.0}), 0.1,
                                 OrangePeel{0.001, 0.002, 0.003, 0.004, 0.005}, 0.25};
    FlakeSpecies pearl;
    pearl.amount = VolumeFraction{0.05};
    pearl.body =
        optics::Platelet{{optics::Material(1.58), 500, {30}}, {{optics::Material(2.5), 80, {5}}}};
    FlakeSpecies mirror;
    mirror.amount = AreaDensity{0.1};
    mirror.body = PrescribedFlake{0.6, 0.2, 0.3};
    mirror.orientation.alpha_bottom = 0.15;
    mirror.edge_um = 0.05;
    mirror.waviness = 0.05;
    const PigmentParticles white{
        PigmentVolume{0.1}, {optics::Material(2.7), 250, 0.2, optics::DiameterWeighting::volume}};
    const PigmentParticles black{PigmentMass{0.2, 1.8},
                                 {optics::Material(optics::ComplexIndex(1.7, 0.6)), 20, 0.1}};
    recipe.layers = {{15,
                      {pearl, mirror},
                      {{PigmentCoefficients{20.0, 5.0, 0.3}, "dye"},
                       {white},
                       {black, "black"},
                       {PigmentCoefficients{300.0, 800.0, 0.1, PigmentVolume{0.02}}},
                       {PigmentKubelkaMunk{{12.0, 30.0}, 0.2, PigmentMass{0.05, 1.6, 1.2}}}}},
                     {10, {}, {}}};
    recipe.substrate_reflectance = 0.2;
    recipe.microfacet = Microfacet{};
    recipe.microfacet->facets = MicrofacetFacets{1e6, 3, 10};
    recipe.lean = FlakeLean{4, 30};
    return recipe;
}

}  // namespace nacre::test
