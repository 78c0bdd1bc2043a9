#pragma once

#include "nacre/fit/fit.h"
#include "nacre/measure/instrument.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

// Only for tests: paints that solve fast, and readings of them by a virtual instrument.

namespace nacre::fit::testing {

/// A pearl of wide orientation (alpha = 0.25), which needs few nodes.
inline paint::Recipe pearl(double film_nm = 80) {
    paint::FlakeSpecies flakes;
    flakes.amount = paint::VolumeFraction{0.05};
    flakes.orientation.beckmann_alpha = 0.25;
    flakes.body = optics::Platelet{{optics::Material(1.58), 500, {80}},
                                   {{optics::Material(2.4), film_nm, {6}}}};
    paint::Recipe recipe;
    recipe.name = "pearl";
    recipe.layers = {{15, {flakes}, {}}};
    recipe.substrate_reflectance = 0.05;
    return recipe;
}

/// Red pigment over a grey substrate.
inline paint::Recipe solid() {
    paint::Recipe recipe;
    recipe.name = "solid";
    recipe.layers = {{30,
                      {},
                      {{paint::PigmentCoefficients{
                          100.0, spectra::Spectrum({400, 550, 600, 700}, {60, 60, 4, 2}), 0}}}}};
    recipe.substrate_reflectance = 0.3;
    return recipe;
}

inline const std::vector<measure::Geometry>& six_angles() {
    return measure::find_geometry_set("byk-mac")->geometries;
}

inline measure::Measurement read(const paint::Recipe& recipe,
                                 const std::vector<measure::Geometry>& geometries = six_angles(),
                                 const measure::Conditions& conditions = {}) {
    const solver::SolvedPaint paint = solver::solve(recipe, spectra::default_wavelengths_nm());
    return measure::measure(
        recipe.name,
        [&](double theta_i, double theta_o, double phi) {
            return paint.brdf(theta_i, theta_o, phi);
        },
        paint.wavelengths_nm(), geometries, conditions);
}

/// The readings of an instrument that reports XYZ and L*a*b* only.
inline measure::Measurement without_spectra(measure::Measurement measurement) {
    measurement.wavelengths_nm.clear();
    for (measure::Reading& reading : measurement.readings) reading.reflectance_factor.clear();
    return measurement;
}

}  // namespace nacre::fit::testing
