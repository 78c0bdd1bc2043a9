#pragma once

#include <numbers>

#include "nacre/montecarlo/discs/disc_scene.h"
#include "nacre/testing/montecarlo.h"

namespace nacre::montecarlo::test {

/// One layer of opaque flakes of one size, under 50 um of clearcoat, so that draw_discs() moves no
/// flake.
inline paint::Recipe opaque(double depth, double thickness_um, double diameter_um,
                            double alpha = 0.1, double reflectance = 0.6) {
    paint::Layer layer = flake_layer(depth, alpha, reflectance, 0);
    layer.thickness_um = thickness_um;
    layer.flakes[0].amount = paint::AreaDensity{depth / thickness_um};
    layer.flakes[0].diameter_um = diameter_um;
    layer.flakes[0].diameter_spread_um = 0;
    paint::Recipe recipe = paint_of(1.5, {layer});
    recipe.clearcoat.emplace();
    recipe.clearcoat->thickness_um = 50;
    return recipe;
}

inline double degrees(double d) { return d * std::numbers::pi / 180; }

}  // namespace nacre::montecarlo::test
