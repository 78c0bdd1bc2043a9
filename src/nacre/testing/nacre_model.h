#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/quadrature.h"
#include "nacre/core/random.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/paints.h"

// Only for tests of single flakes: recipes, models and patches.

namespace nacre::bsdf {

inline paint::FlakeSpecies metal_flake(double diameter_um, double reflectance, double alpha = 0.1) {
    paint::FlakeSpecies flake = test::flakes(0.1, alpha, reflectance);
    flake.diameter_um = diameter_um;
    return flake;
}

inline paint::FlakeSpecies pearl_flake(double diameter_um) {
    paint::FlakeSpecies flake = metal_flake(diameter_um, 0);
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, {}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 110, {20}}};
    flake.body = platelet;
    return flake;
}

inline paint::Recipe paint_of(std::vector<paint::FlakeSpecies> flakes) {
    paint::Recipe recipe;
    recipe.layers.push_back({15, std::move(flakes), {}});
    return recipe;
}

// Two layers, two species, a pigment, an absorbing clearcoat and a bright substrate: every term.
inline paint::Recipe recipe_with_every_feature() {
    paint::Recipe recipe = paint_of({metal_flake(20, 0.6)});
    recipe.layers[0].flakes[0].diameter_spread_um = 6;
    paint::FlakeSpecies pearl = pearl_flake(12);
    pearl.orientation.beckmann_alpha = 0.2;
    recipe.layers.insert(recipe.layers.begin(),
                         paint::Layer{10, {pearl}, {{paint::PigmentCoefficients{20.0, 5.0, 0.5}}}});
    recipe.clearcoat = paint::Clearcoat{40, spectra::Spectrum({400.0, 700.0}, {8.0, 1.0}), 0.0};
    recipe.substrate_reflectance = spectra::Spectrum({400.0, 700.0}, {0.3, 0.8});
    return recipe;
}

struct SparklingModel {
    std::shared_ptr<const solver::SolvedPaint> paint;
    Nacre nacre;
    std::unique_ptr<const BoundBsdf> bound;

    /// @param settings  without the hot spot: flakes are dimmed by the closed form of attenuation
    explicit SparklingModel(const paint::Recipe& recipe,
                            const NacreModel& settings = {.specimen = 1, .hot_spot = false})
        : paint(std::make_shared<const solver::SolvedPaint>(
              solver::solve(recipe, spectra::default_wavelengths_nm()))),
          nacre(paint, settings),
          bound(nacre.bind(kOnGrid)) {}

    /// Of the first species of the first layer.
    double flakes_per_mm2() const {
        const paint::Layer& layer = paint->recipe.layers[0];
        const double radius_mm = 0.5e-3 * layer.flakes[0].diameter_um;
        return layer.flakes[0].area_density_per_um() * layer.thickness_um /
               (std::numbers::pi * radius_mm * radius_mm);
    }
};

inline const SparklingModel& model_with_every_feature() {
    static const SparklingModel model(recipe_with_every_feature());
    return model;
}

/// The same, or under a satin clearcoat.
inline const SparklingModel& model_with_every_feature(bool rough) {
    if (!rough) return model_with_every_feature();
    static const SparklingModel model = [] {
        paint::Recipe recipe = recipe_with_every_feature();
        recipe.clearcoat->roughness = 0.12;
        return SparklingModel(recipe);
    }();
    return model;
}

/// Of the default wavelengths; kOnGrid[3].
inline constexpr int k540 = 14;

/// Of the light from theta, the fraction that leaves at 540 nm, without a specular reflection.
/// @param brdf  as HotSpotBrdf
template <class Brdf>
double albedo_at_540(const Brdf& brdf, double theta, Part part = Part::total) {
    const Quadrature polar = gauss_legendre(48, 0, std::numbers::pi / 2),
                     azimuth = gauss_legendre(48, 0, std::numbers::pi);
    double sum = 0;
    for (std::size_t t = 0; t < polar.nodes.size(); ++t) {
        for (std::size_t p = 0; p < azimuth.nodes.size(); ++p) {
            sum += 2 * azimuth.weights[p] * polar.weights[t] * std::sin(polar.nodes[t]) *
                   std::cos(polar.nodes[t]) *
                   brdf(theta, polar.nodes[t], azimuth.nodes[p], part)[k540];
        }
    }
    return sum;
}

/// A rotated square of this side on a plane normal to one of the axes, at a random position within
/// 2 m.
inline Patch random_square_patch(Rng& rng, double side_mm) {
    const auto anywhere = [&] { return 2000 * rng.uniform_float() - 1000; };
    const int axis = static_cast<int>(3 * rng.uniform_float());
    const float sign = rng.uniform_float() < 0.5f ? -1.0f : 1.0f;
    const Vec3f n = {axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
    const Frame frame = Frame::around(n);
    const float turn = 2 * std::numbers::pi_v<float> * rng.uniform_float();
    const float c = static_cast<float>(side_mm) * std::cos(turn);
    const float d = static_cast<float>(side_mm) * std::sin(turn);
    Patch patch;
    patch.footprint = {{anywhere(), anywhere(), anywhere()},
                       n,
                       frame.s,
                       {c * frame.s + d * frame.t, c * frame.t - d * frame.s}};
    return patch;
}

}  // namespace nacre::bsdf
