#pragma once

#include <cstdint>
#include <memory>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/solver/solver.h"

// Only for tests: paints whose sparkle depends on the positions and slopes of the flakes alone.

namespace nacre::models::testing {

/// Grey flakes of one size.
struct PlainFlakes {
    double diameter_um = 20;
    double alpha = 0.1;
    double ior = 1.5;
    double cover = 1;  ///< area of all flakes over that of the panel
    double reflectance = 0.6, transmittance = 0;
};

inline paint::Recipe recipe_of(const PlainFlakes& plain) {
    constexpr double kThickness_um = 10;
    paint::FlakeSpecies flakes;
    flakes.amount = paint::AreaDensity{plain.cover / kThickness_um};
    flakes.diameter_um = plain.diameter_um;
    flakes.orientation.beckmann_alpha = plain.alpha;
    flakes.body = paint::PrescribedFlake{plain.reflectance, plain.transmittance, 0.3};
    paint::Recipe recipe;
    recipe.binder = optics::Material(plain.ior);
    recipe.clearcoat = paint::Clearcoat{30, 0.0, 0};
    recipe.layers = {paint::Layer{kThickness_um, {flakes}, {}}};
    recipe.substrate_reflectance = 0.02;
    return recipe;
}

/// Solved at one wavelength, as nothing depends on it; without the hot spot, for closed forms.
inline std::shared_ptr<const bsdf::Bsdf> nacre_surface(const paint::Recipe& recipe,
                                                       std::uint64_t seed) {
    const auto solved =
        std::make_shared<const solver::SolvedPaint>(solver::solve(recipe, {550}, {}));
    return std::make_shared<const bsdf::Nacre>(
        solved, bsdf::NacreModel{.specimen = seed, .hot_spot = false});
}

}  // namespace nacre::models::testing
